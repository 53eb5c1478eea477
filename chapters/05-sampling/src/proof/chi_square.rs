//! The χ² test of samples: do they fall into the cells of the domain as often as their density says?

use common::Stream;

use super::{
    chart::mean,
    subjects::{SUBJECTS, Subject},
};
use crate::chi_square;

/// Samples of one test.
const COUNT: u32 = 1_000_000;
/// Cells along the two sides of the unit square. The product is odd even where the lower half of the rows is empty, so
/// that the number of degrees of freedom is even.
const CELLS: [usize; 2] = [13, 9];
/// The chance that any of the tests fails although all samples are right.
const RISK: f64 = 1e-3;

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
    let expected: Vec<f64> = (0..counts.len())
        .map(|i| {
            let low = [(i / columns) as f64 * size[0], (i % columns) as f64 * size[1]];
            mean(low, size, 32, density) * size[0] * size[1] * f64::from(COUNT)
        })
        .collect();
    if counts.iter().zip(&expected).any(|(&count, &expected)| expected == 0.0 && count > 0) {
        return 0.0;
    }
    let possible = expected.iter().filter(|&&expected| expected > 0.0);
    // With fewer the statistic does not follow χ².
    assert!(possible.clone().all(|&expected| expected > 5.0));
    chi_square::chance(chi_square::chi_square(&counts, &expected), possible.count() - 1)
}

/// Whether the samples pass. Bonferroni: the risk is shared by all tests.
pub(super) fn passes(subject: &Subject, seed: u64) -> bool {
    chance(subject, seed) > RISK / SUBJECTS.len() as f64
}

#[test]
fn samples_follow_their_density() {
    for (i, subject) in SUBJECTS.iter().enumerate() {
        let chance = chance(subject, i as u64);
        println!("{}: {chance}", subject.name);
        assert!(passes(subject, i as u64), "{}: χ² this large has a chance of {chance}", subject.name);
    }
}
