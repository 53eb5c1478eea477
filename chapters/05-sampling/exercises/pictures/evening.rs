//! What two pictures share: an evening sky, and matte things under it.

use common::{Error, Rgb, Vec3, color::srgb, float, picture::Settings};
use ray_casting::{
    background::Background, camera::Camera, frame::Frame, material::Phong, pictures::stage, quadric::Quadric,
    scene::Scene, sphere::Sphere,
};

/// A sky after sunset: dark blue above, warm where the sun has gone.
#[derive(Clone, Copy)]
pub(super) struct Evening;

impl Background for Evening {
    fn radiance(&self, direction: Vec3) -> Rgb {
        let direction = direction.normalize_or(Vec3::Y);
        let glow = (direction.dot(Vec3::new(-0.8, 0.15, -0.58)) / 2.0 + 0.5).max(0.0);
        let low = (1.0 - direction.y.abs()).max(0.0);
        let sky = Rgb::new(0.16, 0.22, 0.42).lerp(Rgb::new(0.46, 0.34, 0.42), low * low);
        sky + Rgb::new(5.0, 2.1, 0.62) * float::pow(glow, 14.0) + Rgb::new(0.7, 0.42, 0.3) * float::pow(glow, 3.0)
    }
}

/// Matte things on a pale floor.
///
/// # Errors
/// None with these shapes.
pub(super) fn still_life() -> Result<Scene<Phong>, Error> {
    let matte = |red, green, blue| Phong::of(srgb(red, green, blue), 0.0, 1.0);
    let ball = |x: f32, z: f32, radius: f32| Sphere::new(Vec3::new(x, radius, z), radius);
    let mut scene = Scene::new();
    scene.surround(Evening);
    scene
        .add("floor", stage::square(0.0, 40.0)?, matte(214, 206, 196))
        .add("white ball", ball(0.1, -0.5, 0.72), matte(236, 232, 226))
        .add("red ball", ball(0.95, 0.35, 0.36), matte(206, 60, 48))
        .add("blue ball", ball(-0.8, 0.5, 0.4), matte(70, 120, 190))
        .add("yellow ball", ball(0.2, 0.75, 0.24), matte(232, 178, 66))
        .add("cone", Quadric::cone(0.4, 1.1).placed(Frame::at(Vec3::new(-1.25, 0.0, -0.35))), matte(84, 156, 116));
    Ok(scene)
}

/// Who looks.
///
/// # Errors
/// Tells when the knobs leave no direction to look in.
pub(super) fn camera(settings: &Settings) -> Result<Camera, Error> {
    stage::camera([0.0, 2.2, 6.2], [-0.1, 0.55, 0.0], 30.0, &settings.values)
}
