//! Surfaces that are the zeros of a function.

use common::{
    Error, Vec3,
    color::srgb,
    film::Size,
    knob::{Knob, Step},
    picture::{ORBIT, Panels, Picture, Render, Settings},
};

use super::stage::{camera, stage};
use crate::{
    implicit::{Gyroid, Heart, ImplicitSurface, Tanglecube},
    local_illumination::{LocalIllumination, Terms},
    material::Phong,
    scene::Scene,
    shape::Shape,
    sphere::Sphere,
};

const SURFACE: Knob = Knob::choice("surface", "which function is zero", &["all", "tanglecube", "heart", "gyroid"], 0);
const STEP: Knob = Knob::number(
    "step",
    "step of the march along the ray; too long a step misses thin parts",
    [0.005, 1.0],
    0.04,
    "units",
    Step::Times(1.5),
);

pub(super) const PICTURE: Picture = Picture {
    name: "implicit",
    alt: "Three surfaces, each the zeros of one function: a tanglecube, which is a cube of tubes with a hole in every \
          face, a plump red heart, and a ball cut from a gyroid, a wall that winds endlessly through space.",
    knobs: &[SURFACE, STEP, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 400>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    Ok(match settings.values.index(&SURFACE) {
        0 => {
            let views: Result<_, _> = (1..=3).map(|surface| view(surface, settings)).collect();
            Box::new(Panels::new(3, views?))
        }
        surface => view(surface, settings)?,
    })
}

fn view(surface: usize, settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let step = settings.values.number(&STEP);
    let mut scene = stage()?;
    // The surfaces hang in the air.
    scene.objects.clear();
    match surface {
        1 => add(&mut scene, "tanglecube", Tanglecube, 3.6, step, srgb(52, 140, 140)),
        2 => add(&mut scene, "heart", Heart, 1.6, step * 0.5, srgb(200, 40, 52)),
        _ => add(&mut scene, "gyroid", Gyroid { frequency: 5.0 }, 1.5, step * 0.5, srgb(232, 186, 62)),
    };
    let size = [3.4, 1.45, 1.65][surface.saturating_sub(1).min(2)];
    let camera = camera([1.3 * size, 1.2 * size, 3.6 * size], [0.0, 0.06 * size, 0.0], 31.0, &settings.values)?;
    // The lights move back with the camera, so that each surface is lit alike.
    scene.lights.clear();
    scene.light(super::stage::sun());
    let lamp = super::stage::lamp();
    scene.light(crate::light::PointLight { position: lamp.position * size, intensity: lamp.intensity * size * size });
    Ok(Box::new(LocalIllumination { scene, camera, terms: Terms::ALL }))
}

fn add<F>(scene: &mut Scene<Phong>, name: &'static str, function: F, radius: f32, step: f32, color: Vec3)
where
    ImplicitSurface<F>: Shape + 'static,
{
    let surface = ImplicitSurface { function, bound: Sphere::new(Vec3::ZERO, radius), step };
    scene.add(name, surface, Phong::of(color, 0.5, 60.0));
}
