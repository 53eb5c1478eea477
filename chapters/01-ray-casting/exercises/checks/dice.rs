//! Random questions, the same in every run, and short enough to be typed off a message.

use common::{Stream, Vec3};
use ray_casting::ray::Ray;

/// Rolls random numbers, all of them multiples of 1/100.
pub(crate) struct Dice(Stream);

impl Dice {
    /// The dice of one check.
    pub(crate) fn new(seed: u64) -> Self {
        Self(Stream::new(seed, 0, 0))
    }

    /// A number from `min` to `max`.
    pub(crate) fn number(&mut self, min: f32, max: f32) -> f32 {
        hundredths(min + (max - min) * self.0.uniform())
    }

    /// A point whose coordinates are at most `half` from zero.
    pub(crate) fn point(&mut self, half: f32) -> Vec3 {
        Vec3::from_array([(); 3].map(|()| self.number(-half, half)))
    }

    /// A vector that is not too short for a direction, of no particular length.
    pub(crate) fn direction(&mut self) -> Vec3 {
        loop {
            let v = self.point(1.0);
            if v.length_squared() > 0.05 {
                return v;
            }
        }
    }

    /// One of `choices`.
    pub(crate) fn choice<T: Copy, const N: usize>(&mut self, choices: [T; N]) -> T {
        #[expect(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "few")]
        let index = (self.0.uniform() * N as f32) as usize;
        choices[index.min(N - 1)]
    }

    /// A ray from within `far` of the origin: half of them in any direction, half of them toward a point within `near`
    /// of `target`. Its direction is short, of about unit length, or long.
    pub(crate) fn ray(&mut self, far: f32, target: Vec3, near: f32) -> Ray {
        loop {
            let origin = self.point(far);
            let aimed = target + self.point(near) - origin;
            let direction = if self.0.uniform() < 0.5 { self.direction() } else { aimed.normalize_or_zero() };
            let direction = vector_hundredths(direction * self.choice([0.3, 1.0, 4.0]));
            if direction != Vec3::ZERO {
                return Ray::new(origin, direction);
            }
        }
    }
}

/// The nearest multiple of 1/100.
fn hundredths(x: f32) -> f32 {
    // Adding zero turns −0 into 0.
    (x * 100.0).round() / 100.0 + 0.0
}

fn vector_hundredths(v: Vec3) -> Vec3 {
    Vec3::from_array(v.to_array().map(hundredths))
}
