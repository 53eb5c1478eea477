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
    // STUB: let _ = boxes; // take this line away when you start
    // STUB: Vec::new()
    let mut nodes = Vec::new();
    let mut numbers: Vec<u32> = (0..).take(boxes.len()).collect();
    if !numbers.is_empty() {
        grow(&mut nodes, boxes, &mut numbers);
    }
    nodes
    // END STUB
}

/// What a ray hits first inside `range`: `Found { number, t }`.
fn nearest(nodes: &[Node], range: Interval, ray: &mut dyn Asking) -> Option<Found> {
    // STUB: let _ = (nodes, range, ray); // take this line away when you start
    // STUB: None
    let mut search = Search { nodes, range, found: None };
    if nodes.first().is_some_and(|whole| ray.cross(&whole.aabb, range).is_some()) {
        search.visit(0, ray);
    }
    search.found
    // END STUB
}
// STUB:

/// Lists may have that many primitives.
const FEW: usize = 8;

/// Make a node of some primitives. Returns its index.
fn grow(nodes: &mut Vec<Node>, boxes: &[Aabb], numbers: &mut [u32]) -> usize {
    let around = |boxes: &mut dyn Iterator<Item = Aabb>| {
        let grown = |a: Aabb, b: Aabb| Aabb { min: a.min.min(b.min), max: a.max.max(b.max) };
        boxes.reduce(grown).unwrap_or(Aabb::EVERYTHING)
    };
    // The node comes before its halves, so that the whole is number 0. What is in it is known in the end.
    let index = nodes.len();
    let aabb = around(&mut numbers.iter().map(|&number| boxes[number as usize]));
    nodes.push(Node { aabb, content: Content::List(Vec::new()) });
    nodes[index].content = if numbers.len() <= FEW {
        Content::List(numbers.to_vec())
    } else {
        // Part by the centers, along the axis where they lie farthest apart.
        let center = |number: u32| boxes[number as usize].center();
        let centers = around(&mut numbers.iter().map(|&number| Aabb { min: center(number), max: center(number) }));
        let axis = (centers.max - centers.min).max_position();
        let half = numbers.len() / 2;
        numbers.select_nth_unstable_by(half, |&a, &b| center(a)[axis].total_cmp(&center(b)[axis]));
        let (lower, upper) = numbers.split_at_mut(half);
        Content::Halves([grow(nodes, boxes, lower), grow(nodes, boxes, upper)])
    };
    index
}

/// The search of one ray.
struct Search<'n> {
    nodes: &'n [Node],
    /// Where hits count. It ends just behind the nearest one so far.
    range: Interval,
    found: Option<Found>,
}

impl Search<'_> {
    /// Visit a node that the ray meets.
    fn visit(&mut self, number: usize, ray: &mut dyn Asking) {
        match &self.nodes[number].content {
            Content::List(list) => {
                for &number in list {
                    let Some(t) = ray.test(number, self.range) else { continue };
                    if self.found.is_none_or(|found| t < found.t || number < found.number) {
                        self.found = Some(Found { number, t });
                        self.range = self.range.up_to(t.next_up());
                    }
                }
            }
            Content::Halves(halves) => {
                let mut met: Vec<_> = halves
                    .iter()
                    .filter_map(|&half| Some((ray.cross(&self.nodes[half].aabb, self.range)?.min, half)))
                    .collect();
                met.sort_by(|a, b| a.0.total_cmp(&b.0));
                for (enters, half) in met {
                    // Meanwhile, something may have been hit before this half begins.
                    if enters <= self.range.max {
                        self.visit(half, ray);
                    }
                }
            }
        }
    }
}
// END STUB

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
