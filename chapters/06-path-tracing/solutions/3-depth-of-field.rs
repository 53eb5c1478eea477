//! # Exercise 6.3: depth of field
//!
//! The camera of chapter 1 has a pinhole. All rays of a pixel start in one point, and so everything is sharp, near and far.
//! A real camera has a lens, since a pinhole lets too little light in. The lens makes things sharp at one distance only.
//! What is nearer or farther is blurred.
//!
//! A thin lens is a disc around the eye. It is parallel to the window and has the diameter `aperture`. Far before it lies the
//! *plane of focus*, parallel to the lens. It is as far away as `focus` says. The lens bends light so that all rays between one
//! pixel and the lens meet again in one point of that plane. Which point? The ray through the middle of the lens is not bent.
//! It is the ray of the pinhole camera. So the point is where the pinhole's ray meets the plane:
//!
//! ```text
//!        lens                plane of focus
//!         |                        |
//!         | .                      |
//!    eye  + - - - - - - - - - - - -+  forward
//!         |     ' - . _            |
//!         | .- - - - - - - ' - . _ |
//!         |                        *  all rays of the pixel meet here
//! ```
//!
//! Each path starts at a random point of the lens. A pixel is the mean over its pixel's area, over all paths, and now over the
//! lens as well. For chance that is only two numbers more.
//!
//! ## Your task
//!
//! Fill in the three functions below.
//!
//! - `in_focus` is the point where the pinhole's ray meets the plane of focus. All points of that plane have the same distance
//!   `focus` *along the view*, measured in the direction `forward`. Their distances from the eye differ.
//! - `lens_ray` is the ray from a random point of the lens to the point in focus. The points are uniform over the disc: make
//!   one of `u`, a uniform point of the unit square. `sample_uniform_disc_concentric(u)` of chapter 5 is a uniform point of
//!   the disc with radius 1. (Other maps are as good.)
//! - The lens is spanned by `right` and `up`, and its middle is the eye. `aperture` is its *diameter*.
//! - The direction of the ray is of unit length. With an aperture of 0 it is the pinhole's ray, up to rounding.
//! - At a depth other than `focus` the rays of a pixel do not meet. There they fill a disc, the *circle of confusion*.
//!   `circle_of_confusion` is its diameter. Draw the lens, the plane, and the rays from the rim of the lens, and look for
//!   similar triangles. The result is never negative, and it is 0 at the depth `focus`.
//!
//! `aperture` and `depth` are at least 0, and `focus` is above 0. All three are in scene units.
//!
//! ## When you are done
//!
//! `cargo exercise 6.3` checks your lens and renders a row of balls by lamplight through it. Turn the knobs of the picture:
//! `--set focus=9` or `--set aperture=0`.

use std::process::ExitCode;

use common::{
    Vec2, Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::ray::Ray;
use sampling::disc::sample_uniform_disc_concentric;

/// The point where the pinhole's ray meets the plane of focus.
///
/// `pinhole` starts in the eye, and its direction is of unit length. `forward` is the unit vector in which the camera looks.
/// `pinhole.at(t)` is the point that the ray reaches at `t`.
fn in_focus(pinhole: Ray, forward: Vec3, focus: f32) -> Vec3 {
    // STUB: let _ = (forward, focus); // take this line away when you start
    // STUB: pinhole.origin
    // The share of each step along the ray that is a step along the view.
    let cosine = pinhole.direction.dot(forward);
    pinhole.at(focus / cosine)
    // END STUB
}

/// The ray that starts at the point of the lens which belongs to `u`, and passes through the point in focus.
///
/// `right`, `up` and `forward` are unit vectors at right angles to each other.
fn lens_ray(pinhole: Ray, [right, up, forward]: [Vec3; 3], aperture: f32, focus: f32, u: Vec2) -> Ray {
    // STUB: let _ = (right, up, forward, aperture, focus, u, sample_uniform_disc_concentric); // take this line away when you start
    // STUB: pinhole
    let on_lens = sample_uniform_disc_concentric(u) * (aperture / 2.0);
    let origin = pinhole.origin + right * on_lens.x + up * on_lens.y;
    Ray::new(origin, (in_focus(pinhole, forward, focus) - origin).normalize())
    // END STUB
}

/// The diameter of the disc that the rays of a pixel fill at this depth. A depth is measured along the view, as `focus` is.
fn circle_of_confusion(aperture: f32, focus: f32, depth: f32) -> f32 {
    // STUB: let _ = (aperture, focus, depth); // take this line away when you start
    // STUB: 0.0
    // The rays are as wide apart as the lens at its place, and meet after the distance `focus`.
    aperture * (depth - focus).abs() / focus
    // END STUB
}

// From here on your lens is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

use checks::depth_of_field::Answer;

/// What you have written.
const ANSWER: Answer = Answer { in_focus, lens_ray, circle_of_confusion };

/// What your lens sees.
const PICTURE: Picture =
    pictures::depth_of_field::picture(|settings| pictures::depth_of_field::make(settings, lens_ray));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your lens is right.
fn accepted() -> Verdict {
    checks::depth_of_field::check(ANSWER)
}
