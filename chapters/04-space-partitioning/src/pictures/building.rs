//! What the structures themselves cost as the scene grows.

use common::{
    Error,
    film::Size,
    picture::{Picture, Render, Settings},
};

use super::log_plots::{Shown, draw};
use crate::choice::Choice;

pub(super) const PICTURE: Picture = Picture {
    name: "building",
    alt: "Two plots on logarithmic axes over 100 to 10 million triangles: time to build a structure, and its memory.",
    knobs: &[],
    size: Size::of::<960, 460>(),
    samples: 1,
    takes_mesh: false,
    make,
};

fn make(_settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let time = Shown {
        title: "time",
        y: ("time to build", " s", [1e-5, 1e3]),
        value: |measured| measured.build,
        legend: [130.0, 500.0],
        known: None,
    };
    let memory = Shown {
        title: "memory",
        y: ("bytes for each triangle", "", [10.0, 1e3]),
        value: |measured| measured.row.bytes as f32 / measured.row.triangles as f32,
        legend: [130.0, 800.0],
        known: None,
    };
    Ok(Box::new(draw(&Choice::STRUCTURES, [time, memory])))
}
