//! A triangle in which weights are found in f64.

use common::Vec3;
use glam::DVec3;

use super::words::triple;

/// Parts of each side in the χ² test: the triangle falls into their square of small ones of equal area.
pub(super) const PARTS: u8 = 9;

/// A triangle.
#[derive(Clone, Copy)]
pub(super) struct Triangle {
    pub(super) corners: [Vec3; 3],
}

impl Triangle {
    pub(super) fn exact(&self) -> [DVec3; 3] {
        self.corners.map(|corner| corner.as_dvec3())
    }

    /// Twice its area, with its direction.
    pub(super) fn cross(&self) -> DVec3 {
        let [r1, r2, r3] = self.exact();
        (r2 - r1).cross(r3 - r1)
    }

    /// The weights of the point of its plane that is nearest to `point`.
    pub(super) fn weights(&self, point: DVec3) -> [f64; 3] {
        let ([r1, r2, r3], cross) = (self.exact(), self.cross());
        let share = |a: DVec3, b: DVec3| (a - point).cross(b - point).dot(cross) / cross.length_squared();
        [share(r2, r3), share(r3, r1), share(r1, r2)]
    }

    pub(super) fn words(&self) -> String {
        let [r1, r2, r3] = self.corners.map(triple);
        format!("the triangle {r1}, {r2}, {r3}")
    }
}

/// The small triangle that a point lies in.
pub(super) fn part(weights: [f64; 3]) -> usize {
    let parts = f64::from(PARTS);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to the number of parts")]
    let [row, along, across] = weights.map(|weight| (weight.clamp(0.0, 1.0 - 1e-12) * parts) as usize);
    // Rows of 2n − 1 small triangles; in each row those that point up and those that point down alternate.
    let longest = usize::from(PARTS) - row;
    let before: usize = (0..row).map(|row| 2 * (usize::from(PARTS) - row) - 1).sum();
    let points_up = row + along + across + 1 == usize::from(PARTS);
    before + if points_up { along.min(longest - 1) } else { longest + along.min(longest.saturating_sub(2)) }
}
