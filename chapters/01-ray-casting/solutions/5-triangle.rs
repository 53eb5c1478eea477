//! # Exercise 1.5: a triangle by Möller and Trumbore
//!
//! The book knows two ways to meet a triangle. Most renderers that you will read use a third one, published by Tomas Möller
//! and Ben Trumbore in 1997: it computes no plane and keeps nothing beside the corners.
//!
//! A point of the triangle is the first corner and a share of each of the two edges that leave it, and it lies on the ray:
//!
//! ```text
//! s + t·d = r1 + u·e1 + v·e2      with e1 = r2 − r1, e2 = r3 − r1
//!
//! u·e1 + v·e2 − t·d = s − r1      three linear equations for t, u and v
//! ```
//!
//! Cramer's rule solves them, and the determinants are triple products such as (d × e2)·e1. Put in order, they need two
//! cross products and one division:
//!
//! ```text
//! p = d × e2      determinant = p · e1      f = s − r1      q = f × e1
//!
//! u = (p · f) / determinant      v = (q · d) / determinant      t = (q · e2) / determinant
//! ```
//!
//! ## Your task
//!
//! Fill in `moller_trumbore` below. The book's page *Triangles by barycentric coordinates* says what the weights mean;
//! `chapters/01-ray-casting/src/triangle_edges.rs` shows another way to the same answer.
//!
//! - The answer is the hit in the open interval `range`, or `None`. `t` counts lengths of the ray's direction.
//! - A hit lies inside if no weight is negative. The weights are [1 − u − v, u, v]: one for each corner, and they sum to 1.
//! - The triangle is hit from both sides. The determinant is negative on one of them.
//! - Where the determinant is exactly 0, because the ray runs along the triangle or the triangle has no area, nothing is
//!   hit. A small determinant may belong to a small triangle, so no other number will do as a limit.
//!
//! One thing this way cannot do: two neighbors round their common edge differently, so a ray may slip through between
//! them. The chapter's own triangle is watertight.
//!
//! ## When you are done
//!
//! `cargo exercise 1.5` checks your function and renders three lattice balls, cut out of their triangles by your weights.

use std::process::ExitCode;

use common::{
    Interval,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::{
    ray::Ray,
    triangle::{Triangle, TriangleHit},
};

/// The hit of a ray and a triangle, with the weights of its corners.
///
/// Source: Möller, Trumbore, *Fast, Minimum Storage Ray/Triangle Intersection*, Journal of Graphics Tools 2(1), 1997.
fn moller_trumbore(triangle: &Triangle, ray: &Ray, range: Interval) -> Option<TriangleHit> {
    // STUB: let _ = (triangle, ray, range); // take this line away when you start
    // STUB: None
    let [r1, r2, r3] = triangle.corners;
    let (e1, e2) = (r2 - r1, r3 - r1);
    let p = ray.direction.cross(e2);
    let determinant = p.dot(e1);
    // Exactly zero: there is no solution, or no area. Anything else has one, however small it is.
    if determinant == 0.0 {
        return None;
    }
    let f = ray.origin - r1;
    let q = f.cross(e1);
    let (u, v, t) = (p.dot(f) / determinant, q.dot(ray.direction) / determinant, q.dot(e2) / determinant);
    let weights = [1.0 - u - v, u, v];
    let is_hit = weights.iter().all(|w| *w >= 0.0) && range.contains(t);
    is_hit.then_some(TriangleHit { t, weights })
    // END STUB
}

// From here on your function is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your triangles look like.
const PICTURE: Picture = pictures::triangle::picture(|settings| pictures::triangle::make(settings, moller_trumbore));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your function is right.
fn accepted() -> Verdict {
    checks::triangle::check(moller_trumbore)
}
