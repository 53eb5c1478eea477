//! # Exercise 4.4: first where a hit is likely
//!
//! A ray that looks for the nearest hit must visit boxes from front to back. A shadow ray only asks whether there is anything at
//! all between a point and the light, so it may begin anywhere. And it should begin where a hit is likely: the sooner it finds
//! one, the sooner it is done.
//!
//! Where is that? In a bush, leaves are everywhere alike. If a ray stays in one half of the bush for two meters and in the other
//! one for ten centimeters, look for a leaf on the two meters. (And a small box may hold one small leaf only, where a large one
//! holds a large leaf.) Where a few large walls are all that there is to hit, this rule helps little.
//!
//! ## Your task
//!
//! Fill in `is_occluded` below. You are given a **tree of boxes** as a list of nodes. The whole is node 0. Each node is
//!
//! ```text
//! struct Node { aabb: Aabb, content: Content }
//! enum Content {
//!     Halves([usize; 2]),   // two other nodes, by their index in the list; their boxes may overlap
//!     List(Vec<u32>),       // primitives, by their numbers
//! }
//! ```
//!
//! The box of a node holds all that is in it. There are two questions for the ray, and both are counted:
//!
//! ```text
//! fn cross(&mut self, aabb: &Aabb, range: Interval) -> Option<Interval>;
//! fn test(&mut self, number: u32, range: Interval) -> Option<f32>;
//! ```
//!
//! - `ray.cross(&aabb, range)` is the part of `range` in which the ray is inside of the box; `None` if it misses the box there.
//! - `ray.test(number, range)` is the `t` inside `range` at which the ray hits a primitive; `None` if it misses it there.
//!
//! What `is_occluded` must do:
//!
//! - The answer is `true` if any primitive is hit inside `range`, otherwise `false`. A list without nodes is an empty tree.
//! - `range` ends at the light. What lies beyond does not count, so hand `range` on to every question. It may end at infinity.
//!   (Within a box you may hand on the part that `cross` has returned for it. That counts as right too.)
//! - If the ray misses a box in `range`, nothing in it is tested.
//! - The first hit ends everything: there is no test after it.
//! - Of two halves that the ray meets, the first to be visited is that in which it is inside for longer: where `max − min` of
//!   what `cross` returns is greater. The other one is visited when the first has no hit. If both are equal, the order does not matter.
//! - The primitives of a list are tested in the order of the list.
//!
//! You may write further functions.
//!
//! ## When you are done
//!
//! `cargo exercise 4.4` checks your answer and renders a bush in the sun. The brighter a point, the more tests it took to find out
//! whether it lies in shadow: on the left with the nearer half first, on the right by you.

use std::process::ExitCode;

use common::{
    Interval,
    exercise::{self, Verdict},
    picture::Picture,
};

#[allow(unused_imports, reason = "the answer needs it")]
use checks::hierarchy::{Asking, Content, Node};

/// Whether a ray hits anything inside `range`.
fn is_occluded(nodes: &[Node], range: Interval, ray: &mut dyn Asking) -> bool {
    // STUB: let _ = (nodes, range, ray); // take this line away when you start
    // STUB: false
    let is_met = nodes.first().is_some_and(|whole| ray.cross(&whole.aabb, range).is_some());
    is_met && is_occluded_in(nodes, 0, range, ray)
    // END STUB
}
// STUB:

/// The same for what is in a node that the ray meets.
fn is_occluded_in(nodes: &[Node], number: usize, range: Interval, ray: &mut dyn Asking) -> bool {
    match &nodes[number].content {
        Content::List(list) => list.iter().any(|&number| ray.test(number, range).is_some()),
        Content::Halves(halves) => {
            // For how long the ray is inside of each half; less than not at all if it misses it.
            let lengths =
                halves.map(|half| ray.cross(&nodes[half].aabb, range).map_or(-1.0, |part| part.max - part.min));
            let [first, second] = if lengths[0] >= lengths[1] { [0, 1] } else { [1, 0] };
            [first, second].into_iter().any(|i| lengths[i] >= 0.0 && is_occluded_in(nodes, halves[i], range, ray))
        }
    }
}
// END STUB

// From here on your walk is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your walk saves.
const PICTURE: Picture =
    pictures::ordered_shadow_walk::picture(|settings| pictures::ordered_shadow_walk::make(settings, is_occluded));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your walk is right.
fn accepted() -> Verdict {
    checks::ordered_shadow_walk::check(is_occluded)
}
