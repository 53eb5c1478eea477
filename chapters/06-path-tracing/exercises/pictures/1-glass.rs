//! Picture of exercise 6.1: four things of glass.

use common::{
    Error, Interval, Rgb, Stream, Vec3,
    color::srgb,
    float,
    picture::{FilmPoint, Integrator, Picture, Render, Settings},
    story::Story,
};
use path_tracing::material::Material;
use ray_casting::{
    background::Background,
    camera::Camera,
    frame::Frame,
    hit::Hit,
    pictures::stage::{self, block},
    ray::Ray,
    scene::Scene,
    shape::Shape,
    sphere::Sphere,
};

use super::Make;
use crate::checks::glass_world::{GlassStep, GlassWorld, Matter};

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A large glass ball, a hollow one, a glass block and a small ball of diamond on a pale floor with blue lines, and small \
               red, blue and yellow balls between them, in warm light from the left. The solid ball bends the lines and shows a red \
               ball drawn out long, the hollow one hardly bends what is behind it, and bright spots lie in their shadows.";
    super::picture("6.1-glass", alt, make)
}

/// A sky in the evening, bright where the sun is.
#[derive(Clone, Copy)]
struct Evening;

impl Background for Evening {
    fn radiance(&self, direction: Vec3) -> Rgb {
        let direction = direction.normalize_or(Vec3::Y);
        let near_sun = direction.dot(Vec3::new(-0.62, 0.42, -0.66).normalize()).max(0.0);
        let low = 1.0 - direction.y.abs();
        let sky = Rgb::new(0.05, 0.09, 0.20).lerp(Rgb::new(0.30, 0.23, 0.27), low * low);
        sky + Rgb::new(7.6, 5.0, 2.8) * float::pow(near_sun, 30.0)
            + Rgb::new(0.55, 0.34, 0.22) * float::pow(near_sun, 4.0)
    }
}

/// Glass seen by a camera.
struct View {
    world: GlassWorld,
    camera: Camera,
}

impl Integrator for View {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        self.world.trace(self.camera.ray(point), random, story)
    }
}

/// Lines across the floor, a little above it, to show how glass bends what is behind it.
struct Lines;

impl Shape for Lines {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let t = (1e-3 - ray.origin.y) / ray.direction.y;
        let Vec3 { x, z, .. } = ray.at(t);
        let is_there = range.contains(t) && x.abs() < 9.0 && z.abs() < 6.0 && (z + 5.8).rem_euclid(0.8) < 0.12;
        is_there.then(|| Hit::new(ray, t, Vec3::Y))
    }
}

/// The things, with the student's glass.
pub(crate) fn make(settings: &Settings, glass_step: GlassStep) -> Result<Box<dyn Render>, Error> {
    let matte = |red, green, blue| Matter::Opaque(Material::matte(srgb(red, green, blue)));
    let ball = |x: f32, y: f32, z: f32, radius: f32| Sphere::new(Vec3::new(x, y, z), radius);
    let mut scene = Scene::new();
    scene.surround(Evening);
    scene
        .add("floor", stage::square(0.0, 40.0)?, matte(222, 214, 204))
        .add("lines", Lines, matte(74, 92, 128))
        .add("glass ball", ball(-0.95, 0.75, -0.2, 0.75), Matter::Glass(1.5))
        .add("hollow ball", ball(0.85, 0.6, -0.7, 0.6), Matter::Glass(1.5))
        // Inside is air: its index divided by that of the glass around it.
        .add("hollow", ball(0.85, 0.6, -0.7, 0.5), Matter::Glass(1.0 / 1.5))
        .add(
            "glass block",
            block(Frame::at(Vec3::new(1.75, 0.42, 0.55)).turned(Vec3::Y, 28.0), Vec3::new(0.32, 0.42, 0.32))?,
            Matter::Glass(1.5),
        )
        .add("diamond", ball(0.3, 0.32, 0.75, 0.32), Matter::Glass(2.4))
        .add("red ball", ball(-1.5, 0.3, -1.9, 0.3), matte(206, 60, 48))
        .add("blue ball", ball(0.0, 0.34, -2.1, 0.34), matte(70, 120, 190))
        .add("yellow ball", ball(1.9, 0.36, -1.7, 0.36), matte(232, 178, 66))
        .add("small red ball", ball(-0.35, 0.16, 1.0, 0.16), matte(206, 60, 48))
        .add("small blue ball", ball(1.05, 0.16, 1.25, 0.16), matte(70, 120, 190));
    let camera = stage::camera([0.0, 2.5, 6.6], [0.25, 0.5, 0.0], 25.0, &settings.values)?;
    Ok(Box::new(View { world: GlassWorld { scene, glass_step }, camera }))
}
