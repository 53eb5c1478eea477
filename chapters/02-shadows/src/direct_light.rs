//! Direct light: the light that comes straight from the lights, where nothing stands in the way.

use common::{
    Interval, Rgb, Stream, Vec3,
    picture::{FilmPoint, Integrator},
    story::{Story, triple},
};
use ray_casting::{
    camera::Camera,
    hit::Hit,
    local_illumination::{Terms, reflected, tell_hit, tell_light, tell_ray},
    material::Phong,
    ray::Ray,
    scene::Scene,
};

use crate::{offset::Offset, shadow_ray::is_in_shadow};

// ANCHOR: direct_light
/// `k_a L_a + Σ L_l · { k_d (L·N)⁺ + k_s ((H·N)⁺)^shininess }`, summed over the lights that the point sees.
pub fn direct_light<M>(
    scene: &Scene<M>,
    rough: &Phong,
    hit: &Hit,
    to_viewer: Vec3,
    offset: Offset,
    story: &mut impl Story,
) -> Rgb {
    // Add what stands in for all the light that is not followed.
    let mut radiance = rough.ambient * scene.ambient;
    story.tell(|| format!("ambient k_a L_a = {}", triple(radiance)));
    // Add what each light contributes that is not hidden.
    for (i, light) in scene.lights.iter().enumerate() {
        let light = light.illuminate(hit.position);
        if is_in_shadow(scene, hit, &light, offset) {
            story.tell(|| format!("light {}: in shadow, adds nothing", i + 1));
            continue;
        }
        let reflected = reflected(&light, hit, rough, to_viewer, Terms::ALL);
        radiance += reflected;
        story.tell(|| tell_light(i + 1, &light, hit, rough, to_viewer, reflected));
    }
    radiance
}
// ANCHOR_END: direct_light

/// A scene, seen by a camera, lit by the lights that each point sees and the ambient term.
pub struct DirectLight {
    /// What is to be seen.
    pub scene: Scene<Phong>,
    /// Who looks.
    pub camera: Camera,
    /// How far above the surface shadow rays start.
    pub offset: Offset,
}

impl DirectLight {
    // ANCHOR: trace
    /// The radiance that comes back along a ray.
    pub fn trace(&self, ray: &Ray, story: &mut impl Story) -> Rgb {
        let Some((hit, object)) = self.scene.intersect(ray, Interval::POSITIVE) else {
            let background = self.scene.background.radiance(ray.direction);
            story.tell(|| format!("hits nothing: background {}", triple(background)));
            return background;
        };
        tell_hit(story, &hit, object);
        direct_light(&self.scene, &object.material, &hit, -ray.direction, self.offset, story)
    }
    // ANCHOR_END: trace
}

impl Integrator for DirectLight {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = self.camera.ray(point);
        tell_ray(story, &ray);
        self.trace(&ray, story)
    }
}
