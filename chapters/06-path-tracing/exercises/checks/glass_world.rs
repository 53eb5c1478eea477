//! A world in which some things are made of glass, and the paths that go through it.

use common::{
    Interval, Rgb, Stream,
    story::{Story, Untold, number, triple},
};
use path_tracing::{importance::step, material::Material, method::Method};
use ray_casting::{hit::Hit, ray::Ray, scene::Scene};
use shadows::offset::Offset;

/// What the student writes: the next ray and its weight, by index, ray and hit.
pub(crate) type GlassStep = fn(f32, &Ray, &Hit, &mut Stream) -> (Ray, f32);

/// What a thing is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Matter {
    /// Clear, with this index inside divided by that outside.
    Glass(f32),
    /// Anything that lets no light through.
    Opaque(Material),
}

/// Things of glass and others. All light comes from what glows, and from the sky.
pub(crate) struct GlassWorld {
    pub(crate) scene: Scene<Matter>,
    pub(crate) glass_step: GlassStep,
}

/// Opaque things end no path by roulette: most of them end in the sky anyway, and have less noise so.
const METHOD: Method = Method { roulette: false, ..Method::BEST };

impl GlassWorld {
    /// No path is longer: right ones end far earlier.
    const MOST_BOUNCES: u32 = 400;

    /// One sample of the radiance that comes back along a ray.
    pub(crate) fn trace(&self, ray: Ray, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let (mut ray, mut radiance, mut throughput) = (ray, Rgb::ZERO, Rgb::ONE);
        for _ in 0..Self::MOST_BOUNCES {
            let Some((hit, object)) = self.scene.intersect(&ray, Interval::POSITIVE) else {
                let sky = self.scene.background.radiance(ray.direction);
                story.tell(|| format!("hits nothing: sky {}", triple(sky)));
                return radiance + throughput * sky;
            };
            story.tell(|| format!("hits '{}' at {} from {:?}", object.name, triple(hit.position), hit.side));
            match &object.material {
                Matter::Glass(index) => {
                    let (next, weight) = (self.glass_step)(*index, &ray, &hit, random);
                    story
                        .tell(|| format!("goes on in direction {}, weight {}", triple(next.direction), number(weight)));
                    throughput *= weight;
                    ray = next;
                }
                Matter::Opaque(material) => {
                    radiance += throughput * material.emission;
                    let next = step(&METHOD, material, &hit, -ray.direction, random, &mut Untold);
                    let Some(next) = next else { break };
                    throughput *= next.weight;
                    ray = Ray::new(Offset::Following.origin(&hit, hit.geometric_normal), next.direction);
                }
            }
            if throughput == Rgb::ZERO {
                break;
            }
        }
        radiance
    }
}
