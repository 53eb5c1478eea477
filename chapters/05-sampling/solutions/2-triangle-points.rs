//! # Exercise 5.2: points of a triangle
//!
//! A lamp of any shape can be made of triangles. To gather its light, draw points on them: uniform, so that each piece of the
//! triangle gets as many points as its area says.
//!
//! A point of the triangle with the corners r1, r2 and r3 is `α r1 + β r2 + γ r3`. The three weights are at least 0, and
//! their sum is 1. A point u of the unit square has two random numbers, and two of the weights are free, so it fits. But
//! `α = u.x` and `β = (1 − u.x) u.y` would be wrong: the strip of the triangle with a small α is long, the one with an α near
//! 1 is short, and both would get equally many points.
//!
//! The part of the triangle in which α is at least a is a triangle too, (1 − a) times as long and as wide.
//!
//! ## Your task
//!
//! Fill in the two functions below.
//!
//! - `sample_triangle` makes of a uniform point u of the unit square a uniform point of the triangle. Both numbers of u are at
//!   least 0 and below 1.
//! - It takes no trials: it is one map from the square to the triangle. There is more than one right answer.
//! - `triangle_pdf` is its density, per unit of area. Every triangle has the same density all over, and its integral is 1.
//! - A triangle without an area has no density. Return 0 for it, as for everything that is to be dropped.
//!
//! ## When you are done
//!
//! `cargo exercise 5.2` checks your points and renders a still life in the light of three glowing triangles. Each sample
//! goes to one point that you have drawn, and is divided by your density.

use std::process::ExitCode;

use common::{
    Vec2, Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};

/// A uniform point of the triangle with these corners, from a uniform point `u` of the unit square.
fn sample_triangle(corners: [Vec3; 3], u: Vec2) -> Vec3 {
    // STUB: let _ = u; // take this line away when you start
    // STUB: corners[0]
    let [r1, r2, r3] = corners;
    // The share of the triangle beyond α is (1 − α)².
    let left = u.x.sqrt();
    let (alpha, beta) = (1.0 - left, left * (1.0 - u.y));
    r1 * alpha + r2 * beta + r3 * (left * u.y)
    // END STUB
}

/// The density of the uniform distribution over the triangle with these corners, per unit of area.
fn triangle_pdf(corners: [Vec3; 3]) -> f32 {
    // STUB: let _ = corners; // take this line away when you start
    // STUB: 0.0
    let [r1, r2, r3] = corners;
    let area = (r2 - r1).cross(r3 - r1).length() / 2.0;
    if area > 0.0 { 1.0 / area } else { 0.0 }
    // END STUB
}

// From here on your points are checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

use checks::triangle_points::Answer;

/// What you have written.
const ANSWER: Answer = Answer { sample_triangle, triangle_pdf };

/// What your points look like.
const PICTURE: Picture =
    pictures::triangle_points::picture(|settings| pictures::triangle_points::make(settings, ANSWER));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your points are right.
fn accepted() -> Verdict {
    checks::triangle_points::check(ANSWER)
}
