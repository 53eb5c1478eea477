//! The cover: metals, glass and porcelain on a terrace in the evening.

use common::{
    Error, Vec3,
    color::srgb,
    film::Size,
    float,
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{
    camera::Camera, frame::Frame, material::Phong, pictures::stage, quadric::Quadric, scene::Scene, sphere::Sphere,
};

use super::studio::{DEPTH, limits, seen, terrace};
use crate::material::Material;

pub(super) const PICTURE: Picture = Picture {
    name: "treasure",
    alt: "Large balls of gold, silver and copper, a solid and a hollow glass ball, a blue egg, a red ball, three small \
          metal balls and a string of pearls lie on a round terrace of slate and stone with two thin rings of gold, \
          under an evening sky with streaks of cloud over a calm sea. Each metal ball shows the sky, the sun and its \
          neighbors, tinted by its own color; the solid glass ball shows what is behind it upside down.",
    knobs: &[DEPTH, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    Ok(Box::new(seen(scene(), view(settings)?, limits(settings, &DEPTH))))
}

/// The camera of the treasure.
///
/// # Errors
/// [`Error::Picture`] if the knobs leave no direction to look in.
pub fn view(settings: &Settings) -> Result<Camera, Error> {
    stage::camera([0.0, 2.3, 9.6], [0.0, 0.92, 0.0], 27.0, &settings.values)
}

/// A sphere that lies on the floor.
fn ball(x: f32, z: f32, radius: f32) -> Sphere {
    Sphere::new(Vec3::new(x, radius, z), radius)
}

/// How many pearls there are.
const PEARLS: u8 = 16;

/// The treasure.
pub fn scene() -> Scene<Material> {
    let porcelain = |color| Material::coated(Phong::of(color, 0.0, 1.0), 1.5);
    let glass = Material::glass(1.5);
    let egg = Quadric::ellipsoid(Vec3::new(0.52, 0.38, 0.38))
        .placed(Frame::at(Vec3::new(-0.95, 0.38, 1.15)).turned(Vec3::Y, 24.0));
    let mut scene = terrace();
    scene
        .add("gold", ball(-1.15, -0.9, 1.3), Material::GOLD)
        .add("silver", ball(1.2, -1.1, 1.02), Material::SILVER)
        .add("copper", ball(2.45, 0.35, 0.74), Material::COPPER)
        .add("glass", ball(0.42, 0.95, 0.66), glass)
        .add("hollow glass", ball(-2.45, 0.85, 0.55), glass)
        .add("air in the hollow glass", Sphere::new(Vec3::new(-2.45, 0.55, 0.85), 0.5), Material::glass(1.0 / 1.5))
        .add("egg (ellipsoid)", egg, porcelain(srgb(24, 92, 120)))
        .add("red porcelain", ball(1.5, 1.45, 0.34), porcelain(srgb(176, 34, 36)))
        .add("small gold", ball(1.42, 2.35, 0.2), Material::GOLD)
        .add("small silver", ball(-0.28, 2.0, 0.24), Material::SILVER)
        .add("small copper", ball(-1.75, 1.75, 0.26), Material::COPPER);
    // A string of pearls, laid in a bow.
    for i in 0..PEARLS {
        let angle = (f32::from(i) * 6.4 - 58.0).to_radians();
        let [x, z] = [float::sin(angle), float::cos(angle)].map(|c| c * 1.6);
        scene.add("pearl", ball(0.3 + x, 1.0 + z, 0.085), porcelain(srgb(214, 202, 190)));
    }
    scene
}
