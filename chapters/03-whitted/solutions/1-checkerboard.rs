//! # Exercise 3.1: a checkerboard
//!
//! A texture lets a material change from place to place. The plainest one needs no picture file and no coordinates on the
//! surface: a solid texture fills space, and a thing shows what it would show if it were carved out of a block.
//!
//! This block is made of cubes that alternate between light and dark, like the squares of a chessboard in all three
//! directions. The cube that a point lies in has three whole numbers:
//!
//! ```text
//! (i, j, k) = (⌊x / size⌋, ⌊y / size⌋, ⌊z / size⌋)
//! ```
//!
//! `⌊x⌋` is the greatest whole number that is at most x. The cube is dark if i + j + k is odd, otherwise it is light.
//!
//! ## Your task
//!
//! Fill in the two functions below.
//!
//! - `is_dark` answers for a point anywhere in space, also at negative coordinates: there, too, each cube is `size` scene
//!   units wide, and neighbors differ. By the formula, a border belongs to the cube on the side of the greater coordinate;
//!   the check asks away from borders.
//! - Points may be a million cubes away from the origin, and more never come. That is more than an `i16` can count.
//! - `is_dark_at` answers for a hit on a thing carved out of the block. A floor at y = 0 lies in the border between two
//!   layers of cubes, and rounding would decide which of them is seen: noise. So ask a thousandth of a cube's size behind
//!   the surface, as the ray sees it: straight away from `hit.geometric_normal`, which faces the ray and may have any
//!   direction.
//!
//! ## When you are done
//!
//! `cargo exercise 3.1` checks your texture and renders a board and three balls carved out of such blocks: the board of two
//! kinds of stone, the balls of gold and silver, of two kinds of wood, and of porcelain. A fourth ball is a plain mirror.

use std::process::ExitCode;

use common::{
    Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::hit::Hit;

/// Whether the cube that `point` lies in is dark. `size` is the width of a cube in scene units, above zero.
fn is_dark(point: Vec3, size: f32) -> bool {
    // STUB: let _ = (point, size); // take this line away when you start
    // STUB: false
    let cube = (point / size).floor();
    // `%` would keep the sign of a negative sum; the remainder by Euclid is 0 or 1.
    cube.element_sum().rem_euclid(2.0) == 1.0
    // END STUB
}

/// Whether the surface is dark where a ray hits it.
fn is_dark_at(hit: &Hit, size: f32) -> bool {
    // STUB: let _ = (hit, size); // take this line away when you start
    // STUB: false
    let behind = hit.position - hit.geometric_normal * (size / 1000.0);
    is_dark(behind, size)
    // END STUB
}

// From here on your texture is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

use checks::checkerboard::Answer;

/// What you have written.
const ANSWER: Answer = Answer { is_dark, is_dark_at };

/// What your texture looks like.
const PICTURE: Picture = pictures::checkerboard::picture(|settings| pictures::checkerboard::make(settings, is_dark_at));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your texture is right.
fn accepted() -> Verdict {
    checks::checkerboard::check(ANSWER)
}
