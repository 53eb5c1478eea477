//! Directions of which none is likelier than another: uniform over the whole sphere.

use std::f32::consts::{PI, TAU};

use common::{Stream, Vec2, Vec3, float};

use crate::unit_square::{BELOW_ONE, turn};

// ANCHOR: rejection
/// A unit vector, uniform over the sphere: a point in the unit ball, seen from its center.
///
/// Points are drawn in the cube around the ball until one lies inside the ball; that takes 6/π = 1.9 trials on
/// average. Without that rejection directions crowd toward the corners of the cube.
pub fn sample_uniform_sphere_by_rejection(random: &mut Stream) -> Vec3 {
    loop {
        let point = point_in_cube(random);
        let distance_squared = point.length_squared();
        // The center has no direction, and next to it the steps of f32 leave few.
        if (NEAREST * NEAREST..=1.0).contains(&distance_squared) {
            return point / distance_squared.sqrt();
        }
    }
}

/// Points nearer to the center than this are rejected. Which distance is taken changes no direction's chance.
const NEAREST: f32 = 0.01;

/// A point of the cube `[-1, 1)³`, uniform.
pub(crate) fn point_in_cube(random: &mut Stream) -> Vec3 {
    let mut coordinate = || 2.0 * random.uniform() - 1.0;
    let (x, y) = (coordinate(), coordinate());
    Vec3::new(x, y, coordinate())
}
// ANCHOR_END: rejection

/// A point of the unit ball, uniform, its center included.
pub(crate) fn point_in_ball(random: &mut Stream) -> Vec3 {
    loop {
        let point = point_in_cube(random);
        if point.length_squared() <= 1.0 {
            return point;
        }
    }
}

// ANCHOR: closed_form
/// A unit vector, uniform over the sphere, from a point `u` of the unit square.
///
/// The height `z = 1 − 2u` is uniform, because slices of a sphere of equal height have equal area (Archimedes).
/// Source: PBRT 4, section A.5.2, `SampleUniformSphere`.
#[must_use]
pub fn sample_uniform_sphere(u: Vec2) -> Vec3 {
    let z = 1.0 - 2.0 * u.x;
    // √(1 − z²), without the digits that the subtraction loses near the poles.
    let radius = 2.0 * (u.x * (1.0 - u.x)).sqrt();
    let angle = TAU * u.y;
    Vec3::new(radius * float::cos(angle), radius * float::sin(angle), z)
}

/// The density of the uniform distribution over the sphere, 1/(4π) per steradian for every direction.
#[must_use]
pub fn uniform_sphere_pdf() -> f32 {
    1.0 / (4.0 * PI)
}

/// The point of the unit square that becomes this unit vector: undoes [`sample_uniform_sphere`].
#[must_use]
pub fn invert_uniform_sphere_sample(direction: Vec3) -> Vec2 {
    Vec2::new(((1.0 - direction.z) / 2.0).min(BELOW_ONE), turn(float::atan2(direction.y, direction.x)))
}
// ANCHOR_END: closed_form
