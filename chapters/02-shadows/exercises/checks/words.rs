//! How messages put rays, spheres and hits.

use common::Vec3;
use ray_casting::{hit::Hit, ray::Ray};

pub(crate) use common::exercise::words::{number, range, rounded, triple};

/// A ray.
pub(crate) fn ray(ray: &Ray) -> String {
    format!("the ray from {} in direction {}", triple(ray.origin), triple(ray.direction))
}

/// A sphere.
pub(crate) fn sphere(center: Vec3, radius: f32) -> String {
    format!("the sphere around {} with radius {radius}", triple(center))
}

/// Where a ray has hit.
pub(crate) fn hit(hit: &Hit) -> String {
    format!("the hit at {} with normal {}", triple(hit.position), triple(hit.geometric_normal))
}
