//! # Exercise 4.3: median or cost?
//!
//! Where should a kd-tree halve a cell? The obvious plane is the median: half of the primitives to the left, half to the right.
//! It is not a good one. It makes both halves equally hard for a ray that gets there, and forgets that some halves are met by many
//! rays and others by few. Better is a plane that cuts off a large empty space.
//!
//! The **surface area heuristic** says how good a plane is. A ray that meets a box meets a smaller box inside of it with the
//! probability
//!
//! ```text
//! surface of the smaller box / surface of the larger box
//! ```
//!
//! (for rays of all places and directions that begin and end outside). So a ray that meets a cell must take one step in any
//! case, and then, with these two probabilities, test what is in the two halves. The expected cost is
//!
//! ```text
//! cost = TRAVERSAL + TEST · (S_lower/S · lower + S_upper/S · upper)
//! ```
//!
//! where `lower` and `upper` are the numbers of primitives in the two halves, and S, S_lower and S_upper the surfaces of the cell
//! and of its halves. If the cell stays whole, all its `n` primitives are tested: `TEST · n`.
//!
//! The page on the surface area heuristic has shorter names: c_t is `TRAVERSAL` and c_i is `TEST`, n_1 is `lower` and n_2 is
//! `upper`. Its bonus for an empty half does not exist here.
//!
//! ## Your task
//!
//! Fill in `cost` and `cheapest` below. You are given
//!
//! ```text
//! const TRAVERSAL: f32; const TEST: f32;              // of one step, of one test
//! struct Span { begin: f32, end: f32 }                // begin ≤ end
//! struct Plane { position: f32, lower: usize, upper: usize, cost: f32 }
//! struct Aabb { min: Vec3, max: Vec3 }                // `aabb.min[axis]` is one coordinate, axis 0, 1 or 2
//! ```
//!
//! - `cost` is the expected cost of a ray that meets `cell` if a plane at right angles to `axis` halves it at `position`. A cell may be
//!   flat along one axis, but never along two: its surface is greater than zero.
//!
//! `cheapest` gets a cell and, for each of its primitives, the span that it takes up along `axis`. All spans lie in the cell.
//!
//! - The planes in question are those at the begin and at the end of each span, as far as they lie strictly inside of the cell, not in
//!   its faces. (Between two of them, the cost is least at one of its ends, so no other plane is better.)
//! - A primitive counts for the lower half if its span begins before the plane, and for the upper half if it ends behind it. Many count
//!   for both. One that lies *in* the plane, with `begin` and `end` both at `position`, counts for the lower half.
//! - The result is the plane of the least cost, with its two numbers and its cost. If several have the same cost, any of them.
//! - It is `None` if no plane costs less than to leave the cell whole, or if there is none.
//! - It must be fast: there are up to 400,000 spans, and a loop over all of them for every plane would take minutes. Sort them. Then a
//!   plane that sweeps over the cell meets begins and ends in their order, and only has to count on. The time is in proportion
//!   to n·log n.
//!
//! You may write further functions.
//!
//! ## When you are done
//!
//! `cargo exercise 4.3` checks your answer and renders a teapot in a stadium. The brighter a pixel, the more steps its ray took: on
//! the left in a kd-tree by the median, on the right in one by your planes.

use std::process::ExitCode;

use common::{
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::aabb::Aabb;

#[allow(unused_imports, reason = "the answer needs them")]
use checks::median_or_cost::{Plane, Span, TEST, TRAVERSAL};

/// Expected cost of a ray that meets a cell which is halved by a plane.
fn cost(cell: &Aabb, axis: usize, position: f32, lower: usize, upper: usize) -> f32 {
    // STUB: let _ = (cell, axis, position, lower, upper); // take this line away when you start
    // STUB: 0.0
    let half_surface = |aabb: &Aabb| {
        let size = aabb.max - aabb.min;
        size.x * size.y + size.y * size.z + size.z * size.x
    };
    let [mut below, mut above] = [*cell; 2];
    below.max[axis] = position;
    above.min[axis] = position;
    let tests = half_surface(&below) * lower as f32 + half_surface(&above) * upper as f32;
    TRAVERSAL + TEST * tests / half_surface(cell)
    // END STUB
}

/// The cheapest plane at right angles to an axis; `None` if the cell is better left whole.
fn cheapest(cell: &Aabb, axis: usize, spans: &[Span]) -> Option<Plane> {
    // STUB: let _ = (cell, axis, spans); // take this line away when you start
    // STUB: None
    // All begins and ends in their order.
    let mut places: Vec<f32> = spans.iter().flat_map(|span| [span.begin, span.end]).collect();
    let mut begins: Vec<f32> = spans.iter().filter(|span| span.begin < span.end).map(|span| span.begin).collect();
    let mut points: Vec<f32> = spans.iter().filter(|span| span.begin == span.end).map(|span| span.end).collect();
    let mut ends: Vec<f32> = spans.iter().map(|span| span.end).collect();
    for list in [&mut places, &mut begins, &mut points, &mut ends] {
        list.sort_by(f32::total_cmp);
    }
    let (mut begun, mut passed, mut ended) = (0, 0, 0);
    let mut best: Option<Plane> = None;
    let whole = TEST * spans.len() as f32;
    // Sweep: how many have begun before the plane, how many lie before or in it, how many have ended.
    for position in places {
        while begun < begins.len() && begins[begun] < position {
            begun += 1;
        }
        while passed < points.len() && points[passed] <= position {
            passed += 1;
        }
        while ended < ends.len() && ends[ended] <= position {
            ended += 1;
        }
        let (lower, upper) = (begun + passed, ends.len() - ended);
        let cost = cost(cell, axis, position, lower, upper);
        let is_inside = cell.min[axis] < position && position < cell.max[axis];
        if is_inside && cost < best.map_or(whole, |best| best.cost) {
            best = Some(Plane { position, lower, upper, cost });
        }
    }
    best
    // END STUB
}

// From here on your answer is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your planes save.
const PICTURE: Picture =
    pictures::median_or_cost::picture(|settings| pictures::median_or_cost::make(settings, cheapest));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your answer is right.
fn accepted() -> Verdict {
    checks::median_or_cost::check(cost, cheapest)
}
