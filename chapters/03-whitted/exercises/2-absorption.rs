//! # Exercise 3.2: thin and thick glass
//!
//! Glass of this chapter is clear: what goes in comes out, however thick it is. Colored glass takes some light away on every
//! stretch of the way, more of one color than of another. A thin pane is pale, a thick block is deep.
//!
//! On each short stretch the same share is lost, so that what is left falls exponentially with the length s of the way:
//!
//! ```text
//! transmittance = e^(−σ s)
//! ```
//!
//! This is the law of Beer and Lambert. The absorption coefficient σ, one number for each color channel, counts in 1/unit;
//! air has σ = 0. The law holds for the way **inside** the glass, and there for each ray anew: for the refracted one
//! that crosses it, and for the one that was totally reflected inside and crosses it again.
//!
//! ## Your task
//!
//! Fill in the four functions below.
//!
//! - `coefficient`: people know what color a glass has, not its σ. Given is the color that is left of white light after one
//!   unit of length, each channel above 0 and up to 1. Which σ gives that? `common::float::ln` is the natural logarithm.
//! - `transmittance`: e^(−σ s) for each channel. `common::float::exp` gives the same bits on every machine. The way may be
//!   infinitely long: then nothing is left, except where σ is zero, where all is left. What is 0 · ∞ in floating point?
//! - `way`: how long a ray travels until it hits. Its direction has unit length, so that `hit.t` is a distance from the ray's
//!   origin. But the way begins where hits begin to count, at `branch.range.min`: where the index is 1, `branches` goes
//!   on with the old ray behind the surface. Without a hit the way is infinite.
//! - `medium`: what a new ray travels through, told by its σ. `here` is σ where the old ray came from, `inside` is σ of what
//!   was hit, and `side` is the side that was hit. `new.kind` is `Reflected` or `Refracted`, out of `whitted::probe::Kind`. A
//!   reflected ray stays where the old one was. A refracted ray goes to the other side; outside of every glass is air.
//!   (Glass within glass needs more than that.)
//!
//! ## When you are done
//!
//! `cargo exercise 3.2` checks your glass and renders it, from thin to thick. The shadows in this picture are colored: on its way
//! to the table, the light of the lamp goes straight through the balls, without being bent, and your `transmittance` takes
//! its share of it. That is simpler than true, and still nearer to the truth than the chapter's own dark shadows of glass.

use std::process::ExitCode;

use common::{
    Rgb,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::hit::{Hit, Side};
use whitted::branches::Branch;

/// The absorption coefficient σ, in 1/unit, of glass that leaves `color` of white light after one unit.
fn coefficient(color: Rgb) -> Rgb {
    let _ = color; // take this line away when you start
    Rgb::ZERO
}

/// The share of light that is left after `length` units in a medium with that absorption coefficient.
fn transmittance(absorption: Rgb, length: f32) -> Rgb {
    let _ = (absorption, length); // take this line away when you start
    Rgb::ONE
}

/// How long a ray travels until its hit, in scene units.
fn way(branch: &Branch, hit: Option<&Hit>) -> f32 {
    let _ = (branch, hit); // take this line away when you start
    0.0
}

/// The absorption coefficient of what a new ray travels through.
fn medium(new: &Branch, side: Side, here: Rgb, inside: Rgb) -> Rgb {
    let _ = (new, side, here, inside); // take this line away when you start
    Rgb::ZERO
}

// From here on your glass is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

use checks::absorption::Answer;

/// What you have written.
const ANSWER: Answer = Answer { coefficient, transmittance, way, medium };

/// What your glass looks like.
const PICTURE: Picture = pictures::absorption::picture(|settings| pictures::absorption::make(settings, ANSWER));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your glass is right.
fn accepted() -> Verdict {
    checks::absorption::check(ANSWER)
}
