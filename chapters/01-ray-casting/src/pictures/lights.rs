//! A directional light beside a point light.

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    film::Size,
    knob::{Knob, Step},
    picture::{ORBIT, Panels, Picture, Render, Settings},
};

use super::stage::{camera, square};
use crate::{
    light::{DirectionalLight, Light, PointLight},
    local_illumination::{LocalIllumination, Terms},
    material::Phong,
    scene::Scene,
    sphere::Sphere,
};

const HEIGHT: Knob =
    Knob::number("height", "of the point light over the floor", [0.5, 10.0], 1.6, "units", Step::Add(0.1));

pub(super) const PICTURE: Picture = Picture {
    name: "lights",
    alt: "Nine white balls on a gray floor, twice. Left, under a directional light: the floor is evenly bright and \
          every ball is lit alike, from the upper left. Right, under a point light in the middle: a round pool of \
          light that fades outward, and each ball is bright on the side that faces the middle.",
    knobs: &[HEIGHT, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 480>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let height = settings.values.number(&HEIGHT);
    let sun = DirectionalLight::new(Vec3::new(-0.8, 0.8, 0.4), Rgb::splat(2.83));
    // At the default height, the floor below the lamp gets what a surface gets that faces the sun.
    let lamp = PointLight { position: Vec3::new(0.0, height, 0.0), intensity: Rgb::splat(7.24) };
    Ok(Box::new(Panels::new(2, vec![view(settings, sun)?, view(settings, lamp)?])))
}

fn view(settings: &Settings, light: impl Light + 'static) -> Result<Box<dyn Render>, Error> {
    let mut scene = Scene::new();
    scene.ambient = Rgb::splat(0.06);
    scene.light(light);
    scene.add("floor", square(0.0, 60.0)?, Phong::of(srgb(120, 126, 138), 0.0, 1.0));
    for x in [-1.5, 0.0, 1.5] {
        for z in [-1.5, 0.0, 1.5] {
            let ball = Sphere::new(Vec3::new(x, 0.32, z), 0.32);
            scene.add("ball", ball, Phong::of(srgb(228, 222, 210), 0.3, 40.0));
        }
    }
    let camera = camera([0.0, 6.2, 7.4], [0.0, 0.0, 0.1], 30.0, &settings.values)?;
    Ok(Box::new(LocalIllumination { scene, camera, terms: Terms::ALL }))
}
