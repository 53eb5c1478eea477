//! The quadratic equation `a·t² + 2h·t + c = 0`, solved so that it stays right in floating point.

use common::Interval;

/// The two roots in ascending order. A root that does not exist is NaN or infinite, and so lies in no interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roots(pub [f32; 2]);

impl Roots {
    /// No root at all.
    pub const NONE: Roots = Roots([f32::NAN; 2]);

    /// Two roots in any order.
    #[must_use]
    pub fn ascending(t1: f32, t2: f32) -> Self {
        // `min` and `max` return the other number when one is NaN.
        Self([t1.min(t2), t1.max(t2)])
    }

    /// The interval between two finite roots; `None` if they do not exist.
    #[must_use]
    pub fn span(self) -> Option<Interval> {
        let [first, second] = self.0;
        (first.is_finite() && second.is_finite()).then_some(Interval::new(first, second))
    }

    /// The least root inside the open interval.
    #[must_use]
    pub fn first_in(self, range: Interval) -> Option<f32> {
        self.0.into_iter().find(|t| range.contains(*t))
    }
}

// ANCHOR: textbook
/// The formula as it stands in every textbook, with `b = 2h`. It loses digits when `b²` is much greater than `4ac`.
#[must_use]
pub fn solve_textbook(a: f32, b: f32, c: f32) -> Roots {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return Roots::NONE;
    }
    let root = discriminant.sqrt();
    Roots::ascending((-b - root) / (2.0 * a), (-b + root) / (2.0 * a))
}
// ANCHOR_END: textbook

// ANCHOR: stable
/// The same roots without subtracting numbers that are nearly equal. `h` is half of the textbook's `b`, which removes
/// every factor 2: the `discriminant` is `h² − a·c`.
///
/// `a = 0` is a linear equation: its one root is there, and the other is infinite or not a number.
#[must_use]
pub fn solve(a: f32, h: f32, c: f32, discriminant: f32) -> Roots {
    if discriminant < 0.0 {
        return Roots::NONE;
    }
    // −h and the root of the same sign: the sum cannot cancel.
    let q = -(h + discriminant.sqrt().copysign(h));
    // The product of both roots is c/a, so the second follows from the first.
    Roots::ascending(c / q, q / a)
}
// ANCHOR_END: stable

#[cfg(test)]
mod tests {
    use super::*;

    fn solved(a: f32, h: f32, c: f32) -> Roots {
        solve(a, h, c, h * h - a * c)
    }

    #[test]
    fn simple_equations_both_ways() {
        // (t − 1)(t − 3) = t² − 4t + 3, and the same upside down.
        for sign in [1.0, -1.0] {
            assert_eq!(solved(sign, -2.0 * sign, 3.0 * sign), Roots([1.0, 3.0]));
            assert_eq!(solve_textbook(sign, -4.0 * sign, 3.0 * sign), Roots([1.0, 3.0]));
        }
        // t² + 1 has no root, t² − 4 has two of opposite sign.
        assert_eq!(solved(1.0, 0.0, 1.0).first_in(Interval::POSITIVE), None);
        assert_eq!(solved(1.0, 0.0, -4.0), Roots([-2.0, 2.0]));
    }

    #[test]
    fn linear_and_constant_equations() {
        // 4t − 2 = 0, so h = 2.
        assert_eq!(solved(0.0, 2.0, -2.0).first_in(Interval::POSITIVE), Some(0.5));
        assert_eq!(solved(0.0, -2.0, 2.0).first_in(Interval::POSITIVE), Some(0.5));
        // 3 = 0 is never true, 0 = 0 is no surface.
        assert_eq!(solved(0.0, 0.0, 3.0).first_in(Interval::POSITIVE), None);
        assert_eq!(solved(0.0, 0.0, 0.0).first_in(Interval::POSITIVE), None);
    }

    #[test]
    fn the_first_root_inside_the_range() {
        let roots = solved(1.0, -2.0, 3.0);
        for (min, max, expected) in [(0.0, 9.0, Some(1.0)), (1.0, 9.0, Some(3.0)), (0.0, 1.0, None), (3.0, 9.0, None)] {
            assert_eq!(roots.first_in(Interval::new(min, max)), expected);
        }
    }

    /// t² − 2·10⁴·t + 1: the small root is 5.0000000125e-5. The textbook loses it entirely.
    #[test]
    fn the_small_root_survives() {
        // The nearest f32; what is missing is a fiftieth of its last digit.
        let exact = 5e-5;
        let [small, _] = solved(1.0, -1e4, 1.0).0;
        assert!((small - exact).abs() <= f32::EPSILON * exact, "{small}");
        let [lost, _] = solve_textbook(1.0, -2e4, 1.0).0;
        assert!((lost - exact).abs() > 0.9 * exact, "{lost}");
    }
}
