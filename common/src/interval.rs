//! A range of the ray parameter `t`.

// ANCHOR: interval
/// The open interval `min < t < max` of ray parameters that count.
///
/// `t` is measured in lengths of the ray's direction, so in scene units when the direction has unit length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Values at or below this one do not count.
    pub min: f32,
    /// Values at or above this one do not count.
    pub max: f32,
}
// ANCHOR_END: interval

impl Interval {
    /// All that lies in front of the origin: `0 < t < ∞`.
    pub const POSITIVE: Interval = Interval { min: 0.0, max: f32::INFINITY };

    /// The open interval `min < t < max`.
    #[must_use]
    pub const fn new(min: f32, max: f32) -> Self {
        Self { min, max }
    }

    /// Whether `t` lies strictly between the ends; false for NaN.
    #[must_use]
    pub fn contains(self, t: f32) -> bool {
        self.min < t && t < self.max
    }

    /// The same interval ending at `max` already.
    #[must_use]
    pub fn up_to(self, max: f32) -> Self {
        Self { min: self.min, max: self.max.min(max) }
    }

    /// The part that belongs to both intervals (empty when `min >= max`).
    #[must_use]
    pub fn intersection(self, other: Self) -> Self {
        Self { min: self.min.max(other.min), max: self.max.min(other.max) }
    }

    /// Whether no number lies inside.
    #[must_use]
    pub fn is_empty(self) -> bool {
        // Written so that a NaN end makes the interval empty.
        !matches!(self.min.partial_cmp(&self.max), Some(std::cmp::Ordering::Less))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_are_outside_and_nan_is_nowhere() {
        let interval = Interval::new(1.0, 2.0);
        assert!(interval.contains(1.5));
        for outside in [1.0, 2.0, 0.0, 3.0, f32::NAN, f32::INFINITY] {
            assert!(!interval.contains(outside), "{outside}");
        }
        assert!(!Interval::POSITIVE.contains(0.0));
        assert!(Interval::POSITIVE.contains(f32::MIN_POSITIVE));
    }

    #[test]
    fn cutting_makes_it_shorter() {
        let interval = Interval::POSITIVE.up_to(5.0);
        assert_eq!(interval, Interval::new(0.0, 5.0));
        assert_eq!(interval.up_to(9.0), interval);
        assert!(interval.intersection(Interval::new(6.0, 7.0)).is_empty());
        assert!(Interval::new(f32::NAN, 1.0).is_empty());
        assert!(!interval.is_empty());
    }
}
