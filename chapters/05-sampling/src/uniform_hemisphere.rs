//! Directions on one side of a surface of which none is likelier than another.

use std::f32::consts::TAU;

use common::{Stream, Vec2, Vec3, float};

use crate::{
    uniform_sphere::sample_uniform_sphere_by_rejection,
    unit_square::{BELOW_ONE, turn},
};

// ANCHOR: rejection
/// A unit vector, uniform over the hemisphere around the unit vector `normal`: one of the whole sphere, turned round
/// if it points to the other side.
pub fn sample_uniform_hemisphere_by_rejection(normal: Vec3, random: &mut Stream) -> Vec3 {
    let direction = sample_uniform_sphere_by_rejection(random);
    if direction.dot(normal) < 0.0 { -direction } else { direction }
}
// ANCHOR_END: rejection

// ANCHOR: closed_form
/// A unit vector with `z > 0`, uniform over the hemisphere, from a point `u` of the unit square.
///
/// Source: PBRT 4, section A.5.2, `SampleUniformHemisphere`.
#[must_use]
pub fn sample_uniform_hemisphere(u: Vec2) -> Vec3 {
    // The height falls from 1 at the pole and never reaches 0, the horizon.
    let z = 1.0 - u.x;
    // √(1 − z²)
    let radius = (u.x * (1.0 + z)).sqrt();
    let angle = TAU * u.y;
    Vec3::new(radius * float::cos(angle), radius * float::sin(angle), z)
}

/// The density of the uniform distribution over the hemisphere: 1/(2π) per steradian, and 0 behind the surface.
/// `cos_theta` is the cosine of the angle to the normal.
#[must_use]
pub fn uniform_hemisphere_pdf(cos_theta: f32) -> f32 {
    if cos_theta > 0.0 { 1.0 / TAU } else { 0.0 }
}

/// The point of the unit square that becomes this unit vector with `z > 0`: undoes [`sample_uniform_hemisphere`].
#[must_use]
pub fn invert_uniform_hemisphere_sample(direction: Vec3) -> Vec2 {
    Vec2::new((1.0 - direction.z).min(BELOW_ONE), turn(float::atan2(direction.y, direction.x)))
}
// ANCHOR_END: closed_form
