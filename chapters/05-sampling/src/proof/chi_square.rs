//! Pearson's χ² test: do samples fall into the cells of the domain as often as their density says?

use common::{Stream, float};

use super::{
    chart::mean,
    subjects::{SUBJECTS, Subject},
};

/// Samples of one test.
const COUNT: u32 = 1_000_000;
/// Cells along the two sides of the unit square. The product is odd even where the lower half of the rows is empty, so
/// that the number of degrees of freedom is even.
const CELLS: [usize; 2] = [13, 9];
/// The chance that any of the tests fails although all samples are right.
const RISK: f64 = 1e-3;

/// The chance of a χ² this large or larger, given an even number of degrees of freedom 2n.
///
/// Then it is that of fewer than n events in a Poisson process which expects χ²/2 of them (Abramowitz, Stegun, 26.4.21).
fn tail(chi_square: f64, degrees: usize) -> f64 {
    assert!(degrees.is_multiple_of(2), "{degrees}");
    let half = chi_square / 2.0;
    let (mut log_term, mut sum) = (-half, float::exp_f64(-half));
    for i in 1..degrees / 2 {
        log_term += float::ln_f64(half / i as f64);
        sum += float::exp_f64(log_term);
    }
    sum
}

/// The chance that samples which are right differ from the density as much as these do.
pub(super) fn chance(subject: &Subject, seed: u64) -> f64 {
    let [rows, columns] = CELLS;
    let mut random = Stream::new(seed, 0, 0);
    let mut counts = vec![0_u32; rows * columns];
    for _ in 0..COUNT {
        let square = subject.domain.square_of((subject.draw)(&mut random));
        let [row, column] = [0, 1].map(|axis| (square[axis] * CELLS[axis] as f64) as usize);
        counts[row.min(rows - 1) * columns + column.min(columns - 1)] += 1;
    }
    let size = CELLS.map(|cells| 1.0 / cells as f64);
    let density = |square| (subject.pdf)(subject.domain.point_at(square)) * subject.domain.area();
    let (mut chi_square, mut cells) = (0.0, 0);
    for (i, &count) in counts.iter().enumerate() {
        let low = [i / columns, i % columns];
        let low = [low[0] as f64 * size[0], low[1] as f64 * size[1]];
        let expected = mean(low, size, 32, density) * size[0] * size[1] * f64::from(COUNT);
        if expected == 0.0 {
            if count > 0 {
                return 0.0;
            }
            continue;
        }
        // With fewer the statistic does not follow χ².
        assert!(expected > 5.0);
        chi_square += (f64::from(count) - expected) * (f64::from(count) - expected) / expected;
        cells += 1;
    }
    tail(chi_square, cells - 1)
}

/// Whether the samples pass. Bonferroni: the risk is shared by all tests.
pub(super) fn passes(subject: &Subject, seed: u64) -> bool {
    chance(subject, seed) > RISK / SUBJECTS.len() as f64
}

/// From tables of the χ² distribution.
#[test]
fn the_tail_is_that_of_tables() {
    for (degrees, chi_square, expected) in
        [(2, 5.991, 0.05), (10, 18.307, 0.05), (30, 50.892, 0.01), (100, 124.342, 0.05), (100, 149.449, 0.001)]
    {
        let tail = tail(chi_square, degrees);
        assert!((tail / expected - 1.0).abs() < 1e-3, "{degrees}: {tail}");
    }
    assert_eq!(tail(1e9, 116), 0.0);
    assert!((tail(0.0, 4) - 1.0).abs() < 1e-15);
}

#[test]
fn samples_follow_their_density() {
    for (i, subject) in SUBJECTS.iter().enumerate() {
        let chance = chance(subject, i as u64);
        println!("{}: {chance}", subject.name);
        assert!(passes(subject, i as u64), "{}: χ² this large has a chance of {chance}", subject.name);
    }
}
