//! # Exercise 2.5: the terminator mended
//!
//! A coarse mesh that is shaded smooth looks round, but casts shadows as it is. Where light fades into shadow, some flat
//! triangles hide points that the interpolated normal still calls lit, and the shadow's edge becomes a staircase. The
//! book's page *The shadow terminator* shows it.
//!
//! The round surface that the normals pretend lies a little above the flat triangles. So let shadow rays start up there.
//! In each corner we know the round surface: its normal nᵢ is given, so we know the plane that touches it there.
//!
//! ```text
//! heightᵢ = (cornerᵢ − point) · nᵢ                       how far that plane lies above the point, along nᵢ
//! pointᵢ  = point + max(heightᵢ, 0) · nᵢ                  the point, lifted onto the plane if it lies below
//! lifted  = α · point₁ + β · point₂ + γ · point₃          with the weights of the point in the triangle
//! ```
//!
//! In a corner nothing is lifted, since the plane goes through it. On an edge only its two corners count, so two triangles
//! agree on what they share. In a hollow the planes lie below the point, and nothing is lifted either.
//!
//! Source: Hanika, *Hacking the Shadow Terminator*, Ray Tracing Gems II chapter 4, 2021.
//!
//! ## Your task
//!
//! Fill in `lifted` below.
//!
//! - `weights` are the barycentric coordinates α, β, γ of `point`: not negative, together 1. You need not compute them.
//! - `normals` are the unit normals in the corners, in the same order as the corners. They are not that of the triangle.
//! - A point is lifted along the normal of each corner, never sunk.
//! - The answer is right to within a few millionths of the triangle's size, whether that is 0.001 or 1000 scene units.
//!
//! ## When you are done
//!
//! `cargo exercise 2.5` checks your function and renders a coarse ring twice, as it is and mended. A small dark spike stays
//! inside the ring. It belongs to the shadow that one side of the ring casts on the other, which keeps its corners: mended
//! is the terminator, where light fades.

use std::process::ExitCode;

use common::{
    Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};

/// Where a shadow ray starts that leaves `point`, which has these `weights` in the triangle of `corners` with the unit
/// `normals`.
fn lifted(point: Vec3, corners: [Vec3; 3], normals: [Vec3; 3], weights: [f32; 3]) -> Vec3 {
    let _ = (corners, normals, weights); // take this line away when you start
    point
}

// From here on your function is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your function mends.
const PICTURE: Picture = pictures::lifted_point::picture(|settings| pictures::lifted_point::make(settings, lifted));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your function is right.
fn accepted() -> Verdict {
    checks::lifted_point::check(lifted)
}
