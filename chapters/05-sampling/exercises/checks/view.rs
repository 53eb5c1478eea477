//! A viewer of a surface with a lobe.

use common::{Basis, Vec3, float};

use super::{phong_lobe::CELLS, words::triple};

/// A viewer of a surface with a lobe.
pub(super) struct View {
    pub(super) normal: Vec3,
    pub(super) to_viewer: Vec3,
    pub(super) exponent: f32,
}

impl View {
    /// The view at an angle to the normal, in degrees.
    pub(super) fn at(normal: Vec3, degrees: f32, exponent: f32) -> Self {
        let (normal, angle) = (normal.normalize(), degrees.to_radians());
        let across = Basis::around(normal).to_world(Vec3::new(0.6, 0.8, 0.0));
        Self { normal, to_viewer: normal * float::cos(angle) + across * float::sin(angle), exponent }
    }

    pub(super) fn mirrored(&self) -> Vec3 {
        2.0 * self.normal.dot(self.to_viewer) * self.normal - self.to_viewer
    }

    pub(super) fn words(&self) -> String {
        let (normal, to_viewer) = (triple(self.normal), triple(self.to_viewer));
        format!("`sample_glossy` with normal {normal}, to_viewer {to_viewer}, exponent {}", self.exponent)
    }

    /// The shares of all cells around the mirror direction, above the surface, and at the end the share below it.
    pub(super) fn shares(&self) -> Vec<f64> {
        const PIECES: u16 = 24;
        let basis = Basis::around(self.mirrored());
        let [rows, columns] = CELLS.map(u16::from);
        let mut shares = vec![0.0; usize::from(rows * columns) + 1];
        let all = f64::from(rows * PIECES) * f64::from(columns * PIECES);
        let at = |i: u16, cells: u16| (f32::from(i) + 0.5) / f32::from(cells * PIECES);
        for (i, j) in (0..rows * PIECES).flat_map(|i| (0..columns * PIECES).map(move |j| (i, j))) {
            let height = float::pow(at(i, rows), 1.0 / (self.exponent + 1.0));
            let (angle, radius) = (std::f32::consts::TAU * at(j, columns), (1.0 - height * height).sqrt());
            let local = Vec3::new(radius * float::cos(angle), radius * float::sin(angle), height);
            let is_above = basis.to_world(local).dot(self.normal) > 0.0;
            let cell = if is_above { usize::from(i / PIECES * columns + j / PIECES) } else { shares.len() - 1 };
            shares[cell] += 1.0 / all;
        }
        shares
    }
}
