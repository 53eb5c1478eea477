//! The light of the sky on a scene of matte and mirroring things: one integral for each hit, by one random direction.

use common::{
    Interval, Rgb, Stream,
    picture::{FilmPoint, Integrator},
    story::{Story, number, triple},
};
use ray_casting::{
    camera::Camera,
    hit::Hit,
    local_illumination::{tell_hit, tell_ray},
    material::Phong,
    ray::Ray,
    scene::Scene,
};
use shadows::offset::Offset;
use whitted::material::{Fresnel, Material};

use crate::{direction_sampling::DirectionSampling, mirror::sample_mirror, unit_square::sample_unit_square};

// ANCHOR: choice
/// Which directions are followed at a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// Uniform over the hemisphere, whatever the material. It never finds the one direction of a mirror.
    Uniform,
    /// For what is matte in proportion to the cosine, for what mirrors the mirror direction, with probability 1.
    CosineAndMirror,
}
// ANCHOR_END: choice

/// A scene under a sky, with no other light.
pub struct SkyLight {
    /// What is to be seen. Its abstract lights are not looked at, and nothing is transparent.
    pub scene: Scene<Material>,
    /// Who looks.
    pub camera: Camera,
    /// Which directions are followed.
    pub choice: Choice,
}

impl SkyLight {
    /// How often a ray may be mirrored.
    const MIRRORS: u8 = 8;
    const OFFSET: Offset = Offset::Following;

    // ANCHOR: gather
    /// One sample of the light of the sky that a matte surface sends on: `k_d · L cosθ / p` for one random direction.
    fn gather(&self, rough: &Phong, hit: &Hit, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let way = match self.choice {
            Choice::Uniform => DirectionSampling::UniformHemisphere,
            Choice::CosineAndMirror => DirectionSampling::CosineHemisphere,
        };
        let sample = way.sample(hit.shading_normal, sample_unit_square(random));
        // Only what the sky sends straight here counts: what other things send on is left to the next chapter.
        let ray = Ray::new(Self::OFFSET.origin(hit, hit.geometric_normal), sample.direction);
        if self.scene.occluded(&ray, Interval::POSITIVE) {
            story.tell(|| format!("direction {}: something is in the way", triple(sample.direction)));
            return Rgb::ZERO;
        }
        let sky = self.scene.background.radiance(sample.direction);
        let weight = sample.density.weight();
        story.tell(|| {
            let [direction, sky] = [sample.direction, sky].map(triple);
            format!("direction {direction}: sky {sky}, weight 1/p = {}", number(weight))
        });
        rough.diffuse_term(sample.direction, hit.shading_normal) * sky * weight
    }
    // ANCHOR_END: gather

    // ANCHOR: trace
    /// One sample of the radiance that comes back along a ray.
    pub fn trace(&self, ray: Ray, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let (mut ray, mut radiance, mut share) = (ray, Rgb::ZERO, Rgb::ONE);
        for _ in 0..=Self::MIRRORS {
            tell_ray(story, &ray);
            let Some((hit, object)) = self.scene.intersect(&ray, Interval::POSITIVE) else {
                let sky = self.scene.background.radiance(ray.direction);
                story.tell(|| format!("hits nothing: sky {}", triple(sky)));
                return radiance + share * sky;
            };
            tell_hit(story, &hit, object);
            let material = &object.material;
            if let Some(rough) = &material.rough {
                radiance += share * self.gather(rough, &hit, random, story);
            }
            if !material.reflective {
                break;
            }
            if self.choice == Choice::Uniform {
                story.tell(|| "mirrors, but the chance that a uniform direction is the mirror direction is 0".into());
                break;
            }
            let to_viewer = -ray.direction;
            let sample = sample_mirror(hit.shading_normal, to_viewer);
            let cosine = to_viewer.dot(hit.shading_normal);
            share *= material.reflectance(cosine, hit.side, Fresnel::Exact) * sample.density.weight();
            ray = Ray::new(Self::OFFSET.origin(&hit, hit.geometric_normal), sample.direction);
        }
        radiance
    }
    // ANCHOR_END: trace
}

impl Integrator for SkyLight {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        self.trace(self.camera.ray(point), random, story)
    }
}

#[cfg(test)]
mod tests {
    use common::{Vec3, story::Untold};
    use ray_casting::{pictures::stage::square, sphere::Sphere};

    use super::*;
    use crate::estimate::{Estimate, monte_carlo};

    fn lit(material: Material, choice: Choice) -> SkyLight {
        let mut scene = Scene::new();
        scene.surround(Rgb::ONE);
        scene.add("floor", square(0.0, 5.0).unwrap(), material);
        SkyLight { scene, camera: Camera::new(Vec3::Y, Vec3::ZERO, Vec3::Z, 40.0).unwrap(), choice }
    }

    fn estimate(lit: &SkyLight, count: u64) -> Estimate {
        let ray = Ray::new(Vec3::new(0.3, 1.0, 0.0), Vec3::new(-0.3, -1.0, 0.1).normalize());
        monte_carlo(count, &mut Stream::new(1, 0, 0), |random| lit.trace(ray, random, &mut Untold).x.into())
    }

    const GREY: Material = Material {
        rough: Some(Phong { ambient: Rgb::ZERO, diffuse: Rgb::splat(0.2), specular: Rgb::ZERO, shininess: 1.0 }),
        reflective: false,
        refractive: false,
        index: Rgb::ONE,
        extinction: Rgb::ZERO,
    };

    /// In the open the integral is k_d π.
    #[test]
    fn both_choices_have_the_same_mean() {
        let expected = 0.2 * std::f64::consts::PI;
        let uniform = estimate(&lit(GREY, Choice::Uniform), 100_000);
        assert!((uniform.mean() - expected).abs() < 4.0 / 3.0 * uniform.three_sigma(), "{uniform:?}");
        assert!((uniform.variance() / (expected * expected) - 1.0 / 3.0).abs() < 0.01, "{uniform:?}");
        let cosine = estimate(&lit(GREY, Choice::CosineAndMirror), 1000);
        assert!((cosine.mean() - expected).abs() < 1e-6 && cosine.variance() < 1e-10, "{cosine:?}");
    }

    #[test]
    fn only_the_certain_direction_finds_what_a_mirror_shows() {
        let mirror = |choice| estimate(&lit(Material::SILVER, choice), 1000);
        assert_eq!(mirror(Choice::Uniform).mean(), 0.0);
        let seen = mirror(Choice::CosineAndMirror);
        assert!(seen.mean() > 0.9 && seen.variance() < 1e-10, "{seen:?}");
    }

    #[test]
    fn things_stand_in_the_way_of_the_sky() {
        let mut lit = lit(GREY, Choice::CosineAndMirror);
        lit.scene.add("lid", Sphere::new(Vec3::Y * 1.5, 1.2), GREY);
        let ray = Ray::new(Vec3::Y * 0.2, -Vec3::Y);
        let shaded =
            monte_carlo(4000, &mut Stream::new(1, 0, 0), |random| lit.trace(ray, random, &mut Untold).x.into());
        // A sphere of radius R at the distance d straight above hides the share (R/d)² of the weighted hemisphere.
        let expected = 0.2 * std::f64::consts::PI * (1.0 - 1.2 * 1.2 / (1.5 * 1.5));
        assert!((shaded.mean() - expected).abs() < 4.0 / 3.0 * shaded.three_sigma(), "{shaded:?}");
    }
}
