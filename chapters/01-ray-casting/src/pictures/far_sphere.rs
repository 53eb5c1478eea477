//! A small sphere far away, by two formulas for the same roots.

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    film::Size,
    knob::{Knob, Step},
    picture::{Panels, Picture, Render, Settings},
};

use super::stage::camera_error;
use crate::{
    camera::Camera,
    light::DirectionalLight,
    local_illumination::{LocalIllumination, Terms},
    material::Phong,
    scene::Scene,
    sphere::{Sphere, TextbookSphere},
};

const DISTANCE: Knob =
    Knob::number("distance", "from the eye to the ball of radius 1", [10.0, 1e6], 2e3, "radii", Step::Times(1.5));
const FORMULA: Knob = Knob::choice("formula", "which formula finds the roots", &["both", "textbook", "stable"], 0);

pub(super) const PICTURE: Picture = Picture {
    name: "far-sphere",
    alt: "The same ball of radius 1, two thousand radii away and seen through a long lens. Left, by the textbook's \
          formula: it falls apart into flat rings and looks larger than it is. Right, by the stable formula: it is a smooth ball.",
    knobs: &[DISTANCE, FORMULA],
    size: Size::of::<960, 480>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let distance = settings.values.number(&DISTANCE);
    Ok(match settings.values.index(&FORMULA) {
        1 => view(distance, true)?,
        2 => view(distance, false)?,
        _ => Box::new(Panels::new(2, vec![view(distance, true)?, view(distance, false)?])),
    })
}

fn view(distance: f32, textbook: bool) -> Result<Box<dyn Render>, Error> {
    let ball = Sphere::new(Vec3::new(0.0, 0.0, -distance), 1.0);
    let material = Phong::of(srgb(206, 108, 74), 0.4, 40.0);
    let mut scene = Scene::new();
    scene.ambient = Rgb::splat(0.12);
    scene.surround(Rgb::splat(0.02));
    scene.light(DirectionalLight::new(Vec3::new(1.0, 1.0, 1.0), Rgb::splat(2.83)));
    if textbook {
        scene.add("ball by the textbook's formula", TextbookSphere(ball), material);
    } else {
        scene.add("ball by the stable formula", ball, material);
    }
    // Wide enough to see 1.3 radii to each side.
    let half_angle = common::float::atan2(1.3, distance);
    let camera = Camera::new(Vec3::ZERO, ball.center, Vec3::Y, 2.0 * half_angle.to_degrees()).map_err(camera_error)?;
    Ok(Box::new(LocalIllumination { scene, camera, terms: Terms::ALL }))
}
