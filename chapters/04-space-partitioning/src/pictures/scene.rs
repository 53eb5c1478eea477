//! The scenes of the chapter as pictures: each in the light, and as heat maps of what its rays cost.

use common::{
    Error,
    film::Size,
    knob::{Knob, Step},
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{camera::Camera, mesh::Mesh, pictures::stage::camera_error};

use super::heat::HeatMaps;
use crate::{
    choice::Choice,
    lit_model::LitModel,
    model::{Model, View},
    scenes::{GENERATORS, Generator},
};

/// How many triangles the scene has.
const TRIANGLES: Knob = Knob::number(
    "triangles",
    "about how many triangles",
    [100.0, 20_000_000.0],
    50_000.0,
    "triangles",
    Step::Times(2.0),
);
/// The same for heat maps: three structures are built, and one of them may be slow.
const FEWER: Knob = Knob::number(
    "triangles",
    "about how many triangles",
    [100.0, 20_000_000.0],
    10_000.0,
    "triangles",
    Step::Times(2.0),
);
/// What finds them.
const STRUCTURE: Knob = Knob::choice("structure", "what finds the triangles", &Choice::NAMES, Choice::KdTree as usize);
/// Which steps a heat map shows.
const COUNTED: Knob = Knob::choice("counted", "which steps are shown", &["cells-and-tests", "cells", "tests"], 0);
/// The hottest color.
const SCALE: Knob =
    Knob::number("scale", "steps of the hottest color", [256.0, 65_536.0], 4096.0, "steps", Step::Times(2.0));

/// A scene in the light.
pub(super) const fn shaded(
    name: &'static str,
    alt: &'static str,
    make: fn(&Settings) -> Result<Box<dyn Render>, Error>,
) -> Picture {
    const KNOBS: &[Knob] = &[TRIANGLES, STRUCTURE, ORBIT[0], ORBIT[1], ORBIT[2]];
    Picture { name, alt, knobs: KNOBS, size: Size::of::<960, 540>(), samples: 4, takes_mesh: false, make }
}

/// The cost of its rays.
pub(super) const fn steps(
    name: &'static str,
    alt: &'static str,
    make: fn(&Settings) -> Result<Box<dyn Render>, Error>,
) -> Picture {
    const KNOBS: &[Knob] = &[FEWER, COUNTED, SCALE, ORBIT[0], ORBIT[1], ORBIT[2]];
    Picture { name, alt, knobs: KNOBS, size: Size::of::<1280, 440>(), samples: 1, takes_mesh: false, make }
}

/// A scene of the list of generators, in the light.
pub(super) fn lit<const SCENE: usize>(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let model = model(&GENERATORS[SCENE], settings, &TRIANGLES);
    let camera = camera(&model.view, settings)?;
    let choice = Choice::ALL[settings.values.index(&STRUCTURE).min(Choice::ALL.len() - 1)];
    Ok(Box::new(LitModel::new(model, choice, camera)?))
}

/// The same scene as heat maps.
pub(super) fn heated<const SCENE: usize>(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let model = model(&GENERATORS[SCENE], settings, &FEWER);
    let camera = camera(&model.view, settings)?;
    let mesh = Mesh::new(&model.mesh, model.shading)?;
    let counted = settings.values.index(&COUNTED);
    Ok(Box::new(HeatMaps::new(mesh, camera, counted, settings.values.number(&SCALE))?))
}

fn model(generator: &Generator, settings: &Settings, triangles: &Knob) -> Model {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the knob's range is smaller")]
    let triangles = settings.values.number(triangles) as u32;
    (generator.make)(triangles)
}

fn camera(view: &View, settings: &Settings) -> Result<Camera, Error> {
    Camera::orbited(view.eye, view.lookat, view.field_of_view, &settings.values).map_err(camera_error)
}
