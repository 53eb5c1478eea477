//! The path tracer: direct light at every hit, and a random walk on from there.
//!
//! Source: Kajiya, *The Rendering Equation*, SIGGRAPH 1986.

use std::sync::Arc;

use common::{
    Rgb, Stream, Vec3,
    picture::{FilmPoint, Integrator},
    story::{Story, number, triple},
};
use ray_casting::{
    camera::Camera,
    hit::{Hit, Side},
    local_illumination::tell_ray,
    ray::Ray,
};
use shadows::offset::Offset;
use whitted::probe::Listener;

use crate::{
    direct_light::direct_light,
    importance::{Step, step},
    material::Material,
    method::Method,
    probe::Probe,
    world::{Surface, World},
};

// ANCHOR: path_tracer
/// A world, seen by a camera, in all its light.
pub struct PathTracer {
    /// What is to be seen.
    pub world: Arc<World>,
    /// Who looks.
    pub camera: Camera,
    /// How paths are chosen.
    pub method: Method,
}
// ANCHOR_END: path_tracer

impl PathTracer {
    // ANCHOR: trace
    /// One sample of the radiance that comes back along a ray.
    pub fn trace(&self, ray: Ray, random: &mut Stream, probe: &mut impl Probe) -> Rgb {
        self.walk(ray, random, probe, |material, hit, to_viewer, random, probe| {
            step(&self.method, material, hit, to_viewer, random, probe)
        })
    }

    /// The same, where `next_step` chooses how a path goes on.
    pub fn walk<P: Probe>(
        &self,
        ray: Ray,
        random: &mut Stream,
        probe: &mut P,
        next_step: impl Fn(&Material, &Hit, Vec3, &mut Stream, &mut P) -> Option<Step>,
    ) -> Rgb {
        let Method { direct, bounces, .. } = &self.method;
        let (mut ray, mut radiance, mut throughput) = (ray, Rgb::ZERO, Rgb::ONE);
        for bounce in 0..=*bounces.end() {
            probe.path_ray();
            tell_ray(probe, &ray);
            let Some((hit, surface)) = self.world.intersect(&ray) else {
                // Outside is the sky.
                let sky = self.world.scene().background.radiance(ray.direction);
                probe.tell(|| format!("hits nothing: sky {}", triple(sky)));
                if bounces.contains(&bounce) {
                    radiance += throughput * sky;
                }
                break;
            };
            let material = surface.material;
            probe.tell(|| tell_hit(&hit, &surface));
            // Add what the surface itself sends out.
            if bounces.contains(&bounce) {
                radiance += throughput * material.emission;
            }
            if bounce == *bounces.end() {
                probe.tell(|| format!("no more than {bounce} bounces: the end"));
                break;
            }
            // Add the light of the lights; here it is reflected once more.
            if *direct && bounces.contains(&(bounce + 1)) {
                radiance += throughput * direct_light(&self.world, material, &hit, probe);
            }
            // Take a step on; of what comes from there this share is sent on.
            let Some(step) = next_step(material, &hit, -ray.direction, random, probe) else { break };
            throughput *= step.weight;
            probe.tell(|| format!("throughput {}, radiance so far {}", triple(throughput), triple(radiance)));
            ray = Ray::new(Offset::Following.origin(&hit, hit.geometric_normal), step.direction);
        }
        probe.tell(|| format!("radiance {}", triple(radiance)));
        radiance
    }
    // ANCHOR_END: trace
}

// ANCHOR: integrator
impl Integrator for PathTracer {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        self.trace(self.camera.ray(point), random, &mut Listener(story))
    }
}
// ANCHOR_END: integrator

fn tell_hit(hit: &Hit, surface: &Surface) -> String {
    let side = if hit.side == Side::Outside { "outside" } else { "inside" };
    let [position, normal, emission] = [hit.position, hit.shading_normal, surface.material.emission].map(triple);
    let glow = if surface.material.emission == Rgb::ZERO { String::new() } else { format!(", glows {emission}") };
    format!("hits '{}' from {side} at t = {}, at {position}, normal {normal}{glow}", surface.name, number(hit.t))
}

#[cfg(test)]
mod tests;
