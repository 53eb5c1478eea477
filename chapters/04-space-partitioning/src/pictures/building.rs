//! What the structures themselves cost as the scene grows.

use common::{
    Error,
    drawing::plot::{Axis, Scale},
    film::Size,
    picture::{Picture, Render, Settings},
};

use super::log_plots::{Shown, draw};
use crate::choice::Choice;

pub(super) const PICTURE: Picture = Picture {
    name: "building",
    alt: "Two plots over the number of triangles, from 100 to 10 million. Left, on a logarithmic axis, the time to \
          build: three lines that rise steadily, the kd-tree's highest, and from 10,000 triangles on the grid's \
          lowest. Right, the bytes of memory for each triangle: the grid's fall from about 180 to 65, the octree's \
          rise from 80 to 100 and fall to 86, and the kd-tree's rise from 60 to about 110 and fall to 87.",
    knobs: &[],
    size: Size::of::<960, 460>(),
    samples: 1,
    takes_mesh: false,
    make,
};

fn make(_settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let time = Shown {
        title: "time",
        y: Axis { name: "time to build", unit: " s", range: [1e-5, 1e3], scale: Scale::Logarithmic },
        value: |measured| measured.build,
        legend: [130.0, 500.0],
        known: None,
    };
    let memory = Shown {
        title: "memory",
        y: Axis { name: "bytes for each triangle", unit: "", range: [0.0, 250.0], scale: Scale::Linear { step: 50.0 } },
        value: |measured| measured.row.bytes as f32 / measured.row.triangles as f32,
        legend: [130.0, 238.0],
        known: None,
    };
    Ok(Box::new(draw(&Choice::STRUCTURES, [time, memory])))
}
