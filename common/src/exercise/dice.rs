//! Random questions, the same in every run, and short enough to be typed off a message.

use glam::Vec3;

use crate::random::Stream;

/// Rolls random numbers, all of them multiples of 1/100.
#[derive(Clone, Debug)]
pub struct Dice(Stream);

impl Dice {
    /// The dice of one check.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(Stream::new(seed, 0, 0))
    }

    /// A number from `min` to `max`.
    pub fn number(&mut self, min: f32, max: f32) -> f32 {
        hundredths(min + (max - min) * self.0.uniform())
    }

    /// A point whose coordinates are at most `half` from zero.
    pub fn point(&mut self, half: f32) -> Vec3 {
        Vec3::from_array([(); 3].map(|()| self.number(-half, half)))
    }

    /// A vector that is not too short for a direction, of no particular length.
    pub fn direction(&mut self) -> Vec3 {
        loop {
            let v = self.point(1.0);
            if v.length_squared() > 0.05 {
                return v;
            }
        }
    }

    /// One of `choices`.
    pub fn choice<T: Copy, const N: usize>(&mut self, choices: [T; N]) -> T {
        #[expect(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "few")]
        let index = (self.0.uniform() * N as f32) as usize;
        choices[index.min(N - 1)]
    }

    /// Whether an event of the given probability happens.
    pub fn happens(&mut self, probability: f32) -> bool {
        self.0.uniform() < probability
    }
}

/// The nearest multiple of 1/100.
fn hundredths(x: f32) -> f32 {
    // Adding zero turns −0 into 0.
    (x * 100.0).round() / 100.0 + 0.0
}

/// The nearest vector of multiples of 1/100.
#[must_use]
pub fn vector_hundredths(v: Vec3) -> Vec3 {
    Vec3::from_array(v.to_array().map(hundredths))
}
