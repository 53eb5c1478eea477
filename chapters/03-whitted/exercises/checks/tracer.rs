//! Recursive ray tracing around what a student has written: how rays branch, and what happens to them on their way.

use common::{
    Interval, Rgb, Stream,
    picture::{FilmPoint, Integrator},
    story::Story,
};
use ray_casting::{
    camera::Camera,
    hit::Hit,
    light::Illumination,
    local_illumination::{Terms, reflected},
    material::Phong,
    ray::Ray,
    scene::Scene,
};
use shadows::offset::Offset;
use whitted::branches::Branch;

/// What surfaces and media do to rays.
pub(crate) trait Optics: Send + Sync {
    /// What a surface is made of.
    type Material: Send + Sync;
    /// What a ray travels through.
    type Medium: Copy + Send + Sync;
    /// What is around everything.
    const AIR: Self::Medium;

    /// How the surface scatters light, if it is rough.
    fn rough(&self, material: &Self::Material, hit: &Hit) -> Option<Phong>;

    /// Which share of the radiance at the end of a branch arrives where it starts.
    fn survives(&self, _medium: Self::Medium, _branch: &Branch, _hit: Option<&Hit>) -> Rgb {
        Rgb::ONE
    }

    /// The rays that a surface sends on, each with what it travels through.
    fn branches(&self, from: Follow<'_, Self::Medium>, hit: &Hit, material: &Self::Material) -> Next<Self::Medium>;

    /// The share of a light that goes straight on through the surface, after `way` units since the surface before.
    fn shines_through(&self, material: &Self::Material, ray: &Ray, hit: &Hit, way: f32) -> Rgb;
}

/// A branch and what it travels through.
pub(crate) type Follow<'a, Medium> = (&'a Branch, Medium);

/// At most four rays.
pub(crate) type Next<Medium> = [Option<(Branch, Medium)>; 4];

/// A scene seen by a camera, under the student's optics.
pub(crate) struct Tracer<O: Optics> {
    pub(crate) scene: Scene<O::Material>,
    pub(crate) camera: Camera,
    pub(crate) optics: O,
    /// How many surfaces a ray may have behind it and still be followed.
    pub(crate) max_depth: u32,
    /// The least share worth following.
    pub(crate) min_weight: f32,
}

/// The most rays for one camera ray: wrong shares could make them grow without end.
const MAX_RAYS: u32 = 4000;
/// The most surfaces that a shadow ray goes through.
const MAX_LAYERS: u32 = 32;

impl<O: Optics> Tracer<O> {
    /// The radiance that a camera ray brings.
    pub(crate) fn radiance(&self, ray: Ray) -> Rgb {
        self.trace((&Branch::from_camera(ray), O::AIR), 0, Rgb::ONE, &mut MAX_RAYS.clone())
    }

    fn trace(&self, from: Follow<'_, O::Medium>, depth: u32, weight: Rgb, rays: &mut u32) -> Rgb {
        let (branch, medium) = from;
        let background = self.scene.background.radiance(branch.ray.direction);
        // Written so that a weight that is no number ends here.
        let is_worth_it = weight.element_sum() / 3.0 >= self.min_weight;
        if depth > self.max_depth || !is_worth_it || *rays == 0 {
            return background;
        }
        *rays -= 1;
        let Some((hit, object)) = self.scene.intersect(&branch.ray, branch.range) else {
            return background * self.optics.survives(medium, branch, None);
        };
        let survives = self.optics.survives(medium, branch, Some(&hit));
        let rough = self.optics.rough(&object.material, &hit);
        let mut radiance = rough.map_or(Rgb::ZERO, |rough| self.direct_light(&rough, &hit, &branch.ray));
        for (next, medium) in self.optics.branches(from, &hit, &object.material).into_iter().flatten() {
            radiance += next.share * self.trace((&next, medium), depth + 1, weight * survives * next.share, rays);
        }
        radiance * survives
    }

    /// The ambient term, and what each light contributes through whatever is clear.
    fn direct_light(&self, rough: &Phong, hit: &Hit, ray: &Ray) -> Rgb {
        let mut radiance = rough.ambient * self.scene.ambient;
        for light in &self.scene.lights {
            let light = light.illuminate(hit.position);
            let shines = self.shines(hit, &light);
            if shines != Rgb::ZERO {
                radiance += shines * reflected(&light, hit, rough, -ray.direction, Terms::ALL);
            }
        }
        radiance
    }

    /// The share of a light that arrives, straight through clear things.
    fn shines(&self, hit: &Hit, light: &Illumination) -> Rgb {
        let ray = Ray::new(Offset::Following.origin(hit, hit.geometric_normal), light.direction);
        let mut range = Interval::POSITIVE.up_to(light.distance);
        let mut share = Rgb::ONE;
        for _ in 0..MAX_LAYERS {
            let Some((hit, object)) = self.scene.intersect(&ray, range) else { return share };
            share *= self.optics.shines_through(&object.material, &ray, &hit, hit.t - range.min);
            if share == Rgb::ZERO {
                break;
            }
            range.min = hit.t;
        }
        Rgb::ZERO
    }
}

impl<O: Optics> Integrator for Tracer<O> {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, _story: &mut impl Story) -> Rgb {
        Tracer::radiance(self, self.camera.ray(point))
    }
}
