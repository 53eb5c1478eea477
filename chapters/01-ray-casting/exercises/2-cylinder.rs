//! # Exercise 1.2: a capped cylinder
//!
//! The chapter's cylinder is a quadric cut off by a box: an open tube, through which one can look. A coin, a can or a
//! pencil is closed. Here you make a shape from three parts, a tube and two discs, and the nearest hit of the parts is the
//! hit of the whole. It is what a scene does with its objects, inside one shape.
//!
//! The cylinder stands upright on the middle of its base, b. Seen from there (subtract b from the ray's origin), its three
//! parts are
//!
//! ```text
//! tube         x² + z² = R²    where 0 ≤ y ≤ height
//! bottom cap   y = 0           where x² + z² ≤ R²
//! top cap      y = height      where x² + z² ≤ R²
//! ```
//!
//! Each is an equation with a condition. With r = s + t·d, the tube's equation is quadratic in t, and its condition must be
//! asked of both roots: the nearer one may be cut away while the farther one is still there. The equation of a cap is
//! linear in t.
//!
//! ## Your task
//!
//! Fill in `Cylinder::intersect` below. The book's pages *Spheres* and *Quadrics* help; `ray_casting::quadratic` solves
//! quadratic equations, and you may use it.
//!
//! - The answer is the nearest hit of the three parts in the open interval `range`, or `None`.
//! - `t` counts lengths of the ray's direction, which need not be of unit length.
//! - The outward normal of the tube points away from the axis, that of the bottom cap down, that of the top cap up. Give
//!   the outward one to `Hit::new`, also when the ray comes from inside.
//! - A ray along the axis meets both caps, and a ray at right angles to it no cap. Neither is an error.
//!
//! ## When you are done
//!
//! `cargo exercise 1.2` checks your cylinder and renders a desk with coins, drums and pencils.

use std::process::ExitCode;

use common::{
    Interval, Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::{hit::Hit, ray::Ray, shape::Shape};

/// An upright cylinder, closed at both ends.
struct Cylinder {
    /// Middle of the bottom cap, in scene units.
    base: Vec3,
    /// Radius of the tube and of both caps, in scene units.
    radius: f32,
    /// How far the top cap is above the bottom cap, in scene units.
    height: f32,
}

impl Cylinder {
    /// The cylinder that stands on `base`, upright along y.
    fn new(base: Vec3, radius: f32, height: f32) -> Self {
        Self { base, radius, height }
    }
}

impl Shape for Cylinder {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let _ = (self.base, self.radius, self.height, ray, range); // take this line away when you start
        None
    }
}

// From here on your cylinder is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your cylinder looks like.
const PICTURE: Picture = pictures::cylinder::picture(|settings| pictures::cylinder::make(settings, Cylinder::new));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your cylinder is right.
fn accepted() -> Verdict {
    checks::cylinder::check(Cylinder::new)
}
