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
    // STUB:

    /// The quartic `u⁴ + b·u² + c·u + e` of a ray that starts in `s`, the point nearest to the center, seen from there, and
    /// runs in the direction of the unit vector `d`.
    fn quartic(&self, s: Vec3, d: Vec3) -> Quartic {
        let (major2, minor2) = (self.major * self.major, self.minor * self.minor);
        let k = s.dot(s) + major2 - minor2;
        // Only x and z: seen from above.
        let (s, d) = (s.with_y(0.0), d.with_y(0.0));
        Quartic {
            b: 2.0 * k - 4.0 * major2 * d.dot(d),
            c: -8.0 * major2 * s.dot(d),
            e: k * k - 4.0 * major2 * s.dot(s),
        }
    }
    // END STUB
}

impl Shape for Torus {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        // STUB: let _ = (self.center, self.major, self.minor, ray, range); // take this line away when you start
        // STUB: None
        // Start in the point nearest to the center: small numbers keep their digits.
        let length = ray.direction.length();
        let d = ray.direction / length;
        let from_center = ray.origin - self.center;
        let shift = -from_center.dot(d);
        let s = from_center + d * shift;
        // The torus lies inside a sphere, and the ray inside that for half a chord before and behind s. The sphere is a
        // little too large, so that the chord surely ends outside the torus, also at its rim.
        let bound = 1.01 * (self.major + self.minor);
        let half_chord = (bound * bound - s.dot(s)).sqrt();
        if half_chord.is_nan() {
            return None;
        }
        let roots = self.quartic(s, d).roots_within(half_chord);
        let (t, u) = roots.into_iter().map(|u| ((u + shift) / length, u)).find(|(t, _)| range.contains(*t))?;
        // The nearest point of the circle lies in the same direction from the axis, at the major radius.
        let p = s + d * u;
        let middle = p.with_y(0.0).normalize_or_zero() * self.major;
        Some(Hit::new(ray, t, p - middle))
        // END STUB
    }
}
// STUB:

/// The polynomial `u⁴ + b·u² + c·u + e`. There is no cubic term, because the ray starts in the point nearest to the center.
struct Quartic {
    b: f32,
    c: f32,
    e: f32,
}

impl Quartic {
    /// Its roots between `−end` and `end`, in ascending order.
    fn roots_within(&self, end: f32) -> Vec<f32> {
        let Self { b, c, e } = *self;
        let value = |u: f32| ((u * u + b) * u + c) * u + e;
        let slope = |u: f32| (4.0 * u * u + 2.0 * b) * u + c;
        // The curvature 12u² + 2b has these roots; without them it has one sign throughout.
        let bend = (-b / 6.0).sqrt();
        let bends = if bend < end { vec![-end, -bend, bend, end] } else { vec![-end, end] };
        // Between its bends the slope has at most one root, and between those the value has.
        let turns = roots_between(slope, &bends);
        let stops: Vec<f32> = [-end].into_iter().chain(turns).chain([end]).collect();
        roots_between(value, &stops)
    }
}

/// The roots of a function that only rises or only falls from each stop to the next.
fn roots_between(value: impl Fn(f32) -> f32, stops: &[f32]) -> Vec<f32> {
    let is_negative = |u: f32| value(u) < 0.0;
    let changes = stops.windows(2).filter(|ends| is_negative(ends[0]) != is_negative(ends[1]));
    changes.map(|ends| bisect(&value, ends[0], ends[1])).collect()
}

/// The place between `low` and `high` where the sign of `value` changes.
fn bisect(value: impl Fn(f32) -> f32, mut low: f32, mut high: f32) -> f32 {
    let starts_negative = value(low) < 0.0;
    // Each round halves the interval; 30 rounds use up the digits of an f32, also of a root near zero.
    for _ in 0..30 {
        let middle = (low + high) / 2.0;
        if (value(middle) < 0.0) == starts_negative {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low + high) / 2.0
}
// END STUB

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
