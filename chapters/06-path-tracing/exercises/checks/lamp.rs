//! A lamp with a size.

use common::{Rgb, Vec2, Vec3};

use super::quad::Quad;

/// A flat lamp that glows on both sides: the points `corner + x · edges[0] + y · edges[1]` with x and y from 0 to 1. If the
/// edges meet at a right angle, it is a rectangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lamp {
    /// One of its corners.
    pub(crate) corner: Vec3,
    /// The two edges that meet there.
    pub(crate) edges: [Vec3; 2],
    /// What it sends out in all directions.
    pub(crate) radiance: Rgb,
}

/// A point of a lamp that was chosen by chance, as it is seen from somewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LampSample {
    /// Unit vector toward the point.
    pub(crate) direction: Vec3,
    /// How far away it is.
    pub(crate) distance: f32,
    /// How likely this direction was, per steradian; 0 for a sample that is to be dropped.
    pub(crate) density: f32,
}

impl Lamp {
    /// The one around `center`, by half of its two edges.
    pub(crate) fn around(center: Vec3, halves: [Vec3; 2], radiance: Rgb) -> Self {
        let Quad { corner, edges } = Quad::around(center, halves);
        Self { corner, edges, radiance }
    }

    /// Its shape.
    pub(crate) fn quad(&self) -> Quad {
        Quad { corner: self.corner, edges: self.edges }
    }

    /// A point of it.
    pub(crate) fn at(&self, u: Vec2) -> Vec3 {
        self.corner + self.edges[0] * u.x + self.edges[1] * u.y
    }
}
