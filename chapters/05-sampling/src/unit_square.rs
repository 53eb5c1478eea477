//! The unit square: where the random numbers come from that become a direction.

use common::{Stream, Vec2};

// ANCHOR: unit_square
/// A point of the square `[0, 1)²`, uniform: two numbers of the stream.
#[inline]
pub fn sample_unit_square(random: &mut Stream) -> Vec2 {
    let x = random.uniform();
    Vec2::new(x, random.uniform())
}
// ANCHOR_END: unit_square

/// The greatest f32 below 1.
pub(crate) const BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;

/// A full turn as a number of `[0, 1)`, from an angle in radians in `[-π, π]`.
pub(crate) fn turn(angle: f32) -> f32 {
    let turn = angle / std::f32::consts::TAU;
    if turn < 0.0 { (turn + 1.0).min(BELOW_ONE) } else { turn }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_is_less_than_one() {
        use std::f32::consts::{FRAC_PI_2, PI};
        assert_eq!([0.0, FRAC_PI_2, PI, -PI, -FRAC_PI_2].map(turn), [0.0, 0.25, 0.5, 0.5, 0.75]);
        assert_eq!(turn(-1e-9), BELOW_ONE);
        assert!(BELOW_ONE < 1.0 && BELOW_ONE.next_up() == 1.0);
    }
}
