//! A horizontal disc or ring, of which floors are made.

use common::{Interval, Vec3};
use ray_casting::{hit::Hit, ray::Ray, shape::Shape};

/// The points at the height of `center` whose distance from it lies between `inner` and `outer`. Up is outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Disc {
    /// The middle, in scene units.
    pub(super) center: Vec3,
    /// Radius of the hole, in scene units; 0 if there is none.
    pub(super) inner: f32,
    /// Radius of the whole, in scene units.
    pub(super) outer: f32,
}

impl Shape for Disc {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let Disc { center, inner, outer } = *self;
        // Where the ray comes to the disc's height.
        let t = (center.y - ray.origin.y) / ray.direction.y;
        let from_center = (ray.at(t) - center).with_y(0.0).length();
        let is_hit = range.contains(t) && (inner..outer).contains(&from_center);
        is_hit.then(|| Hit::new(ray, t, Vec3::Y).among(center))
    }
}
