//! The random walk in its plainest form: from each hit on in one random direction, until light is found.

use common::{Rgb, Stream};
use ray_casting::ray::Ray;
use sampling::{direction_sampling::DirectionSampling, unit_square::sample_unit_square};
use shadows::offset::Offset;

use crate::world::World;

// ANCHOR: random_walk
/// One sample of the radiance that comes back along a ray, after at most so many bounces.
///
/// It is an estimate of `L(y,ω) = D(y,ω) + ∫ L(y',ω') k_d cosθ' dω'`, where the light `L` on the right is estimated in
/// the same way. What would come after more bounces is missing: a walk that is cut off is too dark on average.
#[must_use]
pub fn random_walk(world: &World, ray: Ray, bounces: u32, random: &mut Stream) -> Rgb {
    let (mut ray, mut radiance, mut throughput) = (ray, Rgb::ZERO, Rgb::ONE);
    for _ in 0..=bounces {
        let Some((hit, surface)) = world.intersect(&ray) else {
            // Outside is the sky.
            return radiance + throughput * world.scene().background.radiance(ray.direction);
        };
        let material = surface.material;
        // Add what the surface itself sends out.
        radiance += throughput * material.emission;
        // Go on in any direction.
        let sample = DirectionSampling::UniformHemisphere.sample(hit.shading_normal, sample_unit_square(random));
        if sample.direction.dot(hit.geometric_normal) <= 0.0 {
            // Below the surface nothing can come from.
            break;
        }
        // Only this share of what comes from there is sent on.
        let cos_theta = sample.direction.dot(hit.shading_normal).max(0.0);
        throughput *= material.diffuse * (cos_theta * sample.density.weight());
        ray = Ray::new(Offset::Following.origin(&hit, hit.geometric_normal), sample.direction);
    }
    radiance
}
// ANCHOR_END: random_walk
