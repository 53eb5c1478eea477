//! The slab test: where a ray enters an axis-aligned box, and where it leaves.
//!
//! Source: Kay, Kajiya, *Ray Tracing Complex Scenes*, SIGGRAPH 1986.

use common::{Interval, Vec3};
use ray_casting::{aabb::Aabb, ray::Ray};

use crate::rounding::{SLACK, greater, lesser};

// ANCHOR: slabs
/// A ray, ready to meet planes at right angles to the axes: nothing has to be divided any more.
#[derive(Clone, Copy, Debug)]
pub struct Slabs {
    /// Where the ray starts.
    pub origin: Vec3,
    /// One over each component of the direction; ±∞ where that is zero.
    pub inverse: Vec3,
}

impl Slabs {
    /// Prepare a ray.
    #[must_use]
    pub fn of(ray: &Ray) -> Self {
        Self { origin: ray.origin, inverse: ray.direction.recip() }
    }

    /// The ray parameter at which the ray meets the plane `axis = position`.
    ///
    /// It is infinite for a ray along the plane, and no number for a ray inside of it.
    #[inline]
    #[must_use]
    pub fn plane(&self, axis: usize, position: f32) -> f32 {
        (position - self.origin[axis]) * self.inverse[axis]
    }
}
// ANCHOR_END: slabs

// ANCHOR: hair
impl Slabs {
    /// How far beside its place the ray may see a thing in a box: more than all roundings together.
    #[inline]
    #[must_use]
    pub fn hair(&self, aabb: &Aabb) -> f32 {
        let farthest = (aabb.min - self.origin).abs().max((aabb.max - self.origin).abs());
        farthest.max_element() * SLACK
    }

    /// The ray parameters at which the ray meets the plane `axis = position` at the earliest and at the latest, if the
    /// plane is as thick as two hairs. A ray that stays inside of it meets it from −∞ to ∞.
    #[inline]
    #[must_use]
    pub fn meets(&self, axis: usize, position: f32, hair: f32) -> [f32; 2] {
        let distance = position - self.origin[axis];
        let hair = hair.copysign(self.inverse[axis]);
        [(distance - hair) * self.inverse[axis], (distance + hair) * self.inverse[axis]]
    }
}
// ANCHOR_END: hair

// ANCHOR: cross
impl Slabs {
    /// The part of `range` in which the ray is inside the box; `None` if it misses the box.
    ///
    /// The faces belong to the box, and a hair around it. A ray inside of a face and a box without thickness are hit.
    #[inline]
    #[must_use]
    pub fn cross(&self, aabb: &Aabb, range: Interval) -> Option<Interval> {
        let hair = self.hair(aabb);
        let Interval { min: mut enter, max: mut leave } = range;
        for axis in 0..3 {
            // The ray enters the slab through the face that it comes to first.
            let (low, high) = (aabb.min[axis], aabb.max[axis]);
            let (first, last) = if self.inverse[axis] < 0.0 { (high, low) } else { (low, high) };
            let ([earliest, _], [_, latest]) = (self.meets(axis, first, hair), self.meets(axis, last, hair));
            // 0 · ∞ is no number and does not count.
            enter = greater(earliest, enter);
            leave = lesser(latest, leave);
        }
        (enter <= leave).then_some(Interval::new(enter, leave))
    }
}
// ANCHOR_END: cross

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Aabb = Aabb { min: Vec3::ZERO, max: Vec3::ONE };

    fn crosses(origin: [f32; 3], direction: [f32; 3], aabb: &Aabb) -> bool {
        let ray = Ray::new(origin.into(), direction.into());
        Slabs::of(&ray).cross(aabb, Interval::POSITIVE).is_some()
    }

    #[test]
    fn a_ray_inside_of_a_face_hits_whatever_the_sign_of_its_zero() {
        for zero in [0.0, -0.0] {
            for at in [0.0, 1.0] {
                assert!(crosses([at, 0.5, -1.0], [zero, zero, 1.0], &UNIT));
                assert!(crosses([at, at, -1.0], [zero, zero, 1.0], &UNIT), "along an edge");
                assert!(crosses([at, -1.0, -1.0], [zero, 1.0, 1.0], &UNIT));
            }
            assert!(!crosses([1.1, 0.5, -1.0], [zero, zero, 1.0], &UNIT));
            assert!(!crosses([-0.1, 0.5, -1.0], [zero, zero, 1.0], &UNIT));
            let flat = Aabb { min: Vec3::ZERO, max: Vec3::new(1.0, 0.0, 1.0) };
            assert!(crosses([0.5, 0.0, -1.0], [zero, zero, 1.0], &flat));
            assert!(crosses([0.5, 1.0, 0.5], [zero, -1.0, zero], &flat));
        }
    }

    #[test]
    fn the_interval_is_where_the_ray_is_inside() {
        let ray = Ray::new(Vec3::new(0.5, 0.5, -2.0), Vec3::Z * 2.0);
        let inside = Slabs::of(&ray).cross(&UNIT, Interval::POSITIVE).unwrap();
        assert!((inside.min - 1.0).abs() < 1e-5 && (inside.max - 1.5).abs() < 1e-5);
        assert!(Slabs::of(&ray).cross(&UNIT, Interval::new(0.0, 0.9)).is_none(), "the range ends before");
        assert!(Slabs::of(&ray).cross(&UNIT, Interval::new(1.6, 9.0)).is_none(), "the range begins behind");
        let from_inside = Slabs::of(&Ray::new(Vec3::splat(0.5), Vec3::X)).cross(&UNIT, Interval::POSITIVE).unwrap();
        assert!(from_inside.min == 0.0 && (from_inside.max - 0.5).abs() < 1e-5);
    }
}
