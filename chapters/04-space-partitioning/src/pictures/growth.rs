//! What a ray costs as the scene grows.

use common::{
    Error,
    film::Size,
    picture::{Picture, Render, Settings},
};

use super::log_plots::{Shown, draw};
use crate::choice::Choice;

pub(super) const PICTURE: Picture = Picture {
    name: "growth",
    alt: "Two plots on logarithmic axes over 100 to 10 million triangles: triangles tested by a ray, and time for a \
          ray.",
    knobs: &[],
    size: Size::of::<960, 460>(),
    samples: 1,
    takes_mesh: false,
    make,
};

fn make(_settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let choices = [Choice::BruteForce, Choice::Grid, Choice::Octree, Choice::KdTree];
    let tests = Shown {
        title: "tests",
        y: ("triangles tested by a ray", "", [2.0, 1e6]),
        value: |measured| measured.row.counts.tests as f32 / measured.row.rays as f32,
        legend: [130.0, 5e5],
        // Every triangle is tested.
        known: Some([[1e5, 1e5], [1e6, 1e6]]),
    };
    let time = Shown {
        title: "time",
        y: ("time for a ray", " s", [1e-7, 1e-2]),
        value: |measured| measured.ray,
        legend: [130.0, 5e-3],
        known: None,
    };
    Ok(Box::new(draw(&choices, [tests, time])))
}
