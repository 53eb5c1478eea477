//! Local illumination: how bright a point is by the light that comes straight from the lights.

use common::{
    Interval, Rgb, Stream, Vec3,
    picture::{FilmPoint, Integrator},
    story::{Story, number, triple},
};

use crate::{
    camera::Camera,
    hit::{Hit, Side},
    light::Illumination,
    material::Phong,
    ray::Ray,
    scene::{Object, Scene},
};

/// A scene, seen by a camera, lit by its abstract lights and the ambient term.
pub struct LocalIllumination {
    /// What is to be seen.
    pub scene: Scene<Phong>,
    /// Who looks.
    pub camera: Camera,
    /// Which parts of the light are shown.
    pub terms: Terms,
}

/// Which terms of the illumination formula are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Terms {
    /// `k_a L_a`.
    pub ambient: bool,
    /// `k_d (L·N)⁺`.
    pub diffuse: bool,
    /// `k_s ((H·N)⁺)^shininess`.
    pub specular: bool,
}

impl Terms {
    /// The whole formula.
    pub const ALL: Terms = Terms { ambient: true, diffuse: true, specular: true };
    /// Nothing of it.
    pub const NONE: Terms = Terms { ambient: false, diffuse: false, specular: false };
}

impl LocalIllumination {
    // ANCHOR: trace
    /// The radiance that comes back along a ray.
    pub fn trace(&self, ray: &Ray, story: &mut impl Story) -> Rgb {
        match self.scene.intersect(ray, Interval::POSITIVE) {
            Some((hit, object)) => {
                tell_hit(story, &hit, object);
                self.shade(ray, &hit, &object.material, story)
            }
            None => {
                let background = self.scene.background.radiance(ray.direction);
                story.tell(|| format!("hits nothing: background {}", triple(background)));
                background
            }
        }
    }
    // ANCHOR_END: trace

    // ANCHOR: shade
    /// `k_a L_a + Σ L_l · { k_d (L·N)⁺ + k_s ((H·N)⁺)^shininess }`, summed over all lights.
    fn shade(&self, ray: &Ray, hit: &Hit, material: &Phong, story: &mut impl Story) -> Rgb {
        let to_viewer = -ray.direction;
        let mut radiance = Rgb::ZERO;
        // Add what stands in for all the light that is not followed.
        if self.terms.ambient {
            radiance += material.ambient * self.scene.ambient;
            story.tell(|| format!("ambient k_a L_a = {}", triple(radiance)));
        }
        // Add what each light contributes.
        for (i, light) in self.scene.lights.iter().enumerate() {
            let light = light.illuminate(hit.position);
            let reflected = reflected(&light, hit, material, to_viewer, self.terms);
            radiance += reflected;
            story.tell(|| tell_light(i + 1, &light, hit, material, to_viewer, reflected));
        }
        story.tell(|| format!("sum = {}", triple(radiance)));
        radiance
    }
    // ANCHOR_END: shade
}

// ANCHOR: reflected
/// `L_l · { k_d (L·N)⁺ + k_s ((H·N)⁺)^shininess }`: what the viewer gets of one light.
#[must_use]
pub fn reflected(light: &Illumination, hit: &Hit, material: &Phong, to_viewer: Vec3, terms: Terms) -> Rgb {
    let mut share = Rgb::ZERO;
    if terms.diffuse {
        share += material.diffuse_term(light.direction, hit.shading_normal);
    }
    if terms.specular {
        share += material.specular_term(light.direction, hit.shading_normal, to_viewer);
    }
    light.strength * share
}
// ANCHOR_END: reflected

// ANCHOR: integrator
impl Integrator for LocalIllumination {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = self.camera.ray(point);
        tell_ray(story, &ray);
        self.trace(&ray, story)
    }
}
// ANCHOR_END: integrator

/// Tell where a ray starts and where it goes.
pub fn tell_ray(story: &mut impl Story, ray: &Ray) {
    story.tell(|| format!("ray from {} in direction {}", triple(ray.origin), triple(ray.direction)));
}

/// Tell what was hit and where.
pub fn tell_hit<Material>(story: &mut impl Story, hit: &Hit, object: &Object<Material>) {
    story.tell(|| {
        let side = if hit.side == Side::Outside { "outside" } else { "inside" };
        format!("hits '{}' from {side} at t = {}, at {}", object.name, number(hit.t), triple(hit.position))
    });
    story.tell(|| match hit.geometric_normal == hit.shading_normal {
        true => format!("normal {}", triple(hit.geometric_normal)),
        false => format!("normal {}, shaded with {}", triple(hit.geometric_normal), triple(hit.shading_normal)),
    });
}

/// Tell what one light, counted from 1, adds.
#[must_use]
pub fn tell_light(
    number_of_light: usize,
    light: &Illumination,
    hit: &Hit,
    material: &Phong,
    to_viewer: Vec3,
    contribution: Rgb,
) -> String {
    let halfway = (light.direction + to_viewer).normalize_or_zero();
    format!(
        "light {number_of_light}: distance {}, direction L = {}, strength {}\n  L·N = {}, diffuse term {}\n  H·N = {}, specular term {}\n  adds {}",
        number(light.distance),
        triple(light.direction),
        triple(light.strength),
        number(light.direction.dot(hit.shading_normal)),
        triple(material.diffuse_term(light.direction, hit.shading_normal)),
        number(halfway.dot(hit.shading_normal)),
        triple(material.specular_term(light.direction, hit.shading_normal, to_viewer)),
        triple(contribution)
    )
}
