//! Picture of exercise 4.3: how many steps each ray takes in a kd-tree by the median, and in one by cost.

use common::{
    Error, Interval,
    picture::{Panels, Picture, Render, Settings},
};
use ray_casting::{aabb::Aabb, pictures::stage::camera, ray::Ray};
use space_partitioning::probe::Counts;

use super::{
    Make,
    steps::{Scale, Steps},
};
use crate::checks::{
    median_or_cost::{Plane, Span, of_three_axes},
    meshes::stadium,
    plane_tree::{Choose, median, plane_tree},
};

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A teapot in a stadium twice side by side, each pixel as bright as the number of steps of its ray. On the left a white and orange \
               glow stands behind the teapot, which is red and violet. On the right all is dark violet, and only the teapot's outline is \
               red.";
    super::picture("4.3-median-or-cost", alt, make)
}

/// The stadium in a kd-tree by the median, and in one by the planes that `cheapest` finds.
pub(crate) fn make(
    settings: &Settings,
    cheapest: fn(&Aabb, usize, &[Span]) -> Option<Plane>,
) -> Result<Box<dyn Render>, Error> {
    let by_cost = move |cell: &Aabb, boxes: &[Aabb]| of_three_axes(&cheapest, cell, boxes);
    let choices: [Choose<'_>; 2] = [&median, &by_cost];
    let panels = choices.map(|choose| panel(settings, choose));
    Ok(Box::new(Panels::new(2, panels.into_iter().collect::<Result<_, _>>()?)))
}

/// The steps in one tree.
fn panel(settings: &Settings, choose: Choose<'_>) -> Result<Box<dyn Render>, Error> {
    let camera = camera([0.8, 1.9, 4.6], [0.05, 0.85, 0.0], 42.0, &settings.values)?;
    let structure = plane_tree(stadium(), choose);
    let count = move |ray: &Ray| {
        let mut counts = Counts::default();
        structure.nearest(ray, Interval::POSITIVE, &mut counts);
        counts.steps()
    };
    Ok(Box::new(Steps { camera, most: 320.0, scale: Scale::Even, count }))
}
