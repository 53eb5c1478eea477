//! # Exercise 1.6: a torus
//!
//! The torus is the first shape that a ray can meet four times, so its equation is of fourth degree. There is a formula for
//! the roots of such an equation, but in floating point it fails often and without notice. This exercise finds them another
//! way, one that works for polynomials of any degree.
//!
//! A torus lies flat around its center, with y as its axis: a tube of radius r (minor) around a circle of radius R (major).
//! Seen from the center, its points are
//!
//! ```text
//! (x² + y² + z² + R² − r²)² = 4R²·(x² + z²)
//! ```
//!
//! Now move the ray's origin along the ray to the point s that is nearest to the center, so that s·d = 0, and let d have unit
//! length. With u for the ray parameter from there, the equation is
//!
//! ```text
//! u⁴ + b·u² + c·u + e = 0      k = s·s + R² − r²
//!
//! b = 2k − 4R²·(dx² + dz²)     c = −8R²·(sx·dx + sz·dz)     e = k² − 4R²·(sx² + sz²)
//! ```
//!
//! Between two neighboring extrema a function only rises or only falls, so it has one root there if its ends differ in sign,
//! and none if they do not. The extrema are the roots of the derivative, 4u³ + 2b·u + c. And the extrema of the derivative are
//! the roots of 12u² + 2b, which is easy. So go up the stairs: from those to the roots of the cubic, and from these to the
//! roots of the quartic.
//!
//! ## Your task
//!
//! Fill in `Torus::intersect` below. The book's page *Implicit surfaces* shows bisection.
//!
//! - The answer is the nearest hit in the open interval `range`, or `None`. All four hits are found: a range that begins
//!   behind the first gives the second.
//! - `t` counts lengths of the ray's direction, which need not be of unit length: if you make it a unit vector, turn your
//!   root back into `t`. It also counts from the ray's own origin.
//! - The outward normal points from the nearest point of the circle in the middle of the tube to the hit.
//! - A ray that starts 1000 units away finds its hit as well as one that starts 10 units away. This is why the origin is moved
//!   first: without that, the coefficients are huge, nearly cancel, and lose all their digits.
//!
//! ## When you are done
//!
//! `cargo exercise 1.6` checks your torus and renders interlocked rings.

use std::process::ExitCode;

use common::{
    Interval, Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::{hit::Hit, ray::Ray, shape::Shape};

/// A ring that lies flat: a tube around a circle.
struct Torus {
    /// Its middle, in scene units.
    center: Vec3,
    /// Radius R of the circle in the middle of the tube, in scene units.
    major: f32,
    /// Radius r of the tube, in scene units; less than `major`.
    minor: f32,
}

impl Torus {
    /// The torus around `center` with the axis y.
    fn new(center: Vec3, major: f32, minor: f32) -> Self {
        Self { center, major, minor }
    }
}

impl Shape for Torus {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let _ = (self.center, self.major, self.minor, ray, range); // take this line away when you start
        None
    }
}

// From here on your torus is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your torus looks like.
const PICTURE: Picture = pictures::torus::picture(|settings| pictures::torus::make(settings, Torus::new));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your torus is right.
fn accepted() -> Verdict {
    checks::torus::check(Torus::new)
}
