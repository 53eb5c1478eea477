//! # Exercise 5.5: a picture as a density
//!
//! How does one draw directions toward a sky that is given as a picture, with a small sun in it? As often as each pixel is bright.
//! That needs no formula for the density, only a table of weights: one number, 0 or greater, for each cell of a grid over the unit
//! square.
//!
//! First a single row of cells. Add up the weights from the left, and divide all sums by the last one: this is the cumulative
//! distribution, which rises from 0 to 1. Cell i takes the numbers u from the sum before it to its own sum, so its share of them
//! is its weight over the sum of all. To find the cell of a given u is to invert the distribution.
//!
//! Two dimensions are two steps. The sum of each row is a weight of the row: these choose the row (the marginal distribution).
//! The weights of that row choose the column (the conditional distribution).
//!
//! A `table` holds both: `table.rows` is what `cumulative` makes of the sums of the rows, and `table.columns[row]` what it makes
//! of that row, as lists of f64. Where rounding would make a number 1 that must be below, take `BELOW_ONE`.
//!
//! ## Your task
//!
//! Fill in the four functions below.
//!
//! - `cumulative` has as many numbers as there are weights; number i is the sum of the weights from 0 to i, divided by the sum of
//!   all of them. The last one is exactly 1, also after rounding. If all weights are 0, all cells are equally likely.
//! - `invert` finds the cell of u, which is at least 0 and below 1: the first cell whose number in `cumulative` is greater than u. So
//!   a cell without weight is never found. With the cell it tells where within the cell u lies: 0 at the sum before the cell, and
//!   toward 1 at its own. It is below 1.
//! - `sample_table` chooses the row by u[1] and the column by u[0]. Its point lies within the cell where `invert` says: x =
//!   (column + where) / number of columns, y likewise. With it comes the density, per unit of area of the unit square.
//! - `table_pdf` is the density at a point of the square, both of whose coordinates are at least 0 and below 1. It integrates to 1.
//!
//! ## When you are done
//!
//! `cargo exercise 5.5` checks your table and takes a picture of chapter 3 for the weights. It throws 80,000 dots onto a black
//! page, all nearly equally bright, where your function puts them.

use std::process::ExitCode;

use common::{
    exercise::{self, Verdict},
    picture::Picture,
};

/// A table of weights: the cumulative distribution of its rows, and in each row that of its columns.
use checks::table::Table;

/// The greatest f64 below 1.
const BELOW_ONE: f64 = 1.0 - f64::EPSILON / 2.0;

/// The sums of the weights up to each of them, over the sum of all.
fn cumulative(weights: &[f64]) -> Vec<f64> {
    let _ = weights; // take this line away when you start
    Vec::new()
}

/// The cell that `u` falls into, and where within the cell, from 0 to below 1.
fn invert(cumulative: &[f64], u: f64) -> (usize, f64) {
    let _ = (cumulative, u, BELOW_ONE); // take this line away when you start
    (0, 0.0)
}

/// A point of the unit square, and its density, from a uniform point `u` of the unit square.
fn sample_table(table: &Table, u: [f64; 2]) -> ([f64; 2], f64) {
    let _ = (table, u); // take this line away when you start
    ([0.0, 0.0], 0.0)
}

/// The density at a point of the unit square.
fn table_pdf(table: &Table, point: [f64; 2]) -> f64 {
    let _ = (table, point); // take this line away when you start
    0.0
}

// From here on your table is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

use checks::picture_as_density::Answer;

/// What you have written.
const ANSWER: Answer = Answer { cumulative, invert, sample_table, table_pdf };

/// What your table looks like.
const PICTURE: Picture =
    pictures::picture_as_density::picture(|settings| pictures::picture_as_density::make(settings, ANSWER));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your table is right.
fn accepted() -> Verdict {
    checks::picture_as_density::check(ANSWER)
}
