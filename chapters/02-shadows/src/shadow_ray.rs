//! The shadow ray: asks whether a light is seen from a point.

use common::Interval;
use ray_casting::{hit::Hit, light::Illumination, ray::Ray, scene::Scene};

use crate::offset::Offset;

// ANCHOR: shadow_ray
/// Whether anything stands between `hit` and the light.
#[must_use]
#[inline]
pub fn is_in_shadow<M>(scene: &Scene<M>, hit: &Hit, light: &Illumination, offset: Offset) -> bool {
    // Start a little above the surface and look toward the light.
    let shadow_ray = Ray::new(offset.origin(hit, hit.geometric_normal), light.direction);
    // What lies beyond the light casts no shadow here.
    scene.occluded(&shadow_ray, Interval::POSITIVE.up_to(light.distance))
}
// ANCHOR_END: shadow_ray
