//! # Exercise 4.2: a mailbox for every ray
//!
//! In a grid, a long triangle reaches into many cells and stands in the list of each. A ray that visits ten of them tests the
//! same triangle ten times, and nine of the tests can tell nothing new. The remedy is called **mailboxing**: when a ray has
//! tested a primitive, it leaves a note, and where it comes upon that primitive again, it passes on.
//!
//! Recall from the chapter what a structure asks of its primitives (`primitives.rs`). Before a ray meets any of them, it is
//! prepared once: `view(ray)` makes a `View`, whatever that is. Then, for every primitive in every list,
//! `intersect(entry, view, range)` is asked. An entry is what a list holds, and `number(entry)` says of which primitive.
//!
//! So mailboxing needs no change in any structure. It can be put around the primitives: `Mailboxed` below holds other
//! primitives and hands all questions on to them.
//!
//! ## Your task
//!
//! Fill in `View`, `view` and `intersect` of `Mailboxed` below.
//!
//! - While a ray is on its way, `self.0.intersect` is asked about no primitive more than once. When `Mailboxed::intersect` is asked
//!   about it again, the answer is `None`.
//! - When it is asked for the first time, the answer is that of `self.0.intersect` with the same entry and range, hit or not.
//! - Notes belong to one ray. The next ray begins without any. Many rays may be on their way at the same time, in one
//!   thread or in several, so the notes cannot lie in `Mailboxed` itself. In which of the two types can they lie?
//! - A ray may test any number of primitives, and none of its notes may get lost.
//!
//! `intersect` gets the view as `&Self::View`, which cannot be changed, and a note is a change. The standard library has a type
//! for what changes behind a `&`, within one thread: `std::cell::RefCell`. For the notes themselves a `Vec<u32>` will do, or a
//! `std::collections::HashSet<u32>`, or whatever you like.
//!
//! Why may the second test be left out? Since the first one, the range has become shorter or has stayed as it was. What was not
//! hit then is not hit now, and what was hit then is known.
//!
//! ## When you are done
//!
//! `cargo exercise 4.2` checks your answer and renders a ball of spikes in a grid. The brighter a pixel, the more tests its
//! ray took: on the left without, on the right with your notes.

use std::process::ExitCode;

use common::{
    Interval, Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::{aabb::Aabb, hit::Hit, ray::Ray};
use space_partitioning::primitives::Primitives;

/// Primitives that each ray tests only once.
struct Mailboxed<P>(P);

impl<P: Primitives> Primitives for Mailboxed<P> {
    type View = P::View;
    type Entry = P::Entry;

    /// Prepare a ray.
    fn view(&self, ray: &Ray) -> Self::View {
        self.0.view(ray)
    }

    /// The `t` inside `range` at which a ray hits a primitive that it has not tested before.
    fn intersect(&self, entry: &Self::Entry, view: &Self::View, range: Interval) -> Option<f32> {
        self.0.intersect(entry, view, range)
    }

    // All the rest is handed on. There is nothing to do here.

    fn count(&self) -> u32 {
        self.0.count()
    }

    fn aabb(&self, number: u32) -> Aabb {
        self.0.aabb(number)
    }

    fn clipped(&self, number: u32, cell: &Aabb) -> Option<Aabb> {
        self.0.clipped(number, cell)
    }

    fn octants(&self, number: u32, cell: &Aabb, middle: Vec3) -> [Option<Aabb>; 8] {
        self.0.octants(number, cell, middle)
    }

    fn entry(&self, number: u32) -> Self::Entry {
        self.0.entry(number)
    }

    fn number(&self, entry: &Self::Entry) -> u32 {
        self.0.number(entry)
    }

    fn hit(&self, number: u32, ray: &Ray, t: f32) -> Option<Hit> {
        self.0.hit(number, ray, t)
    }
}

// From here on your answer is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your notes save.
const PICTURE: Picture = pictures::mailboxing::picture(|settings| pictures::mailboxing::make(settings, Mailboxed));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your answer is right.
fn accepted() -> Verdict {
    checks::mailboxing::check(Mailboxed)
}
