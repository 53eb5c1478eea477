//! # Exercise 1.1: a plane
//!
//! A floor without end, a wall, the surface of the sea: the plane is the plainest shape there is, and the only one whose
//! ray parameter falls out of one division. It is a good first shape to write yourself, because everything that every
//! shape must care for is in it already.
//!
//! A plane is given by one of its points, p, and its normal n, a vector at right angles to it. A point r lies in the
//! plane if the way from p to r is at right angles to the normal:
//!
//! ```text
//! (r − p) · n = 0
//! ```
//!
//! A ray reaches the points r = s + t·d. Put them into the equation, and solve it for t.
//!
//! ## Your task
//!
//! Fill in `Plane::intersect` below. The book's pages *Shapes* and *Rays and hits* say what an answer must look like;
//! `chapters/01-ray-casting/src/sphere.rs` shows another shape.
//!
//! - The answer is the hit in the open interval `range`, or `None`. `range.contains(t)` tells whether `t` counts.
//! - `t` counts lengths of the ray's direction, which need not be of unit length. Neither need the plane's normal.
//! - The plane is hit from both sides. Give `Hit::new` the plane's own normal: it makes it a unit vector, turns it to
//!   face the ray, and notes the side.
//! - A ray parallel to the plane hits nothing, also when it lies inside the plane. What does a division by zero give in
//!   floating point, and which interval contains that?
//!
//! ## When you are done
//!
//! `cargo exercise 1.1` checks your plane and renders the corner of a room, made of three planes.

use std::process::ExitCode;

use common::{
    Interval, Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::{hit::Hit, ray::Ray, shape::Shape};

/// All points of space whose way from `point` is at right angles to `normal`.
struct Plane {
    /// One point of the plane, in scene units.
    point: Vec3,
    /// A vector at right angles to the plane, of any length but zero.
    normal: Vec3,
}

impl Plane {
    /// The plane through `point` at right angles to `normal`.
    fn new(point: Vec3, normal: Vec3) -> Self {
        Self { point, normal }
    }
}

impl Shape for Plane {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        // STUB: let _ = (self.point, self.normal, ray, range); // take this line away when you start
        // STUB: None
        // (s + t·d − p) · n = 0, solved for t. A ray along the plane divides by zero: then t is infinite or not a number,
        // and no range contains it.
        let t = (self.point - ray.origin).dot(self.normal) / ray.direction.dot(self.normal);
        range.contains(t).then(|| Hit::new(ray, t, self.normal))
        // END STUB
    }
}

// From here on your plane is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your plane looks like.
const PICTURE: Picture = pictures::plane::picture(|settings| pictures::plane::make(settings, Plane::new));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your plane is right.
fn accepted() -> Verdict {
    checks::plane::check(Plane::new)
}
