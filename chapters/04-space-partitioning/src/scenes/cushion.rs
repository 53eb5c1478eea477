//! Cushions: boxes with round edges.

use common::{Vec3, float};
use ray_casting::frame::Frame;

use super::builder::Builder;

/// How far a point is from the middle if all points of a cushion's surface are at the distance 1. The power is 2 for a
/// ball, and the higher it is, the nearer to a box.
#[must_use]
pub fn distance(point: Vec3, power: f32) -> f32 {
    let sum: f32 = point.to_array().iter().map(|c| float::pow(c.abs(), power)).sum();
    float::pow(sum, 1.0 / power)
}

impl Builder {
    /// A box with round edges: the higher the power, the sharper. It costs as much as its surface of so many columns
    /// and rows, see [`Builder::closed_surface`].
    pub fn cushion(&mut self, frame: &Frame, center: Vec3, half: Vec3, steps: [u32; 2], power: f32) {
        self.closed_surface(steps, |p| frame.point_to_world(center + half * p / distance(p, power)));
    }
}
