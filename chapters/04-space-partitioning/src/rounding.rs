//! Rounding: how much room a walk must leave, so that it never misses what the loop over all objects would hit.

// ANCHOR: slack
/// How far beside its place a ray may see a thing, as a share of the thing's distance.
///
/// The test of a triangle sees each corner moved: a difference, a product and another difference are rounded, each by
/// half an ε of the corner's distance from where the ray starts. The `t` of a plane, `(plane − origin) / direction`, has
/// errors of the same kind. 16 ε is a few times the sum of all.
///
/// It does not cover slivers: in a triangle a thousand times as long as wide, the weights of the corners are rounded so
/// much that a hit may move along it by more. One ray of a hundred million shows it.
///
/// Where products of coordinates come near the smallest numbers of `f32`, digits are lost, and no share is large enough:
/// coordinates should be zero, or greater than about 10⁻¹⁸.
pub const SLACK: f32 = 16.0 * f32::EPSILON;
// ANCHOR_END: slack

/// A little before `t`, as a share of it.
#[inline]
#[must_use]
pub fn before(t: f32) -> f32 {
    // A product, so that infinity stays what it is.
    t * (1.0 - SLACK.copysign(t))
}

/// A little after `t`, as a share of it.
#[inline]
#[must_use]
pub fn after(t: f32) -> f32 {
    t * (1.0 + SLACK.copysign(t))
}

// ANCHOR: lesser
/// The lesser of two numbers; `b` where `a` is no number.
#[inline]
#[must_use]
pub fn lesser(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The greater of two numbers; `b` where `a` is no number.
#[inline]
#[must_use]
pub fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
// ANCHOR_END: lesser

/// The `f32` at or just below a number.
#[inline]
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "that is what it is for")]
pub fn down(x: f64) -> f32 {
    let near = x as f32;
    if f64::from(near) > x { near.next_down() } else { near }
}

/// The `f32` at or just above a number.
#[inline]
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "that is what it is for")]
pub fn up(x: f64) -> f32 {
    let near = x as f32;
    if f64::from(near) < x { near.next_up() } else { near }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_goes_in_one_direction() {
        for x in [0.1_f64, -0.1, 1.0, 1e-60, -1e-60, 1.0 + 1e-12] {
            assert!(f64::from(down(x)) <= x && x <= f64::from(up(x)));
        }
        assert_eq!((down(0.5), up(0.5)), (0.5, 0.5));
        for t in [f32::INFINITY, f32::NEG_INFINITY] {
            assert_eq!((before(t), after(t)), (t, t));
        }
        assert!(before(-1.0) < -1.0 && before(1.0) < 1.0 && after(-1.0) > -1.0 && after(1.0) > 1.0);
    }

    #[test]
    fn what_is_no_number_does_not_count() {
        assert_eq!((lesser(f32::NAN, 1.0), greater(f32::NAN, 1.0)), (1.0, 1.0));
        assert_eq!((lesser(0.0, 1.0), greater(0.0, 1.0)), (0.0, 1.0));
    }
}
