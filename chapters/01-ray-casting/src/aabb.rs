//! The axis-aligned bounding box: what chapter 1 clips and frames with, and chapter 4 is built of.

use common::Vec3;

// ANCHOR: aabb
/// An axis-aligned bounding box, by its least and greatest coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Least x, y and z.
    pub min: Vec3,
    /// Greatest x, y and z.
    pub max: Vec3,
}
// ANCHOR_END: aabb

impl Aabb {
    /// All of space.
    pub const EVERYTHING: Aabb = Aabb { min: Vec3::NEG_INFINITY, max: Vec3::INFINITY };

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
