//! The hit: what is known about the place where a ray meets a surface.

use common::Vec3;

use crate::ray::Ray;

// ANCHOR: hit
/// Where and how a ray meets a surface. A miss is `None`, never a special hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Ray parameter, in lengths of the ray's direction.
    pub t: f32,
    /// The point itself.
    pub position: Vec3,
    /// Unit normal of the surface itself, turned to face the ray.
    pub geometric_normal: Vec3,
    /// Unit normal to compute brightness with, turned along with the other.
    pub shading_normal: Vec3,
    /// Which side of the surface the ray met.
    pub side: Side,
    /// The greatest number that went into `position`, in scene units: its rounding error is in proportion to this.
    pub magnitude: f32,
}

/// The two sides of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The side that the outward normal points to.
    Outside,
    /// The other side.
    Inside,
}
// ANCHOR_END: hit

impl Hit {
    // ANCHOR: new
    /// A hit at `t`, where the surface's outward normal has the direction of `outward` (of any length).
    ///
    /// Where there is no normal, as in the tip of a cone, the hit faces the ray.
    #[must_use]
    #[inline]
    pub fn new(ray: &Ray, t: f32, outward: Vec3) -> Self {
        // Note the side first: once the normal is turned, nobody can tell.
        let side = if outward.dot(ray.direction) > 0.0 { Side::Inside } else { Side::Outside };
        let outward = outward.try_normalize().unwrap_or_else(|| -ray.direction.normalize());
        // Turn the normal to face the ray.
        let normal = if side == Side::Inside { -outward } else { outward };
        let magnitude = ray.origin.abs().max((ray.direction * t).abs()).max_element();
        Self { t, position: ray.at(t), geometric_normal: normal, shading_normal: normal, side, magnitude }
    }
    // ANCHOR_END: new

    // ANCHOR: among
    /// The same hit, computed with the coordinates of `point` too: the center of a sphere, the corner of a triangle.
    #[must_use]
    #[inline]
    pub fn among(self, point: Vec3) -> Self {
        Self { magnitude: self.magnitude.max(point.abs().max_element()), ..self }
    }
    // ANCHOR_END: among

    // ANCHOR: shading
    /// The same hit with another outward normal for shading (of any length), turned like the geometric one.
    ///
    /// Without a direction, the shading normal stays as it is.
    #[must_use]
    #[inline]
    pub fn shaded_with(self, outward: Vec3) -> Self {
        let Some(outward) = outward.try_normalize() else { return self };
        let shading_normal = if self.side == Side::Inside { -outward } else { outward };
        Self { shading_normal, ..self }
    }
    // ANCHOR_END: shading
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_normal_faces_the_ray_and_the_side_is_remembered() {
        let down = Ray::new(Vec3::Y, -Vec3::Y);
        let outside = Hit::new(&down, 1.0, Vec3::Y * 3.0);
        let inside = Hit::new(&down, 1.0, -Vec3::Y * 0.1);
        assert_eq!((outside.geometric_normal, outside.side), (Vec3::Y, Side::Outside));
        assert_eq!((inside.geometric_normal, inside.side), (Vec3::Y, Side::Inside));
        assert_eq!(outside.position, Vec3::ZERO);
    }

    #[test]
    fn the_shading_normal_turns_with_the_geometric_one() {
        let down = Ray::new(Vec3::Y, -Vec3::Y);
        let leaning = Vec3::new(0.6, 0.8, 0.0);
        assert_eq!(Hit::new(&down, 1.0, Vec3::Y).shaded_with(leaning * 2.0).shading_normal, leaning);
        assert_eq!(Hit::new(&down, 1.0, -Vec3::Y).shaded_with(-leaning).shading_normal, leaning);
        assert_eq!(Hit::new(&down, 1.0, Vec3::Y).shaded_with(Vec3::ZERO).shading_normal, Vec3::Y);
    }

    #[test]
    fn a_surface_without_normal_faces_the_ray() {
        let hit = Hit::new(&Ray::new(Vec3::X * 2.0, -Vec3::X * 5.0), 0.4, Vec3::ZERO);
        assert_eq!(hit.geometric_normal, Vec3::X);
    }
}
