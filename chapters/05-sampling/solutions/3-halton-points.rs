//! # Exercise 5.3: Halton points
//!
//! To estimate an integral, samples need not be random. They must only be spread evenly, for each number of them. Here is how
//! counting does that, with no chance at all.
//!
//! Write the index of a sample in some base and mirror its digits at the point: that is the radical inverse of the index. In
//! base 10 the index 123 becomes 0.321. In base 2, the index 6 is 110 and becomes 0.011, which is 3/8. The last digit of an
//! index changes with each step, and after mirroring it is the digit that weighs most. So each new number lies far from the one
//! before, and falls into a gap.
//!
//! A Halton point of the unit square has the radical inverse in base 2 for x and that in base 3 for y. The two bases must have
//! no common divisor, or the points would lie on lines. The error of Halton points falls nearly like 1/M, that of random ones
//! like 1/√M.
//!
//! ## Your task
//!
//! Fill in the two functions below.
//!
//! - `radical_inverse(base, index)` mirrors the digits of `index` in `base`, which is at least 2. The index 0 becomes 0.
//! - The result is exact up to the rounding of an f64. An index may be as large as a `u64` can be; then the result may not become 1
//!   by rounding: it stays below.
//! - `halton(index)` is the point number `index`, counted from 0: base 2 for x, base 3 for y.
//!
//! ## When you are done
//!
//! `cargo exercise 5.3` checks your points. Its picture shows 256 random points and 256 of yours, and how the error of a mean
//! falls for both.

use std::process::ExitCode;

use common::{
    exercise::{self, Verdict},
    picture::Picture,
};

/// The digits of `index` in `base`, mirrored at the point: a number from 0 to below 1.
fn radical_inverse(base: u32, index: u64) -> f64 {
    // STUB: let _ = (base, index); // take this line away when you start
    // STUB: 0.0
    let (mut left, mut place, mut inverse) = (index, 1.0, 0.0);
    while left > 0 {
        place /= f64::from(base);
        let digit = left % u64::from(base);
        inverse += digit as f64 * place;
        left /= u64::from(base);
    }
    inverse.min(1.0 - f64::EPSILON / 2.0)
    // END STUB
}

/// The Halton point of that number, in the unit square.
fn halton(index: u64) -> [f64; 2] {
    // STUB: let _ = index; // take this line away when you start
    // STUB: [0.0, 0.0]
    [2, 3].map(|base| radical_inverse(base, index))
    // END STUB
}

// From here on your points are checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

use checks::halton_points::Answer;

/// What you have written.
const ANSWER: Answer = Answer { radical_inverse, halton };

/// What your points look like.
const PICTURE: Picture = pictures::halton_points::picture(|settings| pictures::halton_points::make(settings, halton));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your points are right.
fn accepted() -> Verdict {
    checks::halton_points::check(ANSWER)
}
