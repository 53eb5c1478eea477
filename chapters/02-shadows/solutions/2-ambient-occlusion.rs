//! # Exercise 2.2: ambient occlusion
//!
//! The ambient term is the same everywhere, and so all that lies in shadow looks flat. In truth less light comes into a
//! corner than onto an open plain: under a gray sky, what counts is how much of the sky a point sees. That is easy to
//! find out. Send shadow rays in many directions, and see how many of them get away.
//!
//! Not all directions count alike. Light from straight above is spread over the least area, light that comes in along
//! the surface over the greatest. As for any light on a rough surface, the weight is the cosine, ω·N. The openness of a
//! point is
//!
//! ```text
//!             sum of ω·N over the directions ω that get away
//! openness = ------------------------------------------------      1 under the open sky, 0 in a closed box
//!             sum of ω·N over all directions ω
//! ```
//!
//! Inside a room nothing would get away. So only what is near counts: what lies beyond a certain reach hides nothing.
//!
//! ## Your task
//!
//! Fill in `openness` below. The book's pages *Shadow rays* and *Acne and the offset* show all that you need, and
//! so does `chapters/02-shadows/src/shadow_ray.rs`.
//!
//! - The unit vectors `directions`, a few or hundreds, lie on the whole sphere. About half of them point into the surface.
//!   Do not leave those out, but turn them round: −ω points out of the surface if ω points into it.
//! - N is `hit.geometric_normal`, everywhere. (The interpolated normal would send rays into the surface.)
//! - Rays start a little above the surface, along its normal. That little must follow the numbers, as `Offset::Following`
//!   does: the check looks at things that are 100,000 times as far from the origin of space as they are large, and at
//!   grains of dust that nearly touch.
//! - A direction gets away if nothing lies within `reach` scene units. `reach` may be infinite.
//! - If there are no directions, or all of them run along the surface, nobody knows: then the answer is 1, and not a NaN.
//!
//! ## When you are done
//!
//! `cargo exercise 2.2` checks your function and renders the still life in white clay under a gray sky, lit by nothing
//! but your openness.

use std::process::ExitCode;

use common::{
    Interval, Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::{hit::Hit, ray::Ray, scene::Scene};
use shadows::offset::Offset;

/// The share of the light from all around that arrives at `hit`, 0 to 1: from those of the unit vectors `directions` in
/// which nothing lies within `reach` scene units.
fn openness<M>(scene: &Scene<M>, hit: &Hit, directions: &[Vec3], reach: f32) -> f32 {
    // STUB: // Take these two lines away when you start:
    // STUB: let _ = (scene, hit, directions, reach);
    // STUB: let _ = (Interval::POSITIVE, Ray::new, Offset::Following);
    // STUB: 1.0
    let normal = hit.geometric_normal;
    let origin = Offset::Following.origin(hit, normal);
    let range = Interval::POSITIVE.up_to(reach);
    let (mut open, mut all) = (0.0, 0.0);
    for &direction in directions {
        // Turn what points into the surface.
        let direction = if direction.dot(normal) < 0.0 { -direction } else { direction };
        let cosine = direction.dot(normal);
        all += cosine;
        if !scene.occluded(&Ray::new(origin, direction), range) {
            open += cosine;
        }
    }
    if all > 0.0 { open / all } else { 1.0 }
    // END STUB
}

// From here on your function is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your openness shows.
const PICTURE: Picture =
    pictures::ambient_occlusion::picture(|settings| pictures::ambient_occlusion::make(settings, openness));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your function is right.
fn accepted() -> Verdict {
    checks::ambient_occlusion::check(openness)
}
