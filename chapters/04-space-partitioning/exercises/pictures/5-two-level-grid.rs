//! Picture of exercise 4.5: how many steps each ray takes in a flat grid, and in grids in a grid.

use common::{
    Error, Interval,
    picture::{Panels, Picture, Render, Settings},
};
use ray_casting::{pictures::stage::camera, ray::Ray};
use space_partitioning::{
    grid::grid,
    primitives::Primitives,
    probe::Counts,
    structure::{Partition, Structure},
};

use super::{
    Make,
    steps::{Scale, Steps},
};
use crate::checks::{
    blocks::{TwoLevel, filled},
    meshes::stadium,
};

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A teapot in a stadium twice side by side, each pixel as bright as the cube root of the number of steps of its ray. On the left all is \
               orange and pale, in the shape of a few large cells. On the right all is dark violet, but for a few small reddish cells around \
               the teapot.";
    Picture { samples: 2, ..super::picture("4.5-two-level-grid", alt, make) }
}

/// Counts the steps of rays.
fn count<P: Primitives + 'static, T: Partition<P> + 'static>(
    structure: Structure<P, T>,
) -> impl Fn(&Ray) -> u64 + Send + Sync + 'static {
    move |ray| {
        let mut counts = Counts::default();
        structure.nearest(ray, Interval::POSITIVE, &mut counts);
        counts.steps()
    }
}

/// The stadium in a flat grid, and in blocks that are filled by `T`.
pub(crate) fn make<T: TwoLevel + 'static>(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let camera = camera([0.8, 1.9, 4.6], [0.05, 0.85, 0.0], 42.0, &settings.values)?;
    let triangles = stadium();
    let most = 6000.0;
    let left = Steps { camera, most, scale: Scale::CubeRoot, count: count(grid(triangles.clone())?) };
    let right = Steps { camera, most, scale: Scale::CubeRoot, count: count(filled::<_, T>(triangles, 7)) };
    Ok(Box::new(Panels::new(2, vec![Box::new(left), Box::new(right)])))
}
