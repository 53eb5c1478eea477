//! Directions as a matte surface needs them: the likelier, the nearer they are to the normal.

use std::f32::consts::PI;

use common::{Stream, Vec2, Vec3};

use crate::disc::{
    invert_uniform_disc_concentric_sample, sample_uniform_disc_by_rejection, sample_uniform_disc_concentric,
};

// ANCHOR: lift
/// The point of the unit hemisphere with `z ≥ 0` that lies above a point of the unit disc.
///
/// Points that are uniform over the disc become directions of density cosθ/π, because a piece of the hemisphere has
/// cosθ times its own area below it (Malley's method; PBRT 4, section A.5.3).
#[must_use]
#[inline]
pub fn lift(point: Vec2) -> Vec3 {
    let z = (1.0 - point.length_squared()).max(0.0).sqrt();
    point.extend(z)
}
// ANCHOR_END: lift

// ANCHOR: rejection
/// A unit vector with `z ≥ 0` and density cosθ/π: a point drawn in the unit disc by rejection, lifted up.
pub fn sample_cosine_hemisphere_by_rejection(random: &mut Stream) -> Vec3 {
    lift(sample_uniform_disc_by_rejection(random))
}
// ANCHOR_END: rejection

// ANCHOR: closed_form
/// A unit vector with `z ≥ 0` and density cosθ/π, from a point `u` of the unit square.
///
/// Source: PBRT 4, section A.5.3, `SampleCosineHemisphere`.
#[must_use]
#[inline]
pub fn sample_cosine_hemisphere(u: Vec2) -> Vec3 {
    lift(sample_uniform_disc_concentric(u))
}

/// The density cosθ/π per steradian, and 0 behind the surface. `cos_theta` is the cosine of the angle to the normal.
#[must_use]
#[inline]
pub fn cosine_hemisphere_pdf(cos_theta: f32) -> f32 {
    cos_theta.max(0.0) / PI
}

/// The point of the unit square that becomes this unit vector with `z ≥ 0`: undoes [`sample_cosine_hemisphere`].
#[must_use]
pub fn invert_cosine_hemisphere_sample(direction: Vec3) -> Vec2 {
    invert_uniform_disc_concentric_sample(direction.truncate())
}
// ANCHOR_END: closed_form
