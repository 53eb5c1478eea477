//! Samples counted in cells, for the χ² test.

use sampling::chi_square::{chance, chi_square};

use super::words::about;

/// How many samples fell into each cell, and which share of them should.
pub(crate) struct Tally {
    counts: Vec<u32>,
    shares: Vec<f64>,
}

impl Tally {
    /// A check asks for χ² a few dozen times. With this it errs less than once in a million answers.
    const RISK: f64 = 1e-8;

    /// Cells that should get these shares of all samples.
    pub(crate) fn new(shares: Vec<f64>) -> Self {
        Self { counts: vec![0; shares.len()], shares }
    }

    /// Cells that should all get the same.
    pub(crate) fn even(cells: usize) -> Self {
        Self::new(vec![1.0 / cells as f64; cells])
    }

    /// One more sample fell into this cell. What lies beyond the last one is counted there.
    pub(crate) fn add(&mut self, cell: usize) {
        let last = self.counts.len() - 1;
        self.counts[cell.min(last)] += 1;
    }

    fn expected(&self) -> Vec<f64> {
        let count: u32 = self.counts.iter().sum();
        self.shares.iter().map(|share| share * f64::from(count)).collect()
    }

    fn degrees(&self) -> usize {
        self.shares.iter().filter(|share| **share > 0.0).count().saturating_sub(1)
    }

    fn chi_square(&self) -> f64 {
        chi_square(&self.counts, &self.expected())
    }

    /// Whether right samples could have fallen like this.
    pub(crate) fn fits(&self) -> bool {
        chance(self.chi_square(), self.degrees()) > Self::RISK
    }

    /// What came out.
    pub(crate) fn got(&self) -> String {
        format!("χ² = {} over {} cells", about(self.chi_square()), self.degrees() + 1)
    }

    /// What should have come out.
    pub(crate) fn wanted(&self) -> String {
        let degrees = self.degrees() as f64;
        let most = degrees + 6.0 * (2.0 * degrees).sqrt();
        format!("χ² near {degrees}, and hardly ever above {}", most.round())
    }
}
