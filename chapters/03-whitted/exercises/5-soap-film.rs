//! # Exercise 3.5: soap bubbles
//!
//! A soap film is clear water, and yet it shines in all colors. It is so thin, less than a thousandth of a millimeter, that
//! the wave reflected on its front and the waves reflected on its back come together in step or out of step: they interfere.
//! Which wavelengths gain depends on the thickness d and on the angle.
//!
//! Light comes from air at the angle θ and goes on in the film of index n at the angle θ_t; by Snell, sin θ = n sin θ_t. The
//! front reflects the **amplitude** r of a wave, the square root of a reflectance, with its sign. There are two
//! of them, for light that swings across and along the plane of the ray and the normal:
//!
//! ```text
//! across: r = (cos θ − n cos θ_t) / (cos θ + n cos θ_t)        along: r = (n cos θ − cos θ_t) / (n cos θ + cos θ_t)
//! ```
//!
//! From inside, front and back reflect −r. What enters and leaves again has the factor 1 − r². Each time a wave crosses the film and
//! comes back, its phase grows by δ = 4π n d cos θ_t / λ. So the reflected waves sum to
//!
//! ```text
//! r − (1 − r²) r e^(iδ) · (1 + r² e^(iδ) + r⁴ e^(2iδ) + …)
//! ```
//!
//! The reflectance is the squared magnitude of this complex number, and for unpolarized light the mean of across and along.
//!
//! ## Your task
//!
//! - `reflectance` is the share of light of one wavelength that the film reflects. Sum the series on paper, it is a geometric
//!   one, and take its squared magnitude: a short real formula in r² and cos δ is left. Thickness and wavelength come in
//!   nanometers. `cosine` is cos θ, above 0 and up to 1. Without thickness, nothing is reflected.
//! - `branches` sends on two rays, whichever side of the film was hit: the reflected one, with the given color as its share, and
//!   one that goes straight on with the rest, of `Kind::Refracted`. The film is so thin that it bends no ray: go on with the
//!   same ray and let hits count from `hit.t` on. (A new ray of that direction that starts behind the film, at the same offset
//!   against the normal, is as good.)
//! - The reflected ray is like that of `chapters/03-whitted/src/branches.rs`: `reflect` at the shading normal, from
//!   `Offset::Following.origin(hit, hit.geometric_normal)`, in the range `Interval::POSITIVE`.
//!
//! ## When you are done
//!
//! `cargo exercise 3.5` checks your film and renders bubbles: at the top, where the water has run down, they are black.

use std::process::ExitCode;

use common::{
    Rgb,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::{hit::Hit, ray::Ray};
use whitted::branches::Branch;

/// The share of light of a wavelength that a film of that index and thickness in air reflects. Both lengths are in
/// nanometers.
fn reflectance(cosine: f32, index: f32, thickness: f32, wavelength: f32) -> f32 {
    let _ = (cosine, index, thickness, wavelength); // take this line away when you start
    0.0
}

/// The rays that a film sends on which reflects the share `reflectance` of each channel.
fn branches(ray: &Ray, hit: &Hit, reflectance: Rgb) -> [Option<Branch>; 2] {
    let _ = (ray, hit, reflectance); // take this line away when you start
    [None; 2]
}

// From here on your film is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

use checks::soap_film::Answer;

/// What you have written.
const ANSWER: Answer = Answer { reflectance, branches };

/// What your film looks like.
const PICTURE: Picture = pictures::soap_film::picture(|settings| pictures::soap_film::make(settings, ANSWER));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your film is right.
fn accepted() -> Verdict {
    checks::soap_film::check(ANSWER)
}
