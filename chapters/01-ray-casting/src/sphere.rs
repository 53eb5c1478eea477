//! The sphere: all points at the distance `radius` from `center`.

use common::{Interval, Vec3};

use crate::{
    hit::Hit,
    quadratic::{self, Roots},
    ray::Ray,
    shape::Shape,
};

/// A sphere. Its outward normal points away from the center.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Center, in scene units.
    pub center: Vec3,
    /// Radius, in scene units; not negative.
    pub radius: f32,
}

impl Sphere {
    /// A sphere around `center`.
    #[must_use]
    pub fn new(center: Vec3, radius: f32) -> Self {
        Self { center, radius }
    }

    // ANCHOR: textbook
    /// Ray parameters of entry and exit, with the coefficients as they follow from |ray(t) − c|² = R².
    #[must_use]
    pub fn roots_textbook(&self, ray: &Ray) -> Roots {
        let from_center = ray.origin - self.center;
        let a = ray.direction.dot(ray.direction);
        let b = 2.0 * from_center.dot(ray.direction);
        let c = from_center.dot(from_center) - self.radius * self.radius;
        quadratic::solve_textbook(a, b, c)
    }
    // ANCHOR_END: textbook

    // ANCHOR: roots
    /// Ray parameters of entry and exit, right also for a small sphere far away.
    ///
    /// Source: Haines, Günther, Akenine-Möller, *Precision Improvements for Ray/Sphere Intersection*, Ray Tracing Gems
    /// chapter 7, 2019.
    #[must_use]
    pub fn roots(&self, ray: &Ray) -> Roots {
        let from_center = ray.origin - self.center;
        let a = ray.direction.dot(ray.direction);
        let h = from_center.dot(ray.direction);
        // Where the ray comes nearest to the center, seen from the center.
        let nearest = from_center - ray.direction * (h / a);
        // R² − |nearest|² says how deep the ray dives, without h² − a·c, where two huge numbers would cancel.
        let depth = self.radius * self.radius - nearest.dot(nearest);
        let c = from_center.dot(from_center) - self.radius * self.radius;
        quadratic::solve(a, h, c, a * depth)
    }
    // ANCHOR_END: roots
}

// ANCHOR: intersect
impl Shape for Sphere {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let t = self.roots(ray).first_in(range)?;
        Some(Hit::new(ray, t, ray.at(t) - self.center).among(self.center))
    }
}
// ANCHOR_END: intersect

/// The same sphere by the textbook's formula: a mistake to look at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextbookSphere(pub Sphere);

impl Shape for TextbookSphere {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let t = self.0.roots_textbook(ray).first_in(range)?;
        Some(Hit::new(ray, t, ray.at(t) - self.0.center).among(self.0.center))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hit::Side;

    const UNIT: Sphere = Sphere { center: Vec3::ZERO, radius: 1.0 };

    #[test]
    fn front_inside_behind_and_beside() {
        let toward = Ray::new(Vec3::Z * 3.0, -Vec3::Z);
        let hit = UNIT.intersect(&toward, Interval::POSITIVE).unwrap();
        assert_eq!((hit.t, hit.position, hit.geometric_normal, hit.side), (2.0, Vec3::Z, Vec3::Z, Side::Outside));

        let from_inside = UNIT.intersect(&Ray::new(Vec3::ZERO, Vec3::X), Interval::POSITIVE).unwrap();
        assert_eq!((from_inside.t, from_inside.geometric_normal, from_inside.side), (1.0, -Vec3::X, Side::Inside));

        assert_eq!(UNIT.intersect(&Ray::new(Vec3::Z * 3.0, Vec3::Z), Interval::POSITIVE), None);
        assert_eq!(UNIT.intersect(&Ray::new(Vec3::new(2.0, 0.0, 3.0), -Vec3::Z), Interval::POSITIVE), None);
    }

    #[test]
    fn the_range_is_open() {
        let ray = Ray::new(Vec3::Z * 3.0, -Vec3::Z);
        assert_eq!(UNIT.intersect(&ray, Interval::new(2.0, 9.0)).map(|h| h.t), Some(4.0));
        assert_eq!(UNIT.intersect(&ray, Interval::new(0.0, 2.0)), None);
    }
}
