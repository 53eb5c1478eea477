//! The bounding volume: a simple shape around a complicated one. A ray that misses the first misses the second.

use common::{Interval, Vec3};
use ray_casting::{aabb::Aabb, hit::Hit, mesh::Mesh, ray::Ray, shape::Shape, sphere::Sphere, triangle::Triangle};

use crate::{primitives::Bounded, slabs::Slabs};

// ANCHOR: bounding_volume
/// A shape in a box. The shape is asked only by rays that meet the box.
#[derive(Clone, Debug)]
pub struct BoundingVolume<S> {
    aabb: Aabb,
    shape: S,
}

impl<S: Bounded> BoundingVolume<S> {
    /// The shape in its own box.
    #[must_use]
    pub fn of(shape: S) -> Self {
        Self { aabb: shape.aabb(), shape }
    }
}

impl<S: Shape> BoundingVolume<S> {
    /// The shape in a box of which the caller knows that it holds all of it.
    #[must_use]
    pub fn new(shape: S, aabb: Aabb) -> Self {
        Self { aabb, shape }
    }
}

impl<S: Shape> Shape for BoundingVolume<S> {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        Slabs::of(ray).cross(&self.aabb, range)?;
        self.shape.intersect(ray, range)
    }

    fn occluded(&self, ray: &Ray, range: Interval) -> bool {
        Slabs::of(ray).cross(&self.aabb, range).is_some() && self.shape.occluded(ray, range)
    }
}
// ANCHOR_END: bounding_volume

impl<S: Shape> Bounded for BoundingVolume<S> {
    fn aabb(&self) -> Aabb {
        self.aabb
    }
}

impl Bounded for Sphere {
    fn aabb(&self) -> Aabb {
        let reach = Vec3::splat(self.radius);
        Aabb { min: self.center - reach, max: self.center + reach }
    }
}

impl Bounded for Triangle {
    fn aabb(&self) -> Aabb {
        let [a, b, c] = self.corners;
        Aabb { min: a.min(b).min(c), max: a.max(b).max(c) }
    }
}

impl Bounded for Mesh {
    fn aabb(&self) -> Aabb {
        self.bounds()
    }
}

impl Bounded for Box<dyn Bounded> {
    fn aabb(&self) -> Aabb {
        (**self).aabb()
    }
}
