//! # Exercise 5.4: a glossy lobe
//!
//! A mirror takes one direction, a matte surface takes them all. Brushed metal lies between: it takes directions near the mirror
//! direction R, the likelier the nearer. Phong's highlight describes that by cosⁿα, where α is the angle to R. The greater the
//! exponent n, the narrower the lobe.
//!
//! To draw directions like that, make the density of cosⁿα. Over the hemisphere around R it must integrate to 1:
//!
//! ```text
//! p = (n + 1) / (2π) · cosⁿα
//! ```
//!
//! The share of drawn directions with a cosine below c is c^(n + 1). Set that to a uniform number and solve it for c. The angle
//! around R is uniform.
//!
//! ## Your task
//!
//! Fill in the three functions below.
//!
//! - `sample_phong_lobe` makes of a uniform point u of the unit square a unit vector in the lobe around the z axis, with z ≥ 0. The
//!   exponent is 0 or greater.
//! - `phong_lobe_pdf` is the density p for a direction whose angle to the axis has the cosine `cos_alpha`; 0 where that is not
//!   above 0.
//! - `sample_glossy` draws a direction in the lobe around the mirror direction of `to_viewer`, a unit vector, at the unit vector
//!   `normal`. It returns the direction with its density per steradian.
//!   If a viewer looks along the surface, a part of the lobe reaches below it, where no light comes from. Return `None` for such a
//!   direction, and do not draw another one. The caller counts it as a sample of value 0.
//!
//! `reflect(direction, normal)` of chapter 3 wants a direction that leads to the surface; `to_viewer` leads away from it. And
//! `float::pow(base, exponent)` is a power with the same bits on every machine.
//!
//! So above the surface the density does not integrate to 1: what is missing is the share of samples that was dropped. That is
//! honest, and the mean of all samples is right. Whoever draws again must divide the density by the share that is left, for which
//! there is no short formula; whoever forgets to do that makes a picture that is too bright.
//!
//! ## When you are done
//!
//! `cargo exercise 5.4` checks your lobe and renders five golden balls under an evening sky, each of them smoother than the one
//! before.

use std::process::ExitCode;

use common::{
    Basis, Vec2, Vec3,
    exercise::{self, Verdict},
    float,
    picture::Picture,
};
use sampling::direction_sample::{Density, DirectionSample};
use whitted::reflection::reflect;

/// A unit vector in the lobe cosⁿα around the z axis, from a uniform point `u` of the unit square.
fn sample_phong_lobe(exponent: f32, u: Vec2) -> Vec3 {
    let _ = (exponent, u); // take this line away when you start
    Vec3::Z
}

/// The density of the lobe, per steradian.
fn phong_lobe_pdf(exponent: f32, cos_alpha: f32) -> f32 {
    let _ = (exponent, cos_alpha); // take this line away when you start
    0.0
}

/// A direction in the lobe around the mirror direction, with its density; `None` if it points into the surface.
fn sample_glossy(normal: Vec3, to_viewer: Vec3, exponent: f32, u: Vec2) -> Option<DirectionSample> {
    let _ = (normal, to_viewer, exponent, u); // take this line away when you start
    // These will help: `reflect(direction, normal)`, `Basis::around(axis).to_world(local)`, `Density::SolidAngle(pdf)`.
    let _ = (reflect, Basis::around, Density::SolidAngle, float::pow);
    None
}

// From here on your lobe is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

use checks::phong_lobe::Answer;

/// What you have written.
const ANSWER: Answer = Answer { sample_phong_lobe, phong_lobe_pdf, sample_glossy };

/// What your lobe looks like.
const PICTURE: Picture = pictures::phong_lobe::picture(|settings| pictures::phong_lobe::make(settings, sample_glossy));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your lobe is right.
fn accepted() -> Verdict {
    checks::phong_lobe::check(ANSWER)
}
