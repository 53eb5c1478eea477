//! The picture's own error is honest: as many pixels lie within 3σ as should.

use common::{
    Rgb, Vec3,
    film::{Film, Size},
    renderer::{Plan, render},
};
use ray_casting::{camera::Camera, scene::Scene, sphere::Sphere};
use sampling::sky_light::Choice;

use crate::{material::Material, method::Method, path_tracer::PathTracer, world::World};

/// A matte ball under a sky of radiance 1 (scene A1 of the reference set): every pixel is ρ. A sample is 2ρ cosθ, uniform
/// from 0 to 2ρ, and so the mean of 64 of them is near normal.
#[test]
fn pixels_lie_within_their_three_sigma() {
    const RUNS: u64 = 1000;
    const SIZE: Size = Size::of::<4, 4>();
    let albedo = Rgb::new(0.8, 0.5, 0.2);
    let mut scene = Scene::new();
    scene.surround(Rgb::ONE);
    scene.add("ball", Sphere::new(Vec3::ZERO, 1.0), Material::matte(albedo));
    // Only the ball is in the picture.
    let camera = Camera::new(Vec3::Z * 4.0, Vec3::ZERO, Vec3::Y, 16.0).unwrap();
    let method = Method { choice: Choice::Uniform, roulette: false, ..Method::BEST };
    let tracer = PathTracer { world: World::new(scene).into(), camera, method };
    let (mut inside, mut all) = (0_u32, 0_u32);
    for seed in 0..RUNS {
        let mut film = Film::new(SIZE);
        render(&tracer, &mut film, &Plan { samples: 64, seed, threads: 1 }, &());
        for pixel in film.tiles().iter().flat_map(|tile| &tile.pixels) {
            let (off, sigma) = (pixel.mean() - albedo, pixel.standard_error());
            inside += u32::from(off.x.abs() <= 3.0 * sigma.x);
            all += 1;
        }
    }
    let share = f64::from(inside) / f64::from(all);
    println!("{:.2} % of {all} pixels lie within 3σ", 100.0 * share);
    assert!((share - 0.997).abs() < 0.005, "{share}");
}
