//! # Exercise 3.4: a budget of rays
//!
//! A greatest depth ends the recursion, but it ends it everywhere alike. A ray between two silver mirrors is still worth
//! following after ten of them; a reflection in glass, seen by reflection in glass, is not, for it brings 4 % of 4 %. And
//! nobody knows beforehand how many rays a depth costs: between 1 and 2 to its power.
//!
//! So give each camera ray a **budget** instead: so many rays may be followed, and each time the one that matters most. Every
//! ray has a share of the whole, the product of all shares on the way to the eye. Follow the camera ray; it causes new rays,
//! which now wait. Of all that wait, take out the ray with the greatest share and follow it. Its new rays wait,
//! too. Go on like this until the budget is spent or nothing waits. For rays that still wait then, guess: they bring their
//! share of the background.
//!
//! This is best-first search, and the waiting rays want a heap: `std::collections::BinaryHeap`.
//!
//! ## Your task
//!
//! Fill in `trace` below. The world gives you two functions:
//!
//! ```text
//! fn follow(&self, branch: &Branch) -> Surface;
//! fn background(&self, branch: &Branch) -> Rgb;
//!
//! struct Surface { radiance: Rgb, next: [Option<Branch>; 2] }
//! ```
//!
//! - `world.follow(&branch)` follows a ray, which takes 1 of the budget. `radiance` comes from what it hits without any further
//!   ray, be it direct light or, where nothing is hit, the background. `next` has the rays that are caused. The `share` of each
//!   is the part of **its** radiance that goes on along the ray you have followed.
//! - `world.background(&branch)` is the guess for a ray that is not followed. It takes nothing of the budget.
//!
//! Neither of them looks at `branch.share`: you may keep there what helps you.
//!
//! What `trace` must do:
//!
//! - Never follow more than `budget` rays, the camera ray among them. With a budget of 0 only the guess is left.
//! - Follow the ray next that has the greatest contribution: the mean of the three channels of its share of the whole.
//! - The result is the sum, over all rays that were followed, of their share of the whole times `radiance`, and over those that
//!   still wait in the end, of their share of the whole times `background`. The camera ray's share is `camera_ray.share`.
//! - A ray whose share of the whole is zero in all three channels is not worth following. Any other ray is, however small its
//!   share, and if only one channel is above zero.
//! - The budget may be 20,000, and the rays may lie one behind the other: do not call `trace` from `trace`. Searching a list for
//!   the greatest share is right too, only slower than a heap.
//!
//! ## When you are done
//!
//! `cargo exercise 3.4` checks your search and renders a heap of glass balls twice with the same budget: on the left, rays
//! are followed depth-first, on the right by you.

use std::process::ExitCode;

use common::{
    Rgb,
    exercise::{self, Verdict},
    picture::Picture,
};
use whitted::branches::Branch;

use checks::world::World;

/// The radiance that a camera ray brings if at most `budget` rays are followed.
fn trace(world: &dyn World, camera_ray: Branch, budget: u32) -> Rgb {
    // STUB: let _ = (world, camera_ray, budget); // take this line away when you start
    // STUB: Rgb::ZERO
    let mut radiance = Rgb::ZERO;
    let mut waiting = std::collections::BinaryHeap::from([Waiting(camera_ray)]);
    for _ in 0..budget {
        // Follow the ray that contributes most.
        let Some(Waiting(branch)) = waiting.pop() else { break };
        let surface = world.follow(&branch);
        radiance += branch.share * surface.radiance;
        // What it causes waits, each ray with its share of the whole.
        let next = surface.next.into_iter().flatten().map(|next| Branch { share: branch.share * next.share, ..next });
        waiting.extend(next.filter(|next| next.share != Rgb::ZERO).map(Waiting));
    }
    // Guess what the others would bring.
    radiance + waiting.iter().map(|Waiting(branch)| branch.share * world.background(branch)).sum::<Rgb>()
    // END STUB
}
// STUB:

/// A ray that waits to be followed, with its share of the whole. The greatest is the one that contributes most.
struct Waiting(Branch);

impl Waiting {
    fn contribution(&self) -> f32 {
        self.0.share.element_sum() / 3.0
    }
}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.contribution().total_cmp(&other.contribution())
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Waiting {}
// END STUB

// From here on your search is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your search shows.
const PICTURE: Picture = pictures::budget::picture(|settings| pictures::budget::make(settings, trace));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your search is right.
fn accepted() -> Verdict {
    checks::budget::check(trace)
}
