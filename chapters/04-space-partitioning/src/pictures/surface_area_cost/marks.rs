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
/// The baselines of the words about the chosen plane and about the median.
const CHOSEN: f32 = 28.0;
const MEDIAN: f32 = 54.0;

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
pub(super) fn draw_whole(page: &mut Drawing, cell: &Cell, plot: &Plot) {
    let [left, right] = plot.x.range.map(|end| place(plot, end, cell.whole()));
    page.line(&[left, right], Pen { dashes: Some([9.0, 7.0]), ..Pen::new(CHALK, 1.6) });
    let words = format!("left whole: {} tests", cell.boxes.len());
    page.text(&words, right + Vec2::new(-4.0, -8.0), letters(CHALK).aligned(Align::Right));
}

/// The plane through the median, if it is at right angles to the axis.
pub(super) fn draw_median(page: &mut Drawing, cell: &Cell, axis: usize, split: Option<Split>, plot: &Plot) {
    let Some(split) = split else { return };
    if split.axis != axis {
        let words = format!("The median rule halves across {}, the longest side.", NAMES[split.axis]);
        page.text(&words, Vec2::new(place(plot, plot.x.range[0], 0.0).x, MEDIAN), letters(FAINT));
        return;
    }
    let cost = cell.cost(axis, split.position);
    let pen = Pen { dashes: Some([5.0, 5.0]), ..Pen::new(FAINT, 2.0) };
    draw_plane(page, [split.position, cost], plot, pen, MEDIAN);
    describe(page, "median", [split.position, cost], cell.counts(axis, split.position), plot, FAINT, MEDIAN);
}

/// The plane of least cost, if it is at right angles to the axis.
pub(super) fn draw_chosen(page: &mut Drawing, cell: &Cell, axis: usize, split: Option<Split>, plot: &Plot) {
    let left = Vec2::new(place(plot, plot.x.range[0], 0.0).x, CHOSEN);
    match split {
        None => {
            page.text("No plane is cheaper than to leave the cell whole.", left, letters(KD_TREE_GOLD));
        }
        Some(Split { axis: other, .. }) if other != axis => {
            let words = format!("The cheapest plane is at right angles to {}.", NAMES[other]);
            page.text(&words, left, letters(KD_TREE_GOLD));
        }
        Some(Split { position, cost, .. }) => {
            draw_plane(page, [position, cost], plot, Pen::new(KD_TREE_GOLD, 2.4), CHOSEN);
            let counts = cell.counts(axis, position);
            describe(page, "chosen", [position, cost], counts, plot, KD_TREE_GOLD, CHOSEN);
        }
    }
}

/// A line through the cell and the plot, with a dot on the curve.
fn draw_plane(page: &mut Drawing, [position, cost]: [f32; 2], plot: &Plot, pen: Pen, words: f32) {
    let (foot, dot) = (place(plot, position, plot.y.range[0]), place(plot, position, cost));
    page.line(&[Vec2::new(foot.x, words + 6.0), foot], pen);
    page.disc(dot, 7.0, SLATE).disc(dot, 5.2, pen.color);
}

/// What a plane costs, and how many primitives are on its sides.
fn describe(
    page: &mut Drawing,
    name: &str,
    [position, cost]: [f32; 2],
    [lower, upper]: [usize; 2],
    plot: &Plot,
    color: Rgb,
    at: f32,
) {
    let words = format!("{name}: {lower} | {upper}, cost {cost:.2}");
    let x = place(plot, position, 0.0).x;
    // On the side where there is more room.
    let (shift, align) = if x > super::PAGE.x / 2.0 { (-6.0, Align::Right) } else { (6.0, Align::Left) };
    page.text(&words, Vec2::new(x + shift, at), letters(color).aligned(align));
}
