//! Pearson's χ² test: do samples fall into cells as often as they should?

use common::float;

// ANCHOR: chi_square
/// How far counts are from what is expected: `Σ (count − expected)² / expected` over all cells.
///
/// It is about one less than the number of cells if the samples are right. Cells in which nothing is expected are
/// left out; every other cell should expect at least five samples.
#[must_use]
pub fn chi_square(counts: &[u32], expected: &[f64]) -> f64 {
    let cells = counts.iter().zip(expected).filter(|(_, expected)| **expected > 0.0);
    cells.map(|(&count, expected)| (f64::from(count) - expected) * (f64::from(count) - expected) / expected).sum()
}

/// The chance of a χ² this large or larger if all samples are right, for an even number of degrees of freedom, which
/// is one less than the number of cells. An odd number is taken for one more, which makes the chance a little greater.
///
/// For 2n degrees it is the chance of fewer than n events in a Poisson process which expects χ²/2 of them.
/// Source: Abramowitz, Stegun, *Handbook of Mathematical Functions*, 26.4.21.
#[must_use]
pub fn chance(chi_square: f64, degrees: usize) -> f64 {
    let half = chi_square / 2.0;
    let (mut log_term, mut sum) = (-half, float::exp_f64(-half));
    for i in 1..degrees.div_ceil(2) {
        log_term += float::ln_f64(half / i as f64);
        sum += float::exp_f64(log_term);
    }
    sum
}
// ANCHOR_END: chi_square

#[cfg(test)]
mod tests {
    use super::*;

    /// From tables of the χ² distribution.
    #[test]
    fn the_chance_is_that_of_tables() {
        for (degrees, chi_square, expected) in
            [(2, 5.991, 0.05), (10, 18.307, 0.05), (30, 50.892, 0.01), (100, 124.342, 0.05), (100, 149.449, 0.001)]
        {
            let chance = chance(chi_square, degrees);
            assert!((chance / expected - 1.0).abs() < 1e-3, "{degrees}: {chance}");
        }
        assert_eq!(chance(1e9, 116), 0.0);
        assert!((chance(0.0, 4) - 1.0).abs() < 1e-15);
        // From the table of 9 degrees: the chance is told too great, not too small.
        assert_eq!(chance(16.919, 9), chance(16.919, 10));
        assert!(chance(16.919, 9) > 0.05);
    }

    #[test]
    fn a_fair_die_and_a_loaded_one() {
        let expected = [10.0; 6];
        assert_eq!(chi_square(&[10; 6], &expected), 0.0);
        assert!((chi_square(&[5, 8, 9, 8, 10, 20], &expected) - 13.4).abs() < 1e-12);
        // What cannot happen has no share in it.
        assert_eq!(chi_square(&[3, 5], &[0.0, 5.0]), 0.0);
    }
}
