//! # Exercise 4.1: a bounding sphere
//!
//! A chess pawn of two hundred triangles takes two hundred tests, and most rays pass it by. Put it into a glass ball, and a
//! single test tells for most rays that they miss all of it. A simple shape around a complicated one is called a
//! **bounding volume**. The chapter takes boxes. Here you take spheres.
//!
//! A bounding sphere may be wrong in one direction only. If it says 'this ray may hit' and the ray does not, some time is
//! lost. If it says 'this ray misses' and the ray does not miss, there is a hole in the picture.
//!
//! ## Your task
//!
//! Fill in `around` and `may_hit` below. A ball is
//!
//! ```text
//! struct Ball { center: Vec3, radius: f32 }
//! ```
//!
//! `around` makes a ball for a cloud of points, the corners of the triangles:
//!
//! - It holds all points. There are at least two, in different places.
//! - It is nearly as small as this simple one: the center is that of the smallest axis-aligned box around all points, and the
//!   radius is the distance of the point that is farthest from there. (Not the corner of the box that is farthest!)
//! - That is rounded. So make the radius larger by one thousandth of itself. More than one hundredth is too much. Any other
//!   ball that holds all points and is no larger is as good.
//!
//! `may_hit` says whether a ray can hit anything in a ball:
//!
//! - The answer is `true` if any point `ray.at(t)` with `range.min < t < range.max` lies in the ball, otherwise `false`. The ball is
//!   solid: what it holds may be anywhere in it. So a way that begins and ends in the ball counts, too.
//! - `t` counts lengths of the ray's direction, which need not be of unit length.
//! - `range.min` is less than `range.max`. It may be negative, and `range.max` may be infinity.
//! - Balls are at most a thousand times as far from the origin of space and from the start of the ray as they are large.
//! - Where the ray misses the ball or the end of the range by less than a five hundredth of the radius, either answer is accepted.
//!
//! ## When you are done
//!
//! `cargo exercise 4.1` checks your answer and renders a crowd of pawns, each in your ball. Wherever a ray may hit, the picture
//! shows the ball as a bubble.

use std::process::ExitCode;

use common::{
    Interval, Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::ray::Ray;

use checks::bounding_sphere::Ball;

/// A ball that holds all points.
fn around(points: &[Vec3]) -> Ball {
    let _ = points; // take this line away when you start
    Ball { center: Vec3::ZERO, radius: 0.0 }
}

/// Whether a ray can hit anything in a ball inside `range`.
fn may_hit(ball: &Ball, ray: &Ray, range: Interval) -> bool {
    let _ = (ball, ray, range); // take this line away when you start
    true
}

// From here on your answer is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your balls look like.
const PICTURE: Picture =
    pictures::bounding_sphere::picture(|settings| pictures::bounding_sphere::make(settings, around, may_hit));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your answer is right.
fn accepted() -> Verdict {
    checks::bounding_sphere::check(around, may_hit)
}
