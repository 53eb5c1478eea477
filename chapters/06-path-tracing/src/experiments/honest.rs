//! How many pixels of a picture lie within their own 3σ, where the truth is known.

use common::{
    Error, Rgb, Vec3,
    film::{Film, Size},
    renderer::{Plan, render},
};
use ray_casting::{camera::Camera, pictures::stage::camera_error, scene::Scene, sphere::Sphere};
use sampling::sky_light::Choice;

use crate::{material::Material, method::Method, path_tracer::PathTracer, world::World};

/// The number of pixels, of all runs together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixels {
    /// Those whose red is right within three of their own standard errors.
    pub inside: u32,
    /// All.
    pub all: u32,
}

/// A matte ball under a sky of radiance 1 (scene A1 of the reference set): every pixel is ρ. A sample is 2ρ cosθ, uniform
/// from 0 to 2ρ, and so the mean of 64 of them is near normal.
///
/// # Errors
/// None.
pub fn measure(runs: u64) -> Result<Pixels, Error> {
    const SIZE: Size = Size::of::<4, 4>();
    let albedo = Rgb::new(0.8, 0.5, 0.2);
    let mut scene = Scene::new();
    scene.surround(Rgb::ONE);
    scene.add("ball", Sphere::new(Vec3::ZERO, 1.0), Material::matte(albedo));
    // Only the ball is in the picture.
    let camera = Camera::new(Vec3::Z * 4.0, Vec3::ZERO, Vec3::Y, 16.0).map_err(camera_error)?;
    let method = Method { choice: Choice::Uniform, roulette: false, ..Method::BEST };
    let tracer = PathTracer { world: World::new(scene).into(), camera, method };
    let mut pixels = Pixels { inside: 0, all: 0 };
    for seed in 0..runs {
        let mut film = Film::new(SIZE);
        render(&tracer, &mut film, &Plan { samples: 64, seed, threads: 1 }, &());
        for pixel in film.tiles().iter().flat_map(|tile| &tile.pixels) {
            let (off, sigma) = (pixel.mean() - albedo, pixel.standard_error());
            pixels.inside += u32::from(off.x.abs() <= 3.0 * sigma.x);
            pixels.all += 1;
        }
    }
    Ok(pixels)
}
