//! Random rays, in numbers that are short enough to be typed off a message.

use common::{
    Vec3,
    exercise::dice::{Dice, vector_hundredths},
};
use ray_casting::ray::Ray;

/// A ray from within `far` of the origin: half of them in any direction, half of them toward a point within `near`
/// of `target`. Its direction is short, of about unit length, or long.
pub(crate) fn ray(dice: &mut Dice, far: f32, target: Vec3, near: f32) -> Ray {
    loop {
        let origin = dice.point(far);
        let aimed = target + dice.point(near) - origin;
        let direction = if dice.happens(0.5) { dice.direction() } else { aimed.normalize_or_zero() };
        let direction = vector_hundredths(direction * dice.choice([0.3, 1.0, 4.0]));
        if direction != Vec3::ZERO {
            return Ray::new(origin, direction);
        }
    }
}
