//! What a ray costs as the scene grows.

use common::{
    Error,
    drawing::plot::{Axis, Scale},
    film::Size,
    picture::{Picture, Render, Settings},
};

use super::log_plots::{Shown, draw};
use crate::choice::Choice;

pub(super) const PICTURE: Picture = Picture {
    name: "growth",
    alt: "Two plots on logarithmic axes over the number of triangles, from 100 to 10 million. Left, triangles \
          tested by a ray: by brute force all of them, a steep straight line, dashed beyond 100,000 triangles; with \
          the grid from 13 to 2,700, with a jump between 1,000 and 3,000 triangles; with the octree from 21 to about \
          110; with the kd-tree between 7 and 22, nearly level from 100,000 triangles on. Right, the \
          time for a ray: brute force grows in proportion to the number of triangles, the three structures far \
          slower.",
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
        y: Axis { name: "triangles tested by a ray", unit: "", range: [2.0, 1e6], scale: Scale::Logarithmic },
        value: |measured| measured.row.counts.tests as f32 / measured.row.rays as f32,
        legend: [130.0, 5e5],
        // Every triangle is tested.
        known: Some([[1e5, 1e5], [1e6, 1e6]]),
    };
    let time = Shown {
        title: "time",
        y: Axis { name: "time for a ray", unit: " s", range: [1e-7, 1e-2], scale: Scale::Logarithmic },
        value: |measured| measured.ray,
        legend: [130.0, 5e-3],
        known: None,
    };
    Ok(Box::new(draw(&choices, [tests, time])))
}
