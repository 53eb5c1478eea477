//! Points of the unit disc of which none is likelier than another.

use std::f32::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use common::{Stream, Vec2, float};

use crate::unit_square::{BELOW_ONE, turn};

// ANCHOR: rejection
/// A point of the unit disc, uniform: points are drawn in the square around it until one lies inside.
///
/// That takes 4/π = 1.3 trials on average.
pub fn sample_uniform_disc_by_rejection(random: &mut Stream) -> Vec2 {
    loop {
        let x = 2.0 * random.uniform() - 1.0;
        let point = Vec2::new(x, 2.0 * random.uniform() - 1.0);
        if point.length_squared() <= 1.0 {
            return point;
        }
    }
}
// ANCHOR_END: rejection

/// The density of the uniform distribution over the unit disc: 1/π per unit of area.
#[must_use]
pub fn uniform_disc_pdf() -> f32 {
    1.0 / PI
}

// ANCHOR: polar
/// A point of the unit disc, uniform, from a point `u` of the unit square: `u.x` becomes the distance from the
/// center, `u.y` the angle.
///
/// The share of the disc within radius r is r², so the radius is the root of a uniform number; without the root
/// points crowd at the center. Source: PBRT 4, section A.5.1, `SampleUniformDiskPolar`.
#[must_use]
pub fn sample_uniform_disc_polar(u: Vec2) -> Vec2 {
    let angle = TAU * u.y;
    let (sin, cos) = float::sin_cos(angle);
    Vec2::new(cos, sin) * u.x.sqrt()
}

/// The point of the unit square that becomes this point of the disc: undoes [`sample_uniform_disc_polar`].
#[must_use]
pub fn invert_uniform_disc_polar_sample(point: Vec2) -> Vec2 {
    Vec2::new(point.length_squared().min(BELOW_ONE), turn(float::atan2(point.y, point.x)))
}
// ANCHOR_END: polar

// ANCHOR: concentric
/// A point of the unit disc, uniform, from a point `u` of the unit square: squares around the center become circles.
///
/// Neighbors stay neighbors, which the polar form tears apart along the angle 0.
/// Source: Shirley, Chiu, *A Low Distortion Map Between Disk and Square*, Journal of Graphics Tools 2(3), 1997;
/// PBRT 4, section A.5.1, `SampleUniformDiskConcentric`.
#[must_use]
#[inline]
pub fn sample_uniform_disc_concentric(u: Vec2) -> Vec2 {
    let Vec2 { x, y } = u * 2.0 - 1.0;
    // The center stays where it is.
    if x == 0.0 && y == 0.0 {
        return Vec2::ZERO;
    }
    // The larger coordinate is the radius, with a sign; the ratio of both is the angle, within an eighth of a turn.
    let (radius, angle) =
        if x.abs() > y.abs() { (x, FRAC_PI_4 * (y / x)) } else { (y, FRAC_PI_2 - FRAC_PI_4 * (x / y)) };
    let (sin, cos) = float::sin_cos(angle);
    Vec2::new(cos, sin) * radius
}

/// The point of the unit square that becomes this point of the disc: undoes [`sample_uniform_disc_concentric`].
#[must_use]
pub fn invert_uniform_disc_concentric_sample(point: Vec2) -> Vec2 {
    let Vec2 { x, y } = point;
    // The angle from the nearest half axis, at most an eighth of a turn, says how far along the side of the square.
    let along = |part: f32, whole: f32| float::atan2(part, whole.abs()) / FRAC_PI_4 * point.length();
    let square = if x.abs() > y.abs() {
        Vec2::new(point.length().copysign(x), along(y, x))
    } else {
        Vec2::new(along(x, y), point.length().copysign(y))
    };
    ((square + 1.0) / 2.0).clamp(Vec2::ZERO, Vec2::splat(BELOW_ONE))
}
// ANCHOR_END: concentric
