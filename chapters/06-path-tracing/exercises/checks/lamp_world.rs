//! A world with one lamp that can be asked.

use common::{Interval, Rgb, Stream, Vec3};
use path_tracing::{
    importance::Step,
    material::Material,
    roulette::{Chances, Kind},
};
use ray_casting::{hit::Hit, ray::Ray, scene::Scene, shape::Shape};
use sampling::{direction_sampling::DirectionSampling, mirror::sample_mirror, unit_square::sample_unit_square};
use shadows::offset::Offset;
use whitted::material::Fresnel;

use super::lamp::{Lamp, LampSample};

/// What a thing is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Surface {
    /// What it is made of.
    pub(crate) material: Material,
    /// Whether it is the lamp that can be asked. Other things may glow, too, but are found by chance alone.
    pub(crate) is_lamp: bool,
}

/// Things, and a lamp among them.
pub(crate) struct LampWorld {
    /// The lamp that can be asked.
    pub(crate) lamp: Lamp,
    scene: Scene<Surface>,
}

impl LampWorld {
    /// No path is longer.
    pub(crate) const MOST_BOUNCES: u32 = 200;

    /// Nothing but a lamp in the dark.
    pub(crate) fn new(lamp: Lamp) -> Self {
        let mut scene = Scene::new();
        scene.add("lamp", lamp.quad(), Surface { material: Material::glowing(lamp.radiance), is_lamp: true });
        Self { lamp, scene }
    }

    /// The same with one more thing.
    pub(crate) fn with(mut self, name: &'static str, shape: impl Shape + 'static, material: Material) -> Self {
        self.scene.add(name, shape, Surface { material, is_lamp: false });
        self
    }

    /// The same with light from all around.
    pub(crate) fn under(mut self, sky: Rgb) -> Self {
        self.scene.surround(sky);
        self
    }

    /// The nearest hit in front of a ray, and what was hit.
    pub(crate) fn intersect(&self, ray: &Ray) -> Option<(Hit, &Surface)> {
        let (hit, object) = self.scene.intersect(ray, Interval::POSITIVE)?;
        Some((hit, &object.material))
    }

    /// The radiance that comes from where nothing is hit.
    pub(crate) fn sky(&self, direction: Vec3) -> Rgb {
        self.scene.background.radiance(direction)
    }

    /// Whether a hit sees a point of the lamp: whether nothing stands between them. It sends a shadow ray.
    pub(crate) fn sees(&self, hit: &Hit, sample: &LampSample) -> bool {
        let ray = Ray::new(Offset::Following.origin(hit, hit.geometric_normal), sample.direction);
        let range = Interval::POSITIVE.up_to(sample.distance);
        // The lamp is flat, and does not hide itself.
        let mut others = self.scene.objects.iter().filter(|object| !object.material.is_lamp);
        !others.any(|object| object.shape.occluded(&ray, range))
    }

    /// How a path goes on from a hit, and by which kind of reflection; `None` ends it. This is the step of the path
    /// tracer: chance chooses the kind, a cosine-distributed direction or the mirror direction, and the end.
    pub(crate) fn step(
        &self,
        material: &Material,
        hit: &Hit,
        to_viewer: Vec3,
        random: &mut Stream,
    ) -> Option<(Step, Kind)> {
        let reflectance = material.reflectance(to_viewer.dot(hit.shading_normal), Fresnel::Exact);
        let (kind, probability) = Chances::of(material.albedo(), reflectance).choose(random)?;
        let (sample, weight) = match kind {
            Kind::Diffuse => {
                let u = sample_unit_square(random);
                (DirectionSampling::CosineHemisphere.sample(hit.shading_normal, u), material.albedo())
            }
            Kind::Mirror => (sample_mirror(hit.shading_normal, to_viewer), reflectance),
        };
        Some((Step { direction: sample.direction, weight: weight / probability }, kind))
    }

    /// The ray on which a path goes on.
    pub(crate) fn next_ray(&self, hit: &Hit, step: &Step) -> Ray {
        Ray::new(Offset::Following.origin(hit, hit.geometric_normal), step.direction)
    }

    /// One sample of the radiance that comes back along a ray, by paths that find the lamp by chance alone.
    pub(crate) fn by_chance(&self, ray: Ray, random: &mut Stream) -> Rgb {
        let (mut ray, mut radiance, mut throughput) = (ray, Rgb::ZERO, Rgb::ONE);
        for _ in 0..Self::MOST_BOUNCES {
            let Some((hit, surface)) = self.intersect(&ray) else {
                return radiance + throughput * self.sky(ray.direction);
            };
            radiance += throughput * surface.material.emission;
            let Some((step, _)) = self.step(&surface.material, &hit, -ray.direction, random) else { break };
            throughput *= step.weight;
            ray = self.next_ray(&hit, &step);
        }
        radiance
    }
}
