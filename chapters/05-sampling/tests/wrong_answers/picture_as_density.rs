//! Wrong tables.

use common::Stream;

use crate::{
    checks::{
        picture_as_density::{Answer, check},
        table::{Table, cumulative_of, invert_of, sample_of, share_of},
        tally::Tally,
    },
    name,
};

pub(crate) fn invert(sums: &[f64], u: f64) -> (usize, f64) {
    let (cell, within) = invert_of(sums, u);
    (cell, within.min(1.0 - f64::EPSILON / 2.0))
}

/// The number of cells of a table along x and along y.
pub(crate) fn sides(table: &Table) -> [f64; 2] {
    [table.columns[0].len() as f64, table.rows.len() as f64]
}

pub(crate) fn table_pdf(table: &Table, [x, y]: [f64; 2]) -> f64 {
    let [columns, rows] = sides(table);
    share_of(table, [(x * columns) as usize, (y * rows) as usize]) * columns * rows
}

pub(crate) const RIGHT: Answer = Answer { cumulative: cumulative_of, invert, sample_table: sample_of, table_pdf };

/// The diagnosis of such sums.
fn sums(cumulative: fn(&[f64]) -> Vec<f64>) -> &'static str {
    name(check(Answer { cumulative, ..RIGHT }))
}

/// The diagnosis of such an inversion.
fn inversions(invert: fn(&[f64], f64) -> (usize, f64)) -> &'static str {
    name(check(Answer { invert, ..RIGHT }))
}

/// The sums without the last care.
fn plain(weights: &[f64]) -> Vec<f64> {
    let total: f64 = weights.iter().sum();
    let add = |sum: &mut f64, weight: &f64| {
        *sum += if total > 0.0 { weight / total } else { 1.0 / weights.len() as f64 };
        Some(*sum)
    };
    weights.iter().scan(0.0, add).collect()
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(check(RIGHT), Ok(()));
}

/// The samples of the right answer fall into the cells as their weights say.
#[test]
fn right_samples_pass_the_chi_square_test() {
    let weights = [1.0, 2.0, 3.0, 0.5, 4.0, 2.0, 0.0, 1.0, 7.0];
    let total: f64 = weights.iter().sum();
    let table = Table::new(cumulative_of, 3, &weights);
    let mut tally = Tally::new(weights.map(|weight| weight / total).to_vec());
    let mut random = Stream::new(1, 0, 0);
    for _ in 0..100_000 {
        let ([x, y], pdf) = sample_of(&table, [(); 2].map(|()| random.uniform().into()));
        assert!((pdf - table_pdf(&table, [x, y])).abs() < 1e-9);
        tally.add((y * 3.0) as usize * 3 + (x * 3.0) as usize);
    }
    assert!(tally.fits(), "{}", tally.got());
}

#[test]
fn nothing_is_not_started() {
    let nothing = Answer {
        cumulative: |_| vec![],
        invert: |_, _| (0, 0.0),
        sample_table: |_, _| ([0.0; 2], 0.0),
        table_pdf: |_, _| 0.0,
    };
    assert_eq!(name(check(nothing)), "not-started");
    assert_eq!(inversions(nothing.invert), "invert-not-started");
    let only = |answer: Answer| name(check(answer));
    assert_eq!(only(Answer { sample_table: nothing.sample_table, ..RIGHT }), "sample-not-started");
    assert_eq!(only(Answer { table_pdf: nothing.table_pdf, ..RIGHT }), "pdf-not-started");
}

#[test]
fn wrong_sums() {
    assert_eq!(
        sums(|weights| {
            let total: f64 = weights.iter().sum();
            cumulative_of(weights).iter().map(|sum| sum * total).collect()
        }),
        "not-normalized"
    );
    assert_eq!(sums(|weights| std::iter::once(0.0).chain(cumulative_of(weights)).collect()), "starts-at-zero");
    assert_eq!(
        sums(|weights| std::iter::once(0.0).chain(cumulative_of(weights)).take(weights.len()).collect()),
        "starts-at-zero"
    );
    assert_eq!(
        sums(|weights| {
            let total: f64 = weights.iter().sum();
            weights.iter().map(|weight| weight / total).collect()
        }),
        "not-added-up"
    );
    assert_eq!(sums(|weights| cumulative_of(weights).into_iter().rev().collect()), "wrong-cumulative");
    assert_eq!(sums(plain), "last-is-not-one");
    // Set to 1 at the end, where the last weight is 0.
    assert_eq!(
        sums(|weights| {
            let mut sums = plain(weights);
            if let Some(last) = sums.last_mut() {
                *last = 1.0;
            }
            sums
        }),
        "last-is-not-one"
    );
    assert_eq!(
        sums(|weights| {
            let total: f64 = weights.iter().sum();
            cumulative_of(weights).iter().map(|sum| sum * total / total).collect()
        }),
        "all-zero"
    );
}

#[test]
fn wrong_inversions() {
    assert_eq!(
        inversions(|sums, u| {
            let cell = sums.iter().position(|sum| *sum >= u).unwrap_or_default();
            (cell, if cell == invert(sums, u).0 { invert(sums, u).1 } else { 0.0 })
        }),
        "end-of-the-cell"
    );
    assert_eq!(inversions(|sums, u| (invert(sums, u).0.saturating_sub(1), invert(sums, u).1)), "empty-cell");
    assert_eq!(inversions(|sums, u| (invert(sums, u).0 + 1, invert(sums, u).1)), "neighboring-cell");
    assert_eq!(inversions(|sums, u| (invert(sums, u).0.max(2), invert(sums, u).1)), "wrong-cell");
    assert_eq!(
        inversions(|sums, u| {
            let cell = sums.partition_point(|sum| *sum <= u);
            (if cell == 3 { 2 } else { cell }, invert(sums, u).1)
        }),
        "neighboring-cell"
    );
    assert_eq!(inversions(invert_of_rounded), "beyond-the-cell");
    assert_eq!(
        inversions(|sums, u| {
            let (cell, within) = invert(sums, u);
            let before = if cell == 0 { 0.0 } else { sums[cell - 1] };
            (cell, within * (sums[cell] - before))
        }),
        "not-stretched"
    );
    assert_eq!(inversions(|sums, u| (invert(sums, u).0, 0.5)), "wrong-place");
    assert_eq!(inversions(|sums, u| (invert(sums, u).0, u)), "wrong-place");
}

/// Where rounding makes the place within a cell 1, it stays so.
fn invert_of_rounded(sums: &[f64], u: f64) -> (usize, f64) {
    let (cell, within) = invert_of(sums, u);
    (cell, if within > 1.0 - 1e-12 { 1.0 } else { within })
}
