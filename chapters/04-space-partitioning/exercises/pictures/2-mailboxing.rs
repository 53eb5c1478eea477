//! Picture of exercise 4.2: a ball of spikes in a grid, and how many tests each ray takes.

use common::{
    Error, Interval,
    picture::{Panels, Picture, Render, Settings},
};
use ray_casting::{pictures::stage::camera, ray::Ray};
use space_partitioning::{grid::grid, primitives::Primitives};

use super::{
    Make,
    steps::{Scale, Steps},
};
use crate::checks::{
    logged::{Logged, logging},
    meshes::spikes,
};

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A ball of long thin spikes twice side by side. Each pixel is as bright as the number of tests of its ray. On the left the middle of \
               the ball glows red, orange and white, on the right it is mostly violet.";
    super::picture("4.2-mailboxing", alt, make)
}

/// The number of tests, without and with the mailboxes that `mailboxed` puts around primitives.
pub(crate) fn make<M: Primitives<Entry = <Logged as Primitives>::Entry> + 'static>(
    settings: &Settings,
    mailboxed: impl Fn(Logged) -> M,
) -> Result<Box<dyn Render>, Error> {
    let camera = camera([0.0, 0.7, 4.2], [0.0, 0.0, 0.0], 30.0, &settings.values)?;
    let most = 90.0;
    let triangles = Logged(spikes(700));
    let plain = grid(triangles.clone())?;
    let without = move |ray: &Ray| logging(|| plain.nearest(ray, Interval::POSITIVE, &mut ())).1.len() as u64;
    let structure = grid(mailboxed(triangles))?;
    let with = move |ray: &Ray| logging(|| structure.nearest(ray, Interval::POSITIVE, &mut ())).1.len() as u64;
    let left = Steps { camera, most, scale: Scale::Even, count: without };
    let right = Steps { camera, most, scale: Scale::Even, count: with };
    Ok(Box::new(Panels::new(2, vec![Box::new(left), Box::new(right)])))
}
