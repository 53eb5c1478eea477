//! # Exercise 6.1: glass
//!
//! Glass parts the light: the share F is reflected, and the rest goes through. Chapter 3 followed both rays, and the rays became a
//! tree. A path has no branches. So let chance choose one of the two: reflection with probability F, refraction with probability
//! 1 − F.
//!
//! A choice is divided by its probability. The reflected light counts F, and F / F is 1. The refracted light counts 1 − F, and
//! (1 − F) / (1 − F) is 1. So the weight of the step is always 1: glass takes nothing away, it only sends paths one way or the
//! other.
//!
//! Is that all? Behind the surface light is packed into a narrower cone: in glass of index n its radiance is n² times as large.
//! Where it leaves the glass it is divided by n² again. Our camera, our lamps and our sky are all outside. A path between them leaves
//! the glass as often as it enters, and the factors cancel. So leave them out.
//!
//! ## Your task
//!
//! Fill in `glass_step` below. It is asked where `ray` has hit glass, and returns the ray on which the path goes on, and the weight
//! of this step.
//!
//! - `index` is the refractive index of what is inside, divided by that of what is outside. `hit.side` says from which side the ray
//!   came: `Side::Outside` or `Side::Inside`. The ratio for `refract` and `exact` is the index behind the surface divided by the index
//!   before it: `index` from outside, 1 / `index` from inside.
//! - `ray.direction` is a unit vector, and so is your new direction. `hit.shading_normal` faces the ray. In this exercise
//!   `hit.geometric_normal` is the same vector.
//! - Chapter 3 has all the optics. `reflect(direction, normal)` is the mirror direction. `refract(direction, normal, ratio)` is the
//!   refracted one, or `None` where there is none. `exact(cosine, ratio, 0.0)` is F, by the cosine of the angle between the ray and
//!   the normal. This cosine is not negative.
//! - Choose the reflected direction with probability F, and the refracted one otherwise. `random.uniform()` is a number from 0 to 1.
//! - Where `refract` gives `None`, all the light is reflected, with weight 1. The index may be below 1, as for a bubble of air in
//!   water; then this happens from outside.
//! - The new ray starts a little off the surface, on the side into which it goes. `Offset::Following.origin(hit, normal)` is a
//!   point on the side to which `normal` points.
//!
//! ## When you are done
//!
//! `cargo exercise 6.1` checks your glass and renders four things of it: a ball, a hollow ball, a block, and a ball of diamond.

use std::process::ExitCode;

use common::{
    Stream,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::{
    hit::{Hit, Side},
    ray::Ray,
};
use shadows::offset::Offset;
use whitted::{fresnel::exact, reflection::reflect, refraction::refract};

/// How a path goes on where `ray` has hit glass: the next ray, and what the radiance from there is multiplied by.
fn glass_step(index: f32, ray: &Ray, hit: &Hit, random: &mut Stream) -> (Ray, f32) {
    let _ = (index, random); // take this line away when you start
    let _ = (Side::Inside, Offset::Following, exact, reflect, refract); // these will help: take this line away, too
    (Ray::new(hit.position, ray.direction), 0.0)
}

// From here on your glass is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your glass looks like.
const PICTURE: Picture = pictures::glass::picture(|settings| pictures::glass::make(settings, glass_step));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your glass is right.
fn accepted() -> Verdict {
    checks::glass::check(glass_step)
}
