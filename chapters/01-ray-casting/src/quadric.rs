//! Quadrics: implicit surfaces of second degree, from the ellipsoid to both hyperboloids.

use common::{Interval, Vec3};
use glam::{Mat4, Vec4};

use crate::{aabb::Aabb, frame::Frame, hit::Hit, implicit::Implicit, quadratic, ray::Ray, shape::Shape};

// ANCHOR: quadric
/// The points `r` with `[r, 1] Q [r, 1]ᵀ = 0` inside a box, in a frame of its own.
///
/// The shapes below stand along the local y axis and are open where the box cuts them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadric {
    /// The symmetric matrix `Q`.
    q: Mat4,
    /// Only what lies inside this box is there, in local coordinates.
    clip: Aabb,
    /// Where it stands.
    frame: Frame,
}
// ANCHOR_END: quadric

impl Quadric {
    /// A quadric by its matrix. Only the symmetric part of `q` matters, and only that is kept.
    #[must_use]
    pub fn new(q: Mat4, clip: Aabb) -> Self {
        Self { q: (q + q.transpose()) * 0.5, clip, frame: Frame::at(Vec3::ZERO) }
    }

    /// The same quadric standing in `frame`.
    #[must_use]
    pub fn placed(self, frame: Frame) -> Self {
        Self { frame, ..self }
    }

    // ANCHOR: upright
    /// `A x² + B y² + C z² + 2 D y + E = 0` between two heights: all the shapes below.
    fn upright([a, b, c]: [f32; 3], d: f32, e: f32, [bottom, top]: [f32; 2]) -> Self {
        let q = Mat4::from_cols(
            Vec4::new(a, 0.0, 0.0, 0.0),
            Vec4::new(0.0, b, 0.0, d),
            Vec4::new(0.0, 0.0, c, 0.0),
            Vec4::new(0.0, d, 0.0, e),
        );
        let Aabb { min, max } = Aabb::EVERYTHING;
        Self::new(q, Aabb { min: min.with_y(bottom), max: max.with_y(top) })
    }
    // ANCHOR_END: upright

    // ANCHOR: gallery
    /// `x²/a² + y²/b² + z²/c² = 1`: an ellipsoid with the three given radii around the origin.
    #[must_use]
    pub fn ellipsoid(radii: Vec3) -> Self {
        let factors = (radii * radii).recip().to_array();
        Self::upright(factors, 0.0, -1.0, [f32::NEG_INFINITY, f32::INFINITY])
    }

    /// `x² + z² = r²`: a tube from the ground up to `height`.
    #[must_use]
    pub fn cylinder(radius: f32, height: f32) -> Self {
        Self::upright([1.0, 0.0, 1.0], 0.0, -radius * radius, [0.0, height])
    }

    /// `x² + z² = (r/h)² (h − y)²`: a cone with `radius` on the ground and its tip at `height`.
    #[must_use]
    pub fn cone(radius: f32, height: f32) -> Self {
        let slope2 = (radius / height) * (radius / height);
        Self::upright([1.0, -slope2, 1.0], slope2 * height, -radius * radius, [0.0, height])
    }

    /// `x² + z² = r²·y/h`: a bowl with its lowest point on the ground and `radius` at its rim.
    #[must_use]
    pub fn paraboloid(radius: f32, height: f32) -> Self {
        Self::upright([1.0, 0.0, 1.0], -radius * radius / (2.0 * height), 0.0, [0.0, height])
    }

    /// `(x² + z²)/a² − y²/c² = 1`: one sheet, like a cooling tower with its waist in the middle.
    #[must_use]
    pub fn hyperboloid_of_one_sheet(waist: f32, c: f32, half_height: f32) -> Self {
        let across = 1.0 / (waist * waist);
        Self::upright([across, -1.0 / (c * c), across], 0.0, -1.0, [-half_height, half_height])
    }

    /// `(x² + z²)/a² − y²/c² = −1`: two sheets, one bowl facing up and one facing down, `2c` apart.
    #[must_use]
    pub fn hyperboloid_of_two_sheets(a: f32, c: f32, half_height: f32) -> Self {
        let across = 1.0 / (a * a);
        Self::upright([across, -1.0 / (c * c), across], 0.0, 1.0, [-half_height, half_height])
    }
    // ANCHOR_END: gallery
}

// ANCHOR: function
impl Implicit for Quadric {
    /// `[r, 1] Q [r, 1]ᵀ`, in local coordinates.
    fn value(&self, r: Vec3) -> f32 {
        let r = r.extend(1.0);
        r.dot(self.q * r)
    }

    /// Twice the first three numbers of `Q [r, 1]ᵀ`, in local coordinates.
    fn gradient(&self, r: Vec3) -> Vec3 {
        2.0 * (self.q * r.extend(1.0)).truncate()
    }
}
// ANCHOR_END: function

impl Quadric {
    /// A length whose rounding is as great as the error in the place of the surface near `r`: the sum of the function's
    /// terms without their signs, divided by its slope.
    ///
    /// In the tip of a cone there is no slope. Two roots meet there, and half of their digits are left.
    fn magnitude(&self, r: Vec3) -> f32 {
        let point = r.abs().extend(1.0);
        let terms = point.dot(self.q.abs() * point);
        (terms / self.gradient(r).length()).min(r.length() / f32::EPSILON.sqrt())
    }
}

// ANCHOR: intersect
impl Shape for Quadric {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let local = Ray::new(self.frame.point_to_local(ray.origin), self.frame.vector_to_local(ray.direction));
        // Start where the ray comes nearest to the local origin: small numbers keep their digits.
        let shift = -local.origin.dot(local.direction) / local.direction.dot(local.direction);
        let (s, d) = (local.at(shift).extend(1.0), local.direction.extend(0.0));
        let (qs, qd) = (self.q * s, self.q * d);
        let (a, h, c) = (d.dot(qd), s.dot(qd), s.dot(qs));
        // The nearer root may be cut away by the box and the farther one still be there.
        let [first, second] = quadratic::solve(a, h, c, h * h - a * c).0;
        [first, second].into_iter().find_map(|u| {
            let (t, r) = (u + shift, (s + d * u).truncate());
            let visible = range.contains(t) && self.clip.contains(r);
            visible.then(|| {
                let outward = self.frame.vector_to_world(self.gradient(r));
                let hit = Hit::new(ray, t, outward).among(self.frame.point_to_world(Vec3::ZERO));
                hit.among(Vec3::splat(self.magnitude(r)))
            })
        })
    }
}
// ANCHOR_END: intersect
