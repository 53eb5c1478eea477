//! The walk of one ray through each of the three structures, in a scene as flat as paper.

mod panel;
mod paper;

use common::{
    Error, Vec2,
    drawing::{Drawing, SLATE},
    film::Size,
    knob::{Knob, Step},
    picture::{Picture, Render, Settings},
};

use self::{
    panel::draw,
    paper::{Paper, ray},
};
use crate::{
    choice::Choice,
    grid::Grid,
    kd_tree::{KdTree, split::Rule},
    octree::Octree,
};

/// Where the ray enters at the left.
const HEIGHT: Knob =
    Knob::number("height", "where the ray starts, from below", [0.0, 100.0], 30.0, "%", Step::Add(1.0));
/// Where it goes.
const ANGLE: Knob = Knob::number("angle", "where the ray goes, upward", [-60.0, 60.0], 12.0, "°", Step::Add(1.0));

pub(super) const PICTURE: Picture = Picture {
    name: "walks",
    alt: "Three panels with the same flat scene of short lines: an octagon, a large ring, a small dense ring, \
          crumbs beside it, a floor and a wall. It is cut into cells in three ways: equal blue squares in the grid, \
          green squares of several sizes in the octree, golden rectangles that fit the lines in the kd-tree. A ray \
          comes from the left edge and hits the large ring. The cells on its way up to the hit are tinted and \
          numbered; lines that were tested are red, the one that was hit is thick and white. Above each panel stand \
          the numbers of cells and tests.",
    knobs: &[HEIGHT, ANGLE],
    size: Size::of::<960, 408>(),
    samples: 1,
    takes_mesh: false,
    make,
};

/// The page: three panels side by side.
const PAGE: Vec2 = Vec2::new(960.0, 408.0);
/// Where the first panel's square stands, and how far the next one is from it.
const FIRST: Vec2 = Vec2::new(15.0, 88.0);
const NEXT: f32 = 315.0;

/// Cells for each line in the grid: few, because the scene has no room for any above each other.
const DENSITY: f32 = 0.03;
/// Cells of the octree with more lines are divided.
const FEW: usize = 3;

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let ray = ray(settings.values.number(&HEIGHT) / 100.0, settings.values.number(&ANGLE));
    let paper = Paper::new()?;
    let triangles = &paper.triangles;
    let panels = [
        draw(&paper, Choice::Grid, Grid::over(triangles, DENSITY)?, &ray),
        draw(&paper, Choice::Octree, Octree::over(triangles, FEW)?, &ray),
        draw(&paper, Choice::KdTree, KdTree::over(triangles, Rule::default())?, &ray),
    ];
    let mut page = Drawing::new(PAGE, SLATE);
    let mut at = FIRST;
    for panel in panels {
        page.paste(panel, at);
        at.x += NEXT;
    }
    Ok(Box::new(page))
}
