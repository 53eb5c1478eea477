//! What is drawn beside the curve: the boxes in the cell, and the planes.

use common::{
    Rgb, Vec2,
    drawing::{
        CHALK, Drawing, FAINT, GRID, SLATE,
        lettering::{Align, Lettering},
        mark::Pen,
        plot::Plot,
    },
};

use super::{NAMES, PLOT_TOP, cell::Cell};
use crate::{kd_tree::split::Split, pictures::palette::KD_TREE_GOLD};

/// The lower and the upper edge of the cell on the page.
const TOP: f32 = 66.0;
const BOTTOM: f32 = 262.0;
/// The baselines of the words about the planes.
const ROWS: [f32; 2] = [28.0, 54.0];

fn letters(color: Rgb) -> Lettering {
    Lettering::new(Plot::LETTER, color)
}

/// Where the plot has a pair of values, on the page.
fn place(plot: &Plot, position: f32, cost: f32) -> Vec2 {
    plot.place(Vec2::new(position, cost)) + Vec2::Y * PLOT_TOP
}

/// The boxes of the primitives, seen along an axis in which the plane does not move.
pub(super) fn draw_cell(page: &mut Drawing, cell: &Cell, axis: usize, plot: &Plot) {
    let upward = (axis + 1) % 3;
    let (low, high) = (cell.aabb.min[upward], cell.aabb.max[upward]);
    let corner = |across: f32, up: f32| {
        Vec2::new(place(plot, across, 0.0).x, BOTTOM + (TOP - BOTTOM) * (up - low) / (high - low))
    };
    for (aabb, is_cell) in [(&cell.aabb, true)].into_iter().chain(cell.boxes.iter().map(|(_, aabb)| (aabb, false))) {
        let (min, max) = (aabb.min, aabb.max);
        let corners = [(min, min), (max, min), (max, max), (min, max)].map(|(a, b)| corner(a[axis], b[upward]));
        let [a, b, c, d] = corners;
        let (fill, opacity, pen) = match is_cell {
            true => (GRID, 0.35, Pen::new(FAINT, 1.6)),
            false => (CHALK, 0.16, Pen::new(CHALK, 1.4)),
        };
        page.polygon(&corners, fill, opacity).line(&[a, b, c, d, a], pen);
    }
}

/// The cost of leaving the cell whole.
pub(super) fn draw_whole(page: &mut Drawing, cell: &Cell, axis: usize, plot: &Plot) {
    let [left, right] = plot.x.range.map(|end| place(plot, end, cell.whole()));
    page.line(&[left, right], Pen { dashes: Some([9.0, 7.0]), ..Pen::new(CHALK, 1.6) });
    let words = format!("left whole: {} tests, cost {:.2}", cell.boxes.len(), cell.whole());
    // On the other side of the line than the end of the curve.
    let is_dear = cell.cost(axis, plot.x.range[1]) > cell.whole();
    let beside = Vec2::new(-4.0, if is_dear { 22.0 } else { -8.0 });
    page.text(&words, right + beside, letters(CHALK).aligned(Align::Right));
}

/// The plane through the median, and over it the one of least cost, each if it is at right angles to the axis.
pub(super) fn draw_planes(page: &mut Drawing, cell: &Cell, axis: usize, plot: &Plot, splits: [Option<Split>; 2]) {
    let here = splits.map(|split| split.filter(|split| split.axis == axis));
    let x = here.map(|split| split.map_or(0.0, |split| place(plot, split.position, 0.0).x));
    // The words of neither cross the line of the other: those that would reach over it stand above its end.
    let rows = if (x[0] < x[1]) == is_left(x[0]) { [ROWS[0], ROWS[1]] } else { [ROWS[1], ROWS[0]] };
    let pens = [Pen { dashes: Some([5.0, 5.0]), ..Pen::new(FAINT, 2.0) }, Pen::new(KD_TREE_GOLD, 2.4)];
    for (i, name) in ["median", "chosen"].into_iter().enumerate() {
        let (pen, row) = (pens[i], rows[i]);
        if let Some(Split { position, .. }) = here[i] {
            draw_plane(page, [position, cell.cost(axis, position)], plot, pen, row);
            describe(page, name, cell, axis, position, Vec2::new(x[i], row), pen.color);
            continue;
        }
        let words = match (splits[i], name) {
            (Some(Split { axis, .. }), "median") => format!("The median rule halves across {}.", NAMES[axis]),
            (Some(Split { axis, .. }), _) => format!("The cheapest plane is at right angles to {}.", NAMES[axis]),
            (None, _) => "No plane is cheaper than to leave the cell whole.".into(),
        };
        let right = Vec2::new(place(plot, plot.x.range[1], 0.0).x, ROWS[i]);
        page.text(&words, right, letters(pen.color).aligned(Align::Right));
    }
}

/// A line through the cell and the plot, with a dot on the curve.
fn draw_plane(page: &mut Drawing, [position, cost]: [f32; 2], plot: &Plot, pen: Pen, words: f32) {
    let (foot, dot) = (place(plot, position, plot.y.range[0]), place(plot, position, cost));
    page.line(&[Vec2::new(foot.x, words + 6.0), foot], pen);
    page.disc(dot, 7.0, SLATE).disc(dot, 5.2, pen.color);
}

/// What a plane costs, and how many primitives are on its sides.
fn describe(page: &mut Drawing, name: &str, cell: &Cell, axis: usize, position: f32, at: Vec2, color: Rgb) {
    let ([lower, upper], cost) = (cell.counts(axis, position), cell.cost(axis, position));
    let words = format!("{name}: {lower} | {upper}, cost {cost:.2}");
    let (shift, align) = if is_left(at.x) { (6.0, Align::Left) } else { (-6.0, Align::Right) };
    page.text(&words, at + Vec2::X * shift, letters(color).aligned(align));
}

/// Whether there is more room at the right of a place.
fn is_left(x: f32) -> bool {
    x < super::PAGE.x / 2.0
}
