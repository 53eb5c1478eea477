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
    // STUB: let _ = weights; // take this line away when you start
    // STUB: Vec::new()
    let total: f64 = weights.iter().sum();
    let count = weights.len();
    let mut sum = 0.0;
    let mut sums: Vec<f64> = weights
        .iter()
        .map(|weight| {
            sum += if total > 0.0 { weight / total } else { 1.0 / count as f64 };
            sum
        })
        .collect();
    // Whatever rounding has left is divided by: the cells behind the last weight stay empty.
    let last = sum;
    sums.iter_mut().for_each(|sum| *sum /= last);
    sums
    // END STUB
}

/// The cell that `u` falls into, and where within the cell, from 0 to below 1.
fn invert(cumulative: &[f64], u: f64) -> (usize, f64) {
    // STUB: let _ = (cumulative, u, BELOW_ONE); // take this line away when you start
    // STUB: (0, 0.0)
    let cell = cumulative.partition_point(|sum| *sum <= u);
    let before = if cell == 0 { 0.0 } else { cumulative[cell - 1] };
    (cell, ((u - before) / (cumulative[cell] - before)).min(BELOW_ONE))
    // END STUB
}

/// A point of the unit square, and its density, from a uniform point `u` of the unit square.
fn sample_table(table: &Table, u: [f64; 2]) -> ([f64; 2], f64) {
    // STUB: let _ = (table, u); // take this line away when you start
    // STUB: ([0.0, 0.0], 0.0)
    let (row, up) = invert(&table.rows, u[1]);
    let columns = &table.columns[row];
    let (column, along) = invert(columns, u[0]);
    let place = |cell: usize, within: f64, cells: usize| ((cell as f64 + within) / cells as f64).min(BELOW_ONE);
    let point = [place(column, along, columns.len()), place(row, up, table.rows.len())];
    (point, density(table, column, row))
    // END STUB
}

/// The density at a point of the unit square.
fn table_pdf(table: &Table, point: [f64; 2]) -> f64 {
    // STUB: let _ = (table, point); // take this line away when you start
    // STUB: 0.0
    let cell = |x: f64, cells: usize| ((x * cells as f64) as usize).min(cells - 1);
    let row = cell(point[1], table.rows.len());
    density(table, cell(point[0], table.columns[row].len()), row)
    // END STUB
}

// STUB:
/// The share of a cell, over its area.
fn density(table: &Table, column: usize, row: usize) -> f64 {
    let share = |cumulative: &[f64], cell: usize| cumulative[cell] - if cell == 0 { 0.0 } else { cumulative[cell - 1] };
    let columns = &table.columns[row];
    share(&table.rows, row) * share(columns, column) * (table.rows.len() * columns.len()) as f64
}

// END STUB
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
