//! The shape: anything that a ray can hit.

use common::{Interval, Vec3};

use crate::{hit::Hit, ray::Ray};

// ANCHOR: shape
/// Anything that a ray can hit. It knows neither materials nor lights nor other shapes.
pub trait Shape: Send + Sync {
    /// The nearest hit whose `t` lies inside the open interval `range`.
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit>;

    // ANCHOR: occluded
    /// Whether there is any hit at all inside `range`: the question of a shadow ray (chapter 2).
    ///
    /// A shape made of many parts may stop at the first of them that is hit.
    fn occluded(&self, ray: &Ray, range: Interval) -> bool {
        self.intersect(ray, range).is_some()
    }
    // ANCHOR_END: occluded
}
// ANCHOR_END: shape

/// The corners of an axis-aligned box: least and greatest coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Least x, y and z.
    pub min: Vec3,
    /// Greatest x, y and z.
    pub max: Vec3,
}

impl Bounds {
    /// All of space.
    pub const EVERYTHING: Bounds = Bounds { min: Vec3::NEG_INFINITY, max: Vec3::INFINITY };

    /// The smallest box around all `points`; `None` if there are none.
    #[must_use]
    pub fn around(points: &[Vec3]) -> Option<Self> {
        let min = points.iter().copied().reduce(Vec3::min)?;
        let max = points.iter().copied().reduce(Vec3::max)?;
        Some(Self { min, max })
    }

    /// Whether a point lies inside or on the box.
    #[must_use]
    pub fn contains(&self, point: Vec3) -> bool {
        point.cmpge(self.min).all() && point.cmple(self.max).all()
    }

    /// The point in the middle.
    #[must_use]
    pub fn center(&self) -> Vec3 {
        (self.min + self.max) / 2.0
    }

    /// Length of the diagonal, in scene units.
    #[must_use]
    pub fn diagonal(&self) -> f32 {
        (self.max - self.min).length()
    }
}
