//! Uniform and cosine-distributed directions: the same mean, and the variances that theory says.

use common::{Vec3, picture::Settings};
use ray_casting::{pictures::stage::square, ray::Ray, scene::Scene};
use sampling::sky_light::Choice;

use super::{gray, red};
use crate::{
    experiments::{is_right, tracer},
    material::Material,
    method::Method,
    path_tracer::PathTracer,
    pictures::room,
};

/// A floor under a sky of radiance 1: without roulette the variance of a sample is ρ²/3 and 0; with roulette, which goes on
/// with probability ρ and then has the weight 2 cosθ or 1, it is `ρ·4/3 − ρ²` and `ρ − ρ²`.
#[test]
fn variances_are_as_computed() {
    let albedo = 0.6;
    let rho = f64::from(albedo);
    let rows = [
        (Choice::Uniform, false, rho * rho / 3.0),
        (Choice::CosineAndMirror, false, 0.0),
        (Choice::Uniform, true, rho * 4.0 / 3.0 - rho * rho),
        (Choice::CosineAndMirror, true, rho - rho * rho),
    ];
    for (choice, roulette, variance) in rows {
        let mut scene = Scene::new();
        scene.surround(gray(1.0));
        scene.add("floor", square(0.0, 5.0).unwrap(), Material::matte(gray(albedo)));
        let method = Method { choice, roulette, ..Method::BEST };
        let estimate = red(&tracer(scene, method).unwrap(), Ray::new(Vec3::Y, Vec3::new(0.6, -0.8, 0.0)), 200_000, 64);
        assert!(is_right(&estimate, rho), "{choice:?}, roulette {roulette}: {estimate:?}");
        assert!((estimate.variance() - variance).abs() < 0.01, "{choice:?}, roulette {roulette}: {estimate:?}");
    }
}

/// In the room, where nobody knows the light: all ways agree, but for that of the mirror ball, which the ray does not see
/// itself and which uniform directions take for black. So the room is asked without it.
#[test]
fn all_ways_agree_in_the_room() {
    let ray = Ray::new(Vec3::new(0.0, 1.5, 3.0), Vec3::new(-0.3, -0.5, -1.0).normalize());
    let world = std::sync::Arc::new(room::world_without_ball(room::Lamp::Abstract).unwrap());
    let measure = |choice, roulette| {
        let bounces = if roulette { Method::BEST.bounces } else { 0..=60 };
        let method = Method { choice, roulette, bounces, ..Method::BEST };
        let tracer = PathTracer { world: world.clone(), camera: room::view(&Settings::default()).unwrap(), method };
        red(&tracer, ray, if roulette { 80_000 } else { 20_000 }, 65)
    };
    let cosine = measure(Choice::CosineAndMirror, false);
    for (choice, roulette) in [(Choice::CosineAndMirror, true), (Choice::Uniform, false), (Choice::Uniform, true)] {
        let other = measure(choice, roulette);
        let [a, b] = [&cosine, &other].map(|estimate| estimate.three_sigma());
        let allowed = (a * a + b * b).sqrt();
        let apart = (cosine.mean() - other.mean()).abs();
        assert!(apart <= allowed, "{choice:?}: {cosine:?} {other:?}");
        assert!(other.variance() > cosine.variance(), "{choice:?}: {cosine:?} {other:?}");
    }
}
