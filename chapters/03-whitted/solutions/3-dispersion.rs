//! # Exercise 3.3: a prism
//!
//! Glass does not bend all light alike: blue more than red. This is dispersion. It makes the rainbow of a prism, the fire of
//! a diamond and the colored fringes of a cheap lens. Cauchy's formula tells the refractive index of a clear medium by the
//! wavelength λ in **micrometers**, with two numbers A and B that are measured for each kind of glass:
//!
//! ```text
//! n(λ) = A + B / λ²
//! ```
//!
//! Here three wavelengths stand for the three channels, one each for red, green and blue. Each has its own index, so that a
//! surface sends on up to four rays: **one** that is reflected, and three that are refracted, each of them for one channel.
//!
//! ## Your task
//!
//! Fill in the two functions below. `chapters/03-whitted/src/branches.rs` does the same without dispersion. Its helpers are
//! yours to use:
//!
//! ```text
//! use common::Interval;
//! use shadows::offset::Offset;
//! use whitted::{fresnel::exact, probe::Kind, reflection::reflect, refraction::refract};
//! ```
//!
//! Leave its `branches` alone: it takes the index of one channel for all three. You need not treat equal media apart as it
//! does, because here every index is above 1. Clear glass has no extinction: `kappa` is 0.
//!
//! - `cauchy` takes A, B in µm², and the wavelength in **nanometers**, as is usual for light. 1 µm is 1000 nm.
//! - `branches` takes the index of the glass, relative to the air around it, for each channel. From `Side::Inside` the
//!   relative index is 1/n, for each channel.
//! - The reflected ray is of `Kind::Reflected`. Its share is Fresnel's reflectance F, for each channel by its own index.
//! - A refracted ray is of `Kind::Refracted` and bent by the index of its channel. In that channel its share is 1 − F, in the
//!   other two it is zero.
//! - Each channel meets its own critical angle. Where total reflection befalls one, there is no refracted ray for it, and F is
//!   1. The others may still get out.
//! - Directions and F come from `hit.shading_normal`. It faces the ray, as `hit.geometric_normal` does, whichever side was
//!   hit. Directions have unit length.
//! - Rays start at `Offset::Following.origin(…)`, on the side of `hit.geometric_normal` they belong to, and their range is
//!   `Interval::POSITIVE`. Their order does not matter.
//!
//! ## When you are done
//!
//! `cargo exercise 3.3` checks your dispersion and renders a cut diamond, and a ball and a prism of flint glass.

use std::process::ExitCode;

use common::{
    Rgb,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::{hit::Hit, ray::Ray};
use whitted::branches::Branch;

/// The refractive index at a wavelength in nanometers, by Cauchy's formula with `a` and `b` (in µm²).
fn cauchy(a: f32, b: f32, nanometers: f32) -> f32 {
    // STUB: let _ = (a, b, nanometers); // take this line away when you start
    // STUB: 1.0
    let micrometers = nanometers / 1000.0;
    a + b / (micrometers * micrometers)
    // END STUB
}

/// The rays that a surface of clear glass sends on, with one refractive index for each channel.
fn branches(ray: &Ray, hit: &Hit, index: Rgb) -> [Option<Branch>; 4] {
    // STUB: let _ = (ray, hit, index); // take this line away when you start
    // STUB: [None; 4]
    use common::Interval;
    use ray_casting::hit::Side;
    use shadows::offset::Offset;
    use whitted::{fresnel::exact, probe::Kind, reflection::reflect, refraction::refract};

    let normal = hit.shading_normal;
    let cosine = -ray.direction.dot(normal);
    let [red, green, blue] = match hit.side {
        Side::Outside => index.to_array(),
        Side::Inside => index.recip().to_array(),
    };
    // Beyond a channel's critical angle `exact` answers 1.
    let reflectance = Rgb::from_array([red, green, blue].map(|n| exact(cosine, n, 0.0)));
    let branch = |kind, side, direction, share| {
        let ray = Ray::new(Offset::Following.origin(hit, side * hit.geometric_normal), direction);
        Branch { kind, ray, range: Interval::POSITIVE, share }
    };
    // One refracted ray carries one channel.
    let refracted = |n, channel| {
        let direction = refract(ray.direction, normal, n)?;
        Some(branch(Kind::Refracted, -1.0, direction, channel * (Rgb::ONE - reflectance)))
    };
    let reflected = branch(Kind::Reflected, 1.0, reflect(ray.direction, normal), reflectance);
    [Some(reflected), refracted(red, Rgb::X), refracted(green, Rgb::Y), refracted(blue, Rgb::Z)]
    // END STUB
}

// From here on your dispersion is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

use checks::dispersion::Answer;

/// What you have written.
const ANSWER: Answer = Answer { cauchy, branches };

/// What your dispersion looks like.
const PICTURE: Picture = pictures::dispersion::picture(|settings| pictures::dispersion::make(settings, ANSWER));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your dispersion is right.
fn accepted() -> Verdict {
    checks::dispersion::check(ANSWER)
}
