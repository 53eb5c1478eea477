//! # Exercise 2.1: any hit will do
//!
//! A camera ray asks where it hits, on which side, and with what normal. A shadow ray asks for much less: is there
//! anything between the point and the light? Yes or no. Where it is does not matter, and of two hits either will do.
//!
//! So a shape may answer this question in a way of its own. Every shape has a second function for it, `occluded`, which
//! asks `intersect` unless somebody writes a better one. You write one for the sphere, without hit, normal or square root.
//!
//! Think of the way from the point to the light as a piece of string, and of the sphere as a hollow ball. The string
//! begins at `ray.at(range.min)` and ends at `ray.at(range.max)`. Each of its ends lies inside the ball or outside:
//!
//! ```text
//! one end inside, one outside      the string passes through the surface
//! both ends inside                 it never reaches the surface, which is all there is to hit
//! both ends outside                it passes the ball by, or it goes in at one place and comes out at another
//! ```
//!
//! For the last case you need one more point: the one where the ray comes nearest to the center of the ball.
//!
//! ## Your task
//!
//! Fill in `Ball::occluded` below. The book's page *Shadow rays* says what the question is.
//!
//! - The answer is `true` if the ray meets the surface anywhere in the open interval `range`, otherwise `false`.
//! - `t` counts lengths of the ray's direction, which need not be of unit length.
//! - The range may begin before the origin of the ray or behind it, and it may end at infinity: sunlight does. Infinity
//!   is outside every ball. What is 0·∞ in floating point, and what comes out when you compare with that?
//! - A range whose end does not come after its beginning is empty, and nothing lies in it. `Interval` has a function for
//!   that.
//! - Balls may be as small as a grain of dust, 0.001 scene units, and 10,000 times as far away as they are large. Chapter 1's
//!   page *Spheres* tells which formula rounding spoils there.
//! - When an end of the range lies on the surface itself, or the ray just grazes the ball, rounding decides, and either
//!   answer is accepted.
//!
//! The check cannot see whether you call `intersect` or take a square root. It is a matter of honor.
//!
//! ## When you are done
//!
//! `cargo exercise 2.1` checks your answer and renders balls in the evening sun. Every shadow in it is yours.

use std::process::ExitCode;

use common::{
    Interval, Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::{hit::Hit, ray::Ray, shape::Shape, sphere::Sphere};

/// A sphere with an answer of its own for shadow rays.
struct Ball {
    /// Center, in scene units.
    center: Vec3,
    /// Radius, in scene units; greater than zero.
    radius: f32,
}

impl Ball {
    /// A ball around `center`.
    fn new(center: Vec3, radius: f32) -> Self {
        Self { center, radius }
    }
}

impl Shape for Ball {
    /// What a camera ray asks. There is nothing to do here.
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        Sphere::new(self.center, self.radius).intersect(ray, range)
    }

    /// What a shadow ray asks: whether anything is hit inside `range`.
    fn occluded(&self, ray: &Ray, range: Interval) -> bool {
        // STUB: let _ = (ray, range); // take this line away when you start
        // STUB: false
        if range.is_empty() {
            return false;
        }
        // At infinity the distance is infinite or not a number. Neither is less than the radius, so that is outside.
        let is_inside = |t: f32| ray.at(t).distance_squared(self.center) < self.radius * self.radius;
        let (begins_inside, ends_inside) = (is_inside(range.min), is_inside(range.max));
        // One end inside and one outside: the way passes through the surface.
        if begins_inside != ends_inside {
            return true;
        }
        // Both inside: it never reaches the surface. Both outside: it must go in before it comes out again.
        let nearest = (self.center - ray.origin).dot(ray.direction) / ray.direction.length_squared();
        !begins_inside && range.contains(nearest) && is_inside(nearest)
        // END STUB
    }
}

// From here on your answer is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// The shadows that your answer casts.
const PICTURE: Picture = pictures::any_hit::picture(|settings| pictures::any_hit::make(settings, Ball::new));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your answer is right.
fn accepted() -> Verdict {
    checks::any_hit::check(Ball::new)
}
