//! Whether counts are as even as chance makes them.

use sampling::chi_square::{chance, chi_square};

/// A check asks a few dozen times. With this it errs less than once in a million answers.
const RISK: f64 = 1e-8;

/// How many samples fell into each of the cells of equal probability.
pub(super) struct EvenCounts(Vec<u32>);

impl EvenCounts {
    /// No samples yet.
    pub(super) fn new(cells: usize) -> Self {
        Self(vec![0; cells])
    }

    /// One more sample fell into this cell. What lies beyond the last one is counted there.
    pub(super) fn add(&mut self, cell: usize) {
        let last = self.0.len() - 1;
        self.0[cell.min(last)] += 1;
    }

    /// How many fell into each cell.
    pub(super) fn counts(&self) -> &[u32] {
        &self.0
    }

    fn chi_square(&self) -> f64 {
        let mean = f64::from(self.0.iter().sum::<u32>()) / self.0.len() as f64;
        chi_square(&self.0, &vec![mean; self.0.len()])
    }

    /// Whether even chances could have given this.
    pub(super) fn fit(&self) -> bool {
        chance(self.chi_square(), self.0.len() - 1) > RISK
    }

    /// What came out.
    pub(super) fn got(&self) -> String {
        format!("χ² = {:.0} over {} cells", self.chi_square(), self.0.len())
    }

    /// What should have come out.
    pub(super) fn wanted(&self) -> String {
        let degrees = (self.0.len() - 1) as f64;
        format!("χ² near {degrees}, and hardly ever above {:.0}", degrees + 6.0 * (2.0 * degrees).sqrt())
    }
}
