//! A direction that was chosen by chance, and how likely that was.

use common::Vec3;

// ANCHOR: density
/// How likely a choice was. The two kinds have different units and cannot be compared or added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Density {
    /// One of infinitely many directions: a probability density (pdf) per steradian, 0 or more, which may be above 1.
    SolidAngle(f32),
    /// One of a few directions, as a mirror has only one: a probability, 0 to 1. Written as a density it would be a
    /// Dirac delta, infinite in that direction and 0 in all others, so no number says what it is per steradian.
    Discrete(f32),
}
// ANCHOR_END: density

impl Density {
    // ANCHOR: weight
    /// What the value of a sample is multiplied by: one over the density or the probability.
    ///
    /// It is 0 where that is not above 0. Such a sample contributes nothing and is dropped; adding a small number to
    /// every density instead would make the estimate wrong on average.
    #[must_use]
    pub fn weight(self) -> f32 {
        let (Self::SolidAngle(p) | Self::Discrete(p)) = self;
        if p > 0.0 { 1.0 / p } else { 0.0 }
    }
    // ANCHOR_END: weight

    /// The density per steradian; `None` for a discrete choice, which has none.
    #[must_use]
    pub fn per_steradian(self) -> Option<f32> {
        match self {
            Self::SolidAngle(pdf) => Some(pdf),
            Self::Discrete(_) => None,
        }
    }

    /// The same choice, made only with a `probability` of 0 to 1, as when a roulette chose between several ways first.
    #[must_use]
    pub fn with_probability(self, probability: f32) -> Self {
        match self {
            Self::SolidAngle(pdf) => Self::SolidAngle(pdf * probability),
            Self::Discrete(p) => Self::Discrete(p * probability),
        }
    }
}

// ANCHOR: direction_sample
/// A direction that was chosen by chance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionSample {
    /// The direction, a unit vector in world coordinates.
    pub direction: Vec3,
    /// How likely it was.
    pub density: Density,
}
// ANCHOR_END: direction_sample

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_undo_densities() {
        assert_eq!(Density::SolidAngle(4.0).weight(), 0.25);
        assert_eq!(Density::Discrete(0.5).weight(), 2.0);
        for impossible in [0.0, -1.0, f32::NAN] {
            assert_eq!(Density::SolidAngle(impossible).weight(), 0.0);
        }
    }

    #[test]
    fn a_discrete_choice_has_no_density() {
        assert_eq!(Density::Discrete(1.0).per_steradian(), None);
        assert_eq!(Density::SolidAngle(3.0).per_steradian(), Some(3.0));
        assert_eq!(Density::Discrete(1.0).with_probability(0.25), Density::Discrete(0.25));
        assert_eq!(Density::SolidAngle(2.0).with_probability(0.25), Density::SolidAngle(0.5));
        assert_ne!(Density::Discrete(1.0), Density::SolidAngle(1.0));
    }
}
