//! Smooth curves through given points.
//!
//! Source: Catmull, Rom, *A Class of Local Interpolating Splines*, 1974.

use common::{Vec2, Vec3};

use super::budget::ratio;

/// A point of the smooth curve that runs through all the given points, for `t` from 0 at the first to 1 at the last.
#[must_use]
pub fn on_spline(points: &[Vec3], t: f32) -> Vec3 {
    let last = points.len() - 1;
    let along = t.clamp(0.0, 1.0) * last as f32;
    let i = (along as usize).min(last.saturating_sub(1));
    on_piece(points, i, along - i as f32)
}

/// A point of the curve between the points number `i` and `i + 1`, for `u` from 0 to 1.
fn on_piece(points: &[Vec3], i: usize, u: f32) -> Vec3 {
    let [before, from, to, after] = [i.saturating_sub(1), i, i + 1, i + 2].map(|i| points[i.min(points.len() - 1)]);
    let (slope, next_slope) = ((to - before) / 2.0, (after - from) / 2.0);
    let bend = 3.0 * (to - from) - 2.0 * slope - next_slope;
    let twist = 2.0 * (from - to) + slope + next_slope;
    from + u * (slope + u * (bend + u * twist))
}

/// A half section through the same points with so many steps between two of them, on the same curve. No point but the
/// last lies on the axis.
#[must_use]
pub fn finer(points: &[Vec2], steps: u32) -> Vec<Vec2> {
    let points: Vec<Vec3> = points.iter().map(|point| point.extend(0.0)).collect();
    let pieces = (0..points.len() - 1).flat_map(|i| (0..steps).map(move |step| (i, ratio(step, steps))));
    let line = pieces.map(|(i, u)| on_piece(&points, i, u).truncate().max(Vec2::new(0.01, 0.0)));
    line.chain(points.last().map(|last| last.truncate())).collect()
}
