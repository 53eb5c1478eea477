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
    let u = along - i as f32;
    let [before, from, to, after] = [i.saturating_sub(1), i, i + 1, i + 2].map(|i| points[i.min(last)]);
    let (slope, next_slope) = ((to - before) / 2.0, (after - from) / 2.0);
    let bend = 3.0 * (to - from) - 2.0 * slope - next_slope;
    let twist = 2.0 * (from - to) + slope + next_slope;
    from + u * (slope + u * (bend + u * twist))
}

/// A line through the same points with so many steps between two of them, on the same curve. It is a half section: no
/// point but the last lies on the axis.
#[must_use]
pub fn finer(points: &[Vec2], steps: u32) -> Vec<Vec2> {
    let at = |i: usize| points[i.min(points.len() - 1)];
    let mut line = vec![];
    for i in 0..points.len() - 1 {
        let [a, b, c, d] = [at(i.saturating_sub(1)), at(i), at(i + 1), at(i + 2)];
        for step in 0..steps {
            let t = ratio(step, steps);
            let bent = b * 2.0
                + (c - a) * t
                + (a * 2.0 - b * 5.0 + c * 4.0 - d) * (t * t)
                + (b * 3.0 - a - c * 3.0 + d) * (t * t * t);
            line.push((bent * 0.5).max(Vec2::new(0.01, 0.0)));
        }
    }
    line.push(at(points.len() - 1));
    line
}
