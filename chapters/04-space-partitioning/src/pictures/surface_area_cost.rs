//! The expected cost of halving a cell, over the place of the plane.

mod cell;
mod marks;

use common::{
    Error, Vec2,
    drawing::{
        CHALK, Drawing, SLATE,
        mark::Pen,
        plot::{Axis, Curve, Plot, Scale},
    },
    film::Size,
    knob::{Knob, Step},
    picture::{Picture, Render, Settings},
};

use self::cell::Cell;
use super::palette::KD_TREE_GOLD;
use crate::kd_tree::split::{Costs, Rule, choose};

/// Along which axis the plane moves.
const AXIS: Knob = Knob::choice("axis", "the axis that the plane is at right angles to", &NAMES, 0);
const NAMES: [&str; 3] = ["x", "y", "z"];
/// What a test costs.
const INTERSECTION: Knob =
    Knob::number("intersection", "cost of a test, if a visit costs 1", [0.05, 5.0], 0.5, "", Step::Times(1.25));
/// What is forgiven.
const BONUS: Knob = Knob::number("bonus", "share forgiven if a half is empty", [0.0, 0.9], 0.2, "", Step::Add(0.1));

pub(super) const PICTURE: Picture = Picture {
    name: "surface-area-cost",
    alt: "Above, a cell seen from the side with the boxes of 24 primitives: a crowd of small ones at the left, a few \
          larger ones in the middle, two at the right, and empty space at both ends. Below, the expected cost as a \
          pale golden line over the place of the plane, with a step wherever a box begins or ends: it is lower where \
          one half is empty, highest at the left side of the crowd, least just behind it, and rises slowly toward \
          the right. There a golden line, the chosen plane, runs through both; a dashed gray one, the median, cuts \
          through the crowd and costs more. A dashed horizontal line shows the cost of leaving the cell whole.",
    knobs: &[AXIS, INTERSECTION, BONUS],
    size: Size::of::<960, 640>(),
    samples: 1,
    takes_mesh: false,
    make,
};

/// The page, and how much of it belongs to the cell.
const PAGE: Vec2 = Vec2::new(960.0, 640.0);
const PLOT_TOP: f32 = 252.0;

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let values = &settings.values;
    let axis = values.index(&AXIS).min(2);
    let costs =
        Costs { intersection: values.number(&INTERSECTION), empty_bonus: values.number(&BONUS), ..Costs::default() };
    let cell = Cell::crowded(costs);
    let plot = plot(&cell, axis);
    let mut page = Drawing::new(PAGE, SLATE);
    page.paste(plot.drawing(), Vec2::Y * PLOT_TOP);
    marks::draw_cell(&mut page, &cell, axis, &plot);
    marks::draw_whole(&mut page, &cell, axis, &plot);
    let median = choose(Rule::Median { few: 0 }, &cell.boxes, &cell.aabb);
    let cheapest = choose(Rule::SurfaceArea(costs), &cell.boxes, &cell.aabb);
    marks::draw_planes(&mut page, &cell, axis, &plot, [median, cheapest]);
    Ok(Box::new(page))
}

/// The cost over the place of the plane.
fn plot(cell: &Cell, axis: usize) -> Plot {
    const PLACES: [&str; 3] = ["x of the plane", "y of the plane", "z of the plane"];
    let points = cell.curve(axis);
    let highest = points.iter().map(|point| point.y).fold(cell.whole(), f32::max) * 1.12;
    let across = [cell.aabb.min[axis], cell.aabb.max[axis]];
    let scale = |[low, high]: [f32; 2]| Scale::Linear { step: round_step((high - low) / 10.0) };
    Plot {
        page: PAGE - Vec2::Y * PLOT_TOP,
        x: Axis { name: PLACES[axis], unit: "", range: across, scale: scale(across) },
        y: Axis { name: "expected cost", unit: "", range: [0.0, highest], scale: scale([0.0, highest * 1.6]) },
        curves: vec![
            // A dark border parts the curve from the lines that cross it.
            Curve { points: points.clone(), pen: Pen::new(SLATE, 5.0) },
            Curve { points, pen: Pen::new(KD_TREE_GOLD.lerp(CHALK, 0.25), 2.4) },
        ],
        legends: Vec::new(),
    }
}

/// A step of 1, 2 or 5 times a power of ten that is at least so long.
fn round_step(least: f32) -> f32 {
    let steps = (-3..6_i8).flat_map(|tens| ["1", "2", "5"].map(|digit| format!("{digit}e{tens}")));
    steps.filter_map(|step| step.parse().ok()).find(|step| *step >= least).unwrap_or(least)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_round() {
        assert_eq!([0.0011, 0.13, 0.2, 0.21, 3.0, 70.0].map(round_step), [0.002, 0.2, 0.2, 0.5, 5.0, 100.0]);
    }
}
