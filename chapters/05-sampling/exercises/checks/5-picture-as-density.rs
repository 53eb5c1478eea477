//! Checks exercise 5.5, a picture as a density.

use common::{
    Stream,
    exercise::{Diagnosis, Finding, Verdict, expect, trying},
};

use super::{
    density_mistakes::judge,
    table::{Table, before, cumulative_of, invert_of},
    words::number,
};

/// What the student writes.
#[derive(Clone, Copy)]
pub(crate) struct Answer {
    /// The cumulative distribution of weights.
    pub(crate) cumulative: fn(&[f64]) -> Vec<f64>,
    /// The cell of a number, and where within.
    pub(crate) invert: fn(&[f64], f64) -> (usize, f64),
    /// A point and its density.
    pub(crate) sample_table: fn(&Table, [f64; 2]) -> ([f64; 2], f64),
    /// The density of a point.
    pub(crate) table_pdf: fn(&Table, [f64; 2]) -> f64,
}

/// Lists of weights that are tried.
const LISTS: [&[f64]; 9] = [
    &[1.0, 0.0, 2.0, 1.0],
    &[1.0],
    &[0.0, 0.0, 3.0, 0.0, 5.0, 0.0, 0.0],
    &[0.1, 0.2, 0.2, 0.6, 0.3, 0.0],
    &[0.7, 0.7, 0.1],
    &[1e-9, 1.0, 1e-9],
    &[1e6, 1e-6, 1e6],
    &[0.0, 0.0, 0.0, 0.0],
    &[7.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0],
];
/// How far rounding may carry a number.
pub(super) const ROUNDING: f64 = 1e-9;

/// Accept a table, or name what is wrong with it.
pub(crate) fn check(answer: Answer) -> Verdict {
    let cumulative = |weights: &[f64]| trying(|| tried_cumulative(weights), || (answer.cumulative)(weights));
    let invert = |sums: &[f64], u: f64| trying(|| tried_invert(sums, u), || (answer.invert)(sums, u));
    if cumulative(LISTS[0]).is_empty() {
        return Err(Diagnosis::not_started("`cumulative` returns no numbers at all."));
    }
    LISTS.into_iter().try_for_each(|weights| sums(weights, &cumulative(weights)))?;
    let first = cumulative_of(LISTS[0]);
    let is_started = [0.1, 0.3, 0.9].into_iter().any(|u| invert(&first, u) != (0, 0.0));
    expect(is_started, "invert-not-started", || {
        "`cumulative` is right. Now for `invert`, which always returns the start of cell 0.".into()
    })?;
    let mut random = Stream::new(58, 0, 0);
    for sums in LISTS.map(cumulative_of) {
        let borders = std::iter::once(0.0).chain(sums.clone()).flat_map(|x| [x.next_down(), x, x.next_up()]);
        let borders: Vec<f64> = borders.filter(|u| (0.0..1.0).contains(u)).collect();
        let drawn: Vec<f64> = (0..200).map(|_| f64::from(random.uniform())).collect();
        drawn.into_iter().chain(borders).try_for_each(|u| inverted(&sums, u, &|u| invert(&sums, u)))?;
    }
    judge(answer)
}

pub(super) fn list(numbers: &[f64]) -> String {
    let words: Vec<String> = numbers.iter().map(|x| number(*x)).collect();
    format!("({})", words.join(", "))
}

fn tried_cumulative(weights: &[f64]) -> String {
    let weights: Vec<String> = weights.iter().map(ToString::to_string).collect();
    format!("`cumulative` of the weights ({})", weights.join(", "))
}

fn tried_invert(sums: &[f64], u: f64) -> String {
    format!("`invert` of the cumulative distribution {} and u = {u}", list(sums))
}

/// A cumulative distribution.
fn sums(weights: &[f64], got: &[f64]) -> Verdict {
    let right = cumulative_of(weights);
    let is = |other: &[f64]| got.len() == other.len() && got.iter().zip(other).all(|(a, b)| (a - b).abs() <= ROUNDING);
    let total: f64 = weights.iter().sum();
    let whole: Vec<f64> = right.iter().map(|sum| sum * total).collect();
    let shifted: Vec<f64> = (0..right.len()).map(|i| before(&right, i)).collect();
    let with_zero: Vec<f64> = std::iter::once(0.0).chain(right.clone()).collect();
    let shares: Vec<f64> = weights.iter().map(|weight| weight / total).collect();
    let (name, advice) = if is(&right) {
        let last = got.last().copied().unwrap_or_default();
        let cell = weights.iter().rposition(|weight| *weight > 0.0).unwrap_or(weights.len() - 1);
        if last == 1.0 && got[cell] == 1.0 {
            return Ok(());
        }
        let got = format!("{last:?} at the end, and {:?} for the last cell that has a weight", got[cell]);
        let advice = "After rounding the sum is a little off 1. Then a u near 1 finds no cell, or one without weight. Divide all sums \
                      by the last of them.";
        let (tried, expected) = (tried_cumulative(weights), "exactly 1 for both".into());
        return Err(Finding { tried, got, expected, advice: advice.into() }.named("last-is-not-one"));
    } else if total == 0.0 {
        ("all-zero", "All weights are 0, and nothing can be divided by their sum. Then all cells are equally likely.")
    } else if is(&whole) {
        ("not-normalized", "The sums are right, but they must end at 1: divide them by the sum of all.")
    } else if is(&shifted) || is(&with_zero) {
        (
            "starts-at-zero",
            "Number i is the sum up to the end of cell i, so the first is the share of the first cell and not 0.",
        )
    } else if is(&shares) {
        ("not-added-up", "These are the shares of the cells. Add them up from the left.")
    } else {
        ("wrong-cumulative", "Work this list out on paper: add up from the left, and divide by the sum of all.")
    };
    let expected = list(&right);
    Err(Finding { tried: tried_cumulative(weights), got: list(got), expected, advice: advice.into() }.named(name))
}

/// A number found in a cumulative distribution.
fn inverted(sums: &[f64], u: f64, invert: &dyn Fn(f64) -> (usize, f64)) -> Verdict {
    let (cell, within) = invert(u);
    let (right_cell, right_within) = invert_of(sums, u);
    let told = |cell: usize, within: f64| format!("cell {cell}, {} of the way through it", number(within));
    // In a narrow cell a step of u is a long way.
    let width = sums[right_cell] - before(sums, right_cell);
    let slack = ROUNDING + f64::EPSILON * 4.0 / width;
    let (name, advice) = if cell != right_cell {
        let is_empty = cell < sums.len() && sums[cell] - before(sums, cell) <= 0.0;
        if sums.get(cell) == Some(&u) {
            (
                "end-of-the-cell",
                "u lies at the very end of this cell, and so belongs to the next one that has weight. Ask for a sum \
                                 that is greater than u, not equal to it.",
            )
        } else if is_empty {
            ("empty-cell", "This cell has no weight and must never be found.")
        } else if cell + 1 == right_cell || cell == right_cell + 1 {
            (
                "neighboring-cell",
                "This is a neighbor of the right cell. Cell i begins at the sum before it and ends before its own.",
            )
        } else {
            (
                "wrong-cell",
                "Go through the sums from the left: the first one that is greater than u belongs to the cell.",
            )
        }
    } else if within >= 1.0 {
        (
            "beyond-the-cell",
            "Where within the cell is at least 0 and below 1. Rounding can make it 1: take the smaller of it and \
                             `BELOW_ONE`.",
        )
    } else if (within - right_within).abs() <= slack && within >= 0.0 {
        return Ok(());
    } else if (within - (u - before(sums, cell))).abs() <= slack {
        (
            "not-stretched",
            "This is how far u lies behind the sum before the cell. Divide that by the share of the cell.",
        )
    } else {
        ("wrong-place", "Within the cell u goes evenly from 0, at the sum before the cell, to 1, at its own.")
    };
    let (got, expected) = (told(cell, within), told(right_cell, right_within));
    Err(Finding { tried: tried_invert(sums, u), got, expected, advice: advice.into() }.named(name))
}
