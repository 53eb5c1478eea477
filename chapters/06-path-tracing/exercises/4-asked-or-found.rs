//! # Exercise 6.4: asked or found
//!
//! A lamp can be asked: draw a point on it and look whether it is seen. Or it can be found: draw a direction and see whether it meets
//! the lamp. Both are right on average. Which of them has less noise?
//!
//! That depends on the lamp. A small one is hardly ever found, so it should be asked. But suppose the lamp is a whole wall, and near.
//! Then nearly every direction finds it. Asking spreads its points over the wall, and most of them are far away and send little, while
//! few are near and send a great deal.
//!
//! So do both, and give each sample a **weight**. Any direction could have come from either way. Let p_ask and p_find be the densities
//! with which the two ways draw this direction. Then a sample of the first way has the weight `p_ask / (p_ask + p_find)`, and a
//! sample of the second way `p_find / (p_ask + p_find)`. For each direction the two add up to 1, so the light counts once. And each way
//! counts much where it is the likelier one. This is **multiple importance sampling**, with the balance heuristic. The weights may also
//! be made of the squares of both densities: that is accepted, too.
//!
//! Source: Veach, Guibas, *Optimally Combining Sampling Techniques for Monte Carlo Rendering*, SIGGRAPH 1995.
//!
//! ## Your task
//!
//! What is to be estimated is the irradiance at a place from a lamp of radiance 1: the integral of cosθ over all directions in which the
//! lamp is seen. A sample of it is cosθ / p where the lamp is seen, and 0 elsewhere. `place` gives you this:
//!
//! - `place.normal()` is the unit normal of the surface. θ is the angle to it.
//! - `place.toward_lamp(u)` makes of a point u of the unit square the unit vector toward a uniform point of the lamp.
//! - `place.cosine_direction(u)` makes of it a direction above the surface that is distributed by the cosine.
//! - `place.lamp_seen(direction)` is the hit where a ray in this direction meets the lamp, or `None` if it does not, or if something
//!   stands before it. `hit.t` is the distance, and `hit.geometric_normal` the normal of the lamp; it faces the ray.
//! - `place.lamp_area()` is the area of the lamp.
//!
//! Fill in the five functions below.
//!
//! - `ask_density` is the density per steradian with which asking draws a direction, a unit vector: d² / (A cosθ'). Here d is the
//!   distance of the lamp in this direction, A its area, and θ' the angle at the lamp. Return 0 where the lamp is not seen, or only
//!   its edge (cosθ' = 0): there the sample is 0 anyway.
//! - `find_density` is that of `cosine_direction`: cosθ / π; 0 below the surface.
//! - `asked` is one sample that asks the lamp. A lamp below the surface gives no light.
//! - `found` is one sample that takes a cosine-distributed direction.
//! - `combined` takes both directions, one from each of its two points of the unit square, and adds both samples, each with its
//!   weight. The weight of a sample is made of the two densities of **its own** direction. No result is NaN, even where both
//!   densities are 0.
//!
//! ## When you are done
//!
//! `cargo exercise 6.4` checks your samples, and measures how many rays each way needs for an error of 10 %, for lamps from small to
//! large: the variance of a sample times the rays that it takes. It prints this as a table and draws it. Above the plot is the floor
//! below four lamps, in the three ways, with equally many rays. Read in the table where the better way changes. Then read what
//! the combination costs where one way alone would have done, and what it saves elsewhere.

use std::{f32::consts::PI, process::ExitCode};

use common::{
    Vec2, Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};

use checks::place::Place;

/// The density per steradian with which asking draws a direction.
fn ask_density(place: &Place, direction: Vec3) -> f32 {
    let _ = (place, direction); // take this line away when you start
    0.0
}

/// The density per steradian with which a cosine-distributed direction is drawn.
fn find_density(place: &Place, direction: Vec3) -> f32 {
    let _ = (place, direction, PI); // take this line away when you start
    0.0
}

/// One sample that asks the lamp.
fn asked(place: &Place, u: Vec2) -> f32 {
    let _ = (place, u); // take this line away when you start
    0.0
}

/// One sample that waits until the lamp is found.
fn found(place: &Place, u: Vec2) -> f32 {
    let _ = (place, u); // take this line away when you start
    0.0
}

/// Both, each with its weight.
fn combined(place: &Place, u_ask: Vec2, u_find: Vec2) -> f32 {
    let _ = (place, u_ask, u_find); // take this line away when you start
    0.0
}

// From here on your samples are checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

use checks::asked_or_found::Answer;

/// What you have written.
const ANSWER: Answer = Answer { ask_density, find_density, asked, found, combined };

/// What your samples look like.
const PICTURE: Picture = pictures::asked_or_found::picture(|_| pictures::asked_or_found::make(ANSWER));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your samples are right. If so, what they cost is printed.
fn accepted() -> Verdict {
    checks::asked_or_found::check(ANSWER)
}
