//! Checks exercise 5.1, stratified samples.

use common::{
    Stream, Vec2,
    exercise::{Diagnosis, Verdict, trying},
};

use super::{
    offsets::{correlation, scattered, wrong},
    words::{number, pair},
};

/// What the student writes.
#[derive(Clone, Copy)]
pub(crate) struct Answer {
    /// One sample in each stratum.
    pub(crate) stratified: fn(u16, &mut Stream) -> Vec<f32>,
    /// One point in each cell of a grid of so many columns and rows.
    pub(crate) stratified_square: fn(u16, u16, &mut Stream) -> Vec<Vec2>,
}

/// How far rounding may carry a sample over the end of its stratum, as a share of the interval.
const ROUNDING: f64 = 1e-6;
/// Seeds of streams in which the number that decides about rounding is close to 1: that of the last of 1000 strata, drawn
/// last or first; and the same for x of 1000 points.
pub(crate) const ROUNDED: [[u64; 2]; 2] = [[2410, 60_838], [28_055, 60_838]];
/// Grids that are tried: columns and rows.
const GRIDS: [[u16; 2]; 5] = [[1, 1], [4, 4], [7, 3], [2, 9], [30, 20]];

/// Accept stratified samples, or name what is wrong with them.
pub(crate) fn check(answer: Answer) -> Verdict {
    let line = |count: u16, random: &mut Stream| {
        trying(|| format!("`stratified({count}, random)`"), || (answer.stratified)(count, random))
    };
    let square = |[columns, rows]: [u16; 2], random: &mut Stream| {
        trying(|| words([columns, rows]), || (answer.stratified_square)(columns, rows, random))
    };
    if line(5, &mut Stream::new(51, 0, 0)).is_empty() {
        return Err(Diagnosis::not_started("`stratified` returns no samples at all."));
    }
    on_the_line(&line)?;
    if square([2, 2], &mut Stream::new(51, 0, 0)).is_empty() {
        let message = "`stratified` is right. Now for `stratified_square`, which returns no points at all.";
        return Err(Diagnosis::new("square-not-started", message));
    }
    in_the_square(&square)
}

fn words([columns, rows]: [u16; 2]) -> String {
    format!("`stratified_square({columns}, {rows}, random)`")
}

/// Samples of the interval.
fn on_the_line(line: &dyn Fn(u16, &mut Stream) -> Vec<f32>) -> Verdict {
    let mut random = Stream::new(52, 0, 0);
    let mut offsets = Vec::new();
    for count in [0, 1, 2, 5, 16, 1000].into_iter().chain([100; 200]) {
        let tried = format!("`stratified({count}, random)`");
        let mut samples = line(count, &mut random);
        counted(&tried, samples.len(), count.into())?;
        samples.iter().try_for_each(|x| within(&tried, *x, || x.to_string()))?;
        samples.sort_by(f32::total_cmp);
        for (i, x) in samples.iter().map(|x| f64::from(*x)).enumerate() {
            let [low, high] = [i, i + 1].map(|i| i as f64 / f64::from(count));
            if x < low - ROUNDING || x > high + ROUNDING {
                let got = format!("sample number {i} in the order of size is {}", number(x));
                let expected = format!("one of stratum {i}, from {} to {}", number(low), number(high));
                let advice = "A stratum got no sample, and another one more than its own. Sample i comes from stratum i alone: \
                              (i + u) / count, with u from 0 to 1.";
                return Err(wrong("stratum-missed", &tried, got, expected, advice));
            }
        }
        if count == 100 {
            offsets.push(samples.iter().zip(0_u8..).map(|(x, i)| x * 100.0 - f32::from(i)).collect::<Vec<_>>());
        }
    }
    for seed in ROUNDED[0] {
        let tried = format!("`stratified(1000, random)` with `Stream::new({seed}, 0, 0)`");
        line(1000, &mut Stream::new(seed, 0, 0)).iter().try_for_each(|x| within(&tried, *x, || x.to_string()))?;
    }
    scattered("`stratified(100, random)`", &offsets)
}

/// Points of the square.
fn in_the_square(square: &dyn Fn([u16; 2], &mut Stream) -> Vec<Vec2>) -> Verdict {
    let mut random = Stream::new(53, 0, 0);
    for grid in GRIDS.into_iter().chain([[0, 3], [3, 0]]) {
        let (tried, [columns, rows]) = (words(grid), grid.map(usize::from));
        let points = square(grid, &mut random);
        counted(&tried, points.len(), columns * rows)?;
        let mut hit = vec![false; columns * rows];
        for point in points {
            within(&tried, point.min_element(), || pair(point))?;
            within(&tried, point.max_element(), || pair(point))?;
            hit[cell(point, grid)] = true;
        }
        // One point may lie on a border, by rounding.
        if hit.iter().filter(|hit| !**hit).count() > usize::from(columns * rows > 100) {
            let empty = hit.iter().position(|hit| !hit).unwrap_or_default();
            let got = format!("no point in column {}, row {}", empty % columns, empty / columns);
            let advice = "The number of points is right, but some cells have two and others none. Are columns along x and rows \
                          along y? Does each point get the offset of its own cell?";
            return Err(wrong("cell-missed", &tried, got, "one in every cell".into(), advice));
        }
    }
    for seed in ROUNDED[1] {
        let tried = format!("{} with `Stream::new({seed}, 0, 0)`", words([1000, 1]));
        let points = square([1000, 1], &mut Stream::new(seed, 0, 0));
        points.iter().try_for_each(|point| within(&tried, point.max_element(), || pair(*point)))?;
    }
    let grid = [10, 10];
    let offsets = |axis: usize, random: &mut Stream| -> Vec<f32> {
        let mut points = square(grid, random);
        points.sort_by_key(|point| cell(*point, grid));
        points.iter().map(|point| (point[axis] * 10.0).fract()).collect()
    };
    let (mut across, mut up, mut both) = (Vec::new(), Vec::new(), Vec::new());
    for seed in 0..200 {
        let [x, y] = [0, 1].map(|axis| offsets(axis, &mut Stream::new(54, seed, 0)));
        both.extend(x.iter().copied().zip(y.iter().copied()));
        across.push(x);
        up.push(y);
    }
    for offsets in [across, up] {
        scattered(&words(grid), &offsets)?;
    }
    let slope = correlation(both.into_iter());
    if slope.abs() > 0.05 {
        let got = format!("offsets along x and y with a correlation of {}", number((slope * 100.0).round() / 100.0));
        let advice = "x and y of a point go together, so that all points lie along a line of their cells. Draw two random \
                      numbers for each point.";
        return Err(wrong("diagonal", &words(grid), got, "a correlation near 0".into(), advice));
    }
    Ok(())
}

/// The cell of a point, counted row by row.
fn cell(point: Vec2, [columns, rows]: [u16; 2]) -> usize {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to the number of cells")]
    let [column, row] = [(point.x, columns), (point.y, rows)]
        .map(|(x, cells)| usize::from(((x * f32::from(cells)) as u16).min(cells.saturating_sub(1))));
    row * usize::from(columns) + column
}

fn counted(tried: &str, got: usize, expected: usize) -> Verdict {
    let advice = "One sample for each stratum, no more and no fewer: is there a loop that ends too early or too late?";
    let told = |count| format!("{count} samples");
    if got == expected { Ok(()) } else { Err(wrong("wrong-count", tried, told(got), told(expected), advice)) }
}

fn within(tried: &str, x: f32, words: impl Fn() -> String) -> Verdict {
    if (0.0..1.0).contains(&x) {
        return Ok(());
    }
    let (name, advice) = if x == 1.0 {
        ("rounded-to-one", "An f32 could not tell it from 1. Take the smaller of your number and `BELOW_ONE`.")
    } else {
        ("outside", "Did you forget to divide by the number of strata, or is the last stratum one too far?")
    };
    Err(wrong(name, tried, words(), "numbers that are at least 0 and below 1".into(), advice))
}
