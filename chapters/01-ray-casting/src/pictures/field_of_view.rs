//! The same ball by three lenses.

use common::{
    Error,
    film::Size,
    picture::{ORBIT, Panels, Picture, Render, Settings},
};

use super::{stage::camera, still_life};
use crate::local_illumination::{LocalIllumination, Terms};

pub(super) const PICTURE: Picture = Picture {
    name: "field-of-view",
    alt: "The still life three times, the red ball in the middle equally large. Left, from afar with a field of view \
          of 12 degrees, all things are nearly of their true proportion. Middle, 40 degrees. Right, from close by with \
          90 degrees, near things are huge, far things tiny, and the edges are stretched.",
    knobs: &ORBIT,
    size: Size::of::<960, 360>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let view = |degrees: f32| -> Result<Box<dyn Render>, Error> {
        /// Half of the width that is seen at the ball, in scene units.
        const HALF_WIDTH: f32 = 1.45;
        let distance = HALF_WIDTH / common::float::tan((degrees / 2.0).to_radians());
        let lookat = [0.38, 0.75, 0.35];
        let eye = [lookat[0], lookat[1] + 0.16 * distance, lookat[2] + 0.987 * distance];
        let camera = camera(eye, lookat, degrees, &settings.values)?;
        Ok(Box::new(LocalIllumination { scene: still_life::scene()?, camera, terms: Terms::ALL }))
    };
    Ok(Box::new(Panels::new(3, vec![view(12.0)?, view(40.0)?, view(90.0)?])))
}
