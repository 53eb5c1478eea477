//! # Exercise 4.6: a bounding volume hierarchy
//!
//! Grid, octree and kd-tree divide space, and an object that reaches into several cells is listed in each. One can as well divide
//! the *objects*: put all of them into a box; part them into two halves, and put each half into a box of its own; do the same with
//! the halves, until few are left. Each object is in one list only, and boxes may overlap. This is a **bounding volume
//! hierarchy**, BVH for short, and what most renderers use today.
//!
//! ## Your task
//!
//! Fill in `build` and `nearest` below. A tree is a list of nodes. The whole is node 0. Each node is
//!
//! ```text
//! struct Node { aabb: Aabb, content: Content }
//! enum Content {
//!     Halves([usize; 2]),   // two other nodes, by their index in the list
//!     List(Vec<u32>),       // primitives, by their numbers
//! }
//! ```
//!
//! `build` makes a tree of the boxes around primitives. Primitive number `i` is in `boxes[i]`.
//!
//! - Each primitive stands in exactly one list. No list is empty, and none is longer than 8.
//! - The box of a node is the smallest one that holds the boxes of all its primitives, exactly.
//! - Each node but node 0 is the half of exactly one other node.
//! - No node is deeper than 64 levels below node 0, whatever the boxes are: a thousand of them may lie in the same place, and all of
//!   them may be flat. There are up to 20,000. If there is none, the tree has no nodes.
//! - It is a good tree: when the nearest hit is searched in it, there are at most 1.3 times as many tests as in one that
//!   parts primitives like this. Take the center of each box, and the box around all centers; sort the primitives by their
//!   centers along its longest axis, and part them in the middle of that order; stop at 8.
//!
//! `nearest` finds what a ray hits first. There are two questions for the ray, and both are counted:
//!
//! ```text
//! fn cross(&mut self, aabb: &Aabb, range: Interval) -> Option<Interval>;
//! fn test(&mut self, number: u32, range: Interval) -> Option<f32>;
//! ```
//!
//! - `ray.cross(&aabb, range)` is the part of `range` in which the ray is inside of the box; `None` if it misses the box there.
//! - `ray.test(number, range)` is the `t` inside the open `range` at which the ray hits a primitive; `None` if it misses it there.
//! - The answer is the nearest hit inside `range`, `None` if there is none. Of several hits at the same `t`, it is that of the
//!   least number. So a hit must not shorten the range to `t` itself, or an equal one would no longer count: `range.up_to(t.next_up())`
//!   ends just behind it.
//! - Of two halves that the ray meets, the one that it enters first is visited first: where `min` of what `cross` returns is less. If
//!   both are equal, the order does not matter.
//! - What lies behind the nearest hit so far is not tested. A half that was met *before* the hit was found may lie behind it.
//! - `nearest` works for any tree of this kind, not only for those of your `build`, also for one without nodes.
//!
//! You may write further functions and types.
//!
//! ## When you are done
//!
//! `cargo exercise 4.6` checks your answer and renders a teapot in a stadium: on the left as your tree finds it, on the right as many
//! steps as each ray takes.

use std::process::ExitCode;

use common::{
    Interval,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::aabb::Aabb;
use space_partitioning::query::Found;

#[allow(unused_imports, reason = "the answer needs it")]
use checks::hierarchy::{Asking, Content, Node};

/// A tree over primitives, by the boxes around them.
fn build(boxes: &[Aabb]) -> Vec<Node> {
    let _ = boxes; // take this line away when you start
    Vec::new()
}

/// What a ray hits first inside `range`: `Found { number, t }`.
fn nearest(nodes: &[Node], range: Interval, ray: &mut dyn Asking) -> Option<Found> {
    let _ = (nodes, range, ray); // take this line away when you start
    None
}

// From here on your answer is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your tree shows.
const PICTURE: Picture = pictures::bounding_volume_hierarchy::picture(|settings| {
    pictures::bounding_volume_hierarchy::make(settings, build, nearest)
});

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your tree is right.
fn accepted() -> Verdict {
    checks::bounding_volume_hierarchy::check(build, nearest)
}
