//! # Exercise 6.5: stratified samples in a path
//!
//! Exercise 5.1 drew one sample in each cell of a grid. The error was smaller, since such samples leave no gaps. A path has
//! many random points: one for its place in the pixel, and one for the direction of each bounce. Can all of them be
//! stratified?
//!
//! Not together. Three points are six dimensions, and a grid of only four parts along each of them has 4⁶ = 4096 cells. So
//! each point gets a grid of its own. For a pixel with n·n samples there are three sets of n·n points: one for the place in the
//! pixel, one for the first direction, one for the second. Each set has one point in each cell of an n × n grid.
//!
//! Sample number i takes one point of each set. But which? If all sets are listed row by row, a path through the upper left of
//! the pixel always goes on with the first cell of directions. Most pairs of cells never come, and the picture is *wrong*,
//! however many pixels you look at. So the second and the third set are shuffled, each by a shuffle of its own. Then every
//! pair of cells is equally likely, and each set has no gaps.
//!
//! From the third bounce on each direction is drawn as always. To stratify it as well would gain next to nothing. Why? Light of
//! one bounce depends on the first direction, and hardly on the place in the small pixel. That is nearly a question of two
//! dimensions, and a grid answers it well. Light of k bounces depends on k directions *together*. Each set is spread evenly by
//! itself, but how its numbers go together with those of the others is left to chance. The deeper the path, the more of the
//! noise comes from there, and no grid of two dimensions takes it away.
//!
//! ## Your task
//!
//! Fill in the three functions below. `stratified`, from exercise 5.1, is given.
//!
//! - `shuffle` puts points into a random order. Each order is as likely as any other. It may be asked for no points at all.
//! - `path_points` makes the points for all n·n samples of one pixel: `[in the pixel, first direction, second direction]` for
//!   each. Each of the three is stratified, and which cells go together is left to independent shuffles. All numbers come from
//!   `random`, so that each pixel has other points. All are at least 0 and below 1. n is at least 1.
//! - `trace` follows one path through the point `points[0]` of a pixel: (0, 0) is the pixel's upper left corner, which is
//!   `pixel.position`, and (1, 1) its lower right one.
//! - Bounce 1 takes its direction from `points[1]` and bounce 2 from `points[2]`. All others draw a point from `random`, by
//!   `sample_unit_square(random)`.
//! - All surfaces are matte. A direction is cosine-distributed, as
//!   `DirectionSampling::CosineHemisphere.sample(hit.shading_normal, u).direction` gives it. So the weight of the step is
//!   `material.albedo()`. Nothing ends a path early: no roulette.
//! - Follow the path by `tracer.walk(ray, random, &mut Untold, next_step)`, as in
//!   `chapters/06-path-tracing/src/path_tracer.rs`. (`Untold` means that nobody listens.) At each hit it asks your function
//!   `|material, hit, to_viewer, random, probe|` for the next `Step`, and ends the path when it is long enough. The function
//!   must count the bounces. It may not change a variable, but it may change what is in a cell:
//!   `let bounce = Cell::new(0);`, and then `bounce.get()` and `bounce.set(…)`.
//!
//! ## When you are done
//!
//! `cargo exercise 6.5` checks your functions and renders the light of one, two, and three bounces in a room, above with
//! independent points, below with yours. Below each it says what is left of the variance.

use std::{cell::Cell, process::ExitCode};

use common::{
    Rgb, Stream, Vec2,
    exercise::{self, Verdict},
    picture::{FilmPoint, Picture},
    story::Untold,
};
use path_tracing::{importance::Step, path_tracer::PathTracer};
use sampling::{direction_sampling::DirectionSampling, unit_square::sample_unit_square};

/// The greatest f32 below 1.
const BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;

/// One random point in each cell of a grid of n × n cells over the unit square, row by row.
fn stratified(n: u16, random: &mut Stream) -> Vec<Vec2> {
    let cells = (0..n).flat_map(|row| (0..n).map(move |column| Vec2::new(column.into(), row.into())));
    let point = |cell| (cell + sample_unit_square(random)) / f32::from(n);
    cells.map(point).map(|point: Vec2| point.min(Vec2::splat(BELOW_ONE))).collect()
}

/// Put points into a random order. `points.swap(i, j)` swaps two of them.
fn shuffle(points: &mut [Vec2], random: &mut Stream) {
    let _ = (points, random); // take this line away when you start
}

/// The points of all n·n samples of one pixel: in the pixel, for the first direction, and for the second.
fn path_points(n: u16, random: &mut Stream) -> Vec<[Vec2; 3]> {
    let _ = (n, random, stratified, shuffle); // take this line away when you start
    Vec::new()
}

/// The radiance along one path through a pixel. `pixel.position` is its upper left corner, and a pixel is 1 wide and 1 high.
fn trace(tracer: &PathTracer, pixel: FilmPoint, points: [Vec2; 3], random: &mut Stream) -> Rgb {
    // These will help: `tracer.camera.ray(film_point)`, `tracer.walk(ray, random, &mut Untold, next_step)`.
    let _ = (tracer, pixel, points, random, Cell::<u8>::new, Untold, sample_unit_square); // take these lines away
    let _ = (DirectionSampling::CosineHemisphere, |step: Step| step.weight);
    Rgb::ZERO
}

// From here on your paths are checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

use checks::stratified_paths::Answer;

/// What you have written.
const ANSWER: Answer = Answer { shuffle, path_points, trace };

/// What your paths show.
const PICTURE: Picture =
    pictures::stratified_paths::picture(|settings| pictures::stratified_paths::make(settings, path_points, trace));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your paths are right.
fn accepted() -> Verdict {
    checks::stratified_paths::check(ANSWER)
}
