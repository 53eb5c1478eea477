//! # Exercise 5.1: stratified samples
//!
//! Random samples come in heaps and leave gaps. Regular samples do neither, but they always ask at the same places. There is
//! something between the two: divide the interval from 0 to 1 into `count` parts of equal width, the strata, and draw one
//! random sample in each of them. Stratum number i, counted from 0, reaches from i / count to (i + 1) / count.
//!
//! The estimate stays right on average, since all strata together cover the interval evenly. And it errs less: of M samples,
//! a smooth function is now integrated with an error that falls like M^(−3/2) and no longer like M^(−1/2). In two dimensions
//! strata are the cells of a grid, and the error falls like 1/M.
//!
//! ## Your task
//!
//! Fill in the two functions below.
//!
//! - `stratified` draws one sample in each of `count` strata of the interval, in any order. With a count of 0 there are none.
//! - `stratified_square` draws one point in each cell of a grid over the unit square, in any order. The grid has `columns`
//!   cells along x and `rows` cells along y.
//! - Within its stratum or its cell, each place is as likely as any other, whatever the other samples are.
//! - All numbers are at least 0 and below 1. An f32 has few digits: what should be just below 1 can be rounded to 1. Take
//!   `BELOW_ONE` then.
//!
//! ## When you are done
//!
//! `cargo exercise 5.1` checks your samples and renders a still life under an evening sky twice, with 16 directions for each
//! point: random ones at the left, yours at the right.

use std::process::ExitCode;

use common::{
    Stream, Vec2,
    exercise::{self, Verdict},
    picture::Picture,
};

/// The greatest f32 below 1.
const BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;

/// One sample in each of `count` strata of the interval from 0 to 1. `random.uniform()` draws a number of that interval.
fn stratified(count: u16, random: &mut Stream) -> Vec<f32> {
    // STUB: let _ = (count, random, BELOW_ONE); // take this line away when you start
    // STUB: Vec::new()
    let within = |i: u16| ((f32::from(i) + random.uniform()) / f32::from(count)).min(BELOW_ONE);
    (0..count).map(within).collect()
    // END STUB
}

/// One point in each cell of a grid of `columns` × `rows` cells over the unit square.
fn stratified_square(columns: u16, rows: u16, random: &mut Stream) -> Vec<Vec2> {
    // STUB: let _ = (columns, rows, random); // take this line away when you start
    // STUB: Vec::new()
    let size = Vec2::new(columns.into(), rows.into());
    let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| Vec2::new(column.into(), row.into())));
    cells
        .map(|corner| {
            let x = random.uniform();
            let offset = Vec2::new(x, random.uniform());
            ((corner + offset) / size).min(Vec2::splat(BELOW_ONE))
        })
        .collect()
    // END STUB
}

// From here on your samples are checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

use checks::stratified_samples::Answer;

/// What you have written.
const ANSWER: Answer = Answer { stratified, stratified_square };

/// What your samples look like.
const PICTURE: Picture =
    pictures::stratified_samples::picture(|settings| pictures::stratified_samples::make(settings, stratified_square));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your samples are right.
fn accepted() -> Verdict {
    checks::stratified_samples::check(ANSWER)
}
