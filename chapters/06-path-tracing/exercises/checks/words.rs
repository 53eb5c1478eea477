//! How messages put points and numbers.

pub(crate) use common::exercise::words::{number, triple};

/// A number in four digits behind the point, and with a power of ten where it is large or small.
pub(crate) fn about(x: f64) -> String {
    if x == 0.0 || (1e-3..1e4).contains(&x.abs()) { number((x * 1e4).round() / 1e4) } else { format!("{x:.2e}") }
}

/// Whether two numbers differ by no more than that. False for what is no number.
pub(crate) fn is_near(a: f64, b: f64, slack: f64) -> bool {
    (a - b).abs() <= slack
}
