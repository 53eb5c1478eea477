//! Matte balls on a lawn, under a sky that has another color in each direction: what a path brings tells where it has gone.

use std::{ops::RangeInclusive, sync::Arc};

use common::{Rgb, Vec3};
use path_tracing::{material::Material, method::Method, path_tracer::PathTracer, world::World};
use ray_casting::{background::Background, camera::Camera, scene::Scene, sphere::Sphere};

/// The sky.
struct Rainbow;

impl Background for Rainbow {
    fn radiance(&self, direction: Vec3) -> Rgb {
        Rgb::ONE + direction.normalize_or_zero() * 0.8
    }
}

/// The garden, seen by paths of so many bounces, without roulette.
pub(super) fn tracer(bounces: RangeInclusive<u32>) -> PathTracer {
    let matte = |red, green, blue| Material::matte(Rgb::new(red, green, blue));
    let mut scene = Scene::new();
    scene.surround(Rainbow);
    // A lawn on a large ball.
    scene.add("lawn", Sphere::new(Vec3::Y * -40.0, 40.0), matte(0.6, 0.8, 0.5));
    for (x, z, color) in
        [(-1.1, 0.0, matte(0.9, 0.5, 0.4)), (0.0, -0.6, matte(0.8, 0.8, 0.8)), (1.1, 0.1, matte(0.4, 0.6, 0.9))]
    {
        scene.add("ball", Sphere::new(Vec3::new(x, 0.6, z), 0.6), color);
    }
    // It looks neither along an axis nor along `up`, and the angle is one: there is such a camera.
    let camera = Camera::new(Vec3::new(0.4, 1.3, 4.0), Vec3::new(0.0, 0.6, 0.0), Vec3::Y, 40.0);
    let camera = camera.expect("the eye is not where it looks");
    PathTracer {
        world: Arc::new(World::new(scene)),
        camera,
        method: Method { roulette: false, bounces, ..Method::BEST },
    }
}
