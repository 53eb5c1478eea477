//! Interreflection inside a ball, in closed form: matte, mirroring, and both at once.

use common::{Rgb, Vec3};
use ray_casting::{ray::Ray, scene::Scene, sphere::Sphere};
use whitted::material::Material as Smooth;

use super::red;
use crate::{
    experiments::{coat, estimate, is_right, tracer},
    material::Material,
    method::Method,
    path_tracer::PathTracer,
};

/// Inside a ball of this material.
fn inside(material: Material) -> PathTracer {
    let mut scene = Scene::new();
    scene.add("wall", Sphere::new(Vec3::ZERO, 2.0), material);
    tracer(scene, Method::BEST).unwrap()
}

/// Scene G1 of the reference set: `Le/(1 − ρ)` in each channel.
#[test]
fn all_channels_have_their_own_series() {
    let tracer = inside(Material { emission: Rgb::new(1.0, 0.5, 0.1), ..Material::matte(Rgb::new(0.5, 0.7, 0.9)) });
    let ray = Ray::new(Vec3::new(0.3, 0.1, -0.2), Vec3::new(0.7, 0.3, 0.7).normalize());
    for (channel, expected) in [2.0, 5.0 / 3.0, 1.0].into_iter().enumerate() {
        let estimate =
            estimate(100_000, 62, |random| tracer.trace(ray, random, &mut common::story::Untold)[channel].into());
        assert!(is_right(&estimate, expected), "channel {channel}: {estimate:?}, not {expected}");
    }
}

/// A glowing wall under a smooth coat. A mirror inside a ball keeps the angle θ, so that
/// `L(θ) = Le + ρ E + F(θ) L(θ)` with `E = ∫ L 2 cosθ sinθ dθ`. With `G = ∫ 2 cosθ sinθ / (1 − F) dθ` this is
/// `E = Le G/(1 − ρ G)`. At flat angles F is near 1, and ρ + F is above it: the chances are scaled down there.
#[test]
fn matte_and_mirror_together_have_their_closed_form() {
    const ALBEDO: f32 = 0.3;
    const INDEX: f32 = 1.5;
    let smooth = Smooth::metal(Rgb::splat(INDEX), Rgb::ZERO);
    let tracer = inside(Material { emission: Rgb::ONE, mirror: Some(smooth), ..Material::matte(Rgb::splat(ALBEDO)) });
    let g = coat::gathered(INDEX);
    let albedo = f64::from(ALBEDO);
    let e = g / (1.0 - albedo * g);
    for offset in [0.0_f32, 1.0, 1.7, 1.95] {
        // A ray at this distance from the middle meets the wall with sinθ = offset/2.
        let ray = Ray::new(Vec3::Y * offset, Vec3::X);
        let theta = (1.0 - f64::from(offset * offset) / 4.0).sqrt();
        let expected = (1.0 + albedo * e) / (1.0 - coat::reflectance(INDEX, theta));
        let estimate = red(&tracer, ray, 400_000, 63);
        assert!(is_right(&estimate, expected), "cosθ = {theta}: {estimate:?}, not {expected}");
    }
}
