//! How messages put points and numbers.

use common::Vec2;

pub(crate) use common::exercise::words::{number, triple};

/// A point of a plane.
pub(crate) fn pair(v: Vec2) -> String {
    // Adding zero turns −0 into 0.
    let [x, y] = (v + 0.0).to_array();
    format!("({x}, {y})")
}

/// A number in three digits that count, and with a power of ten where it is large or small.
pub(crate) fn about(x: f64) -> String {
    if x == 0.0 || (1e-3..1e4).contains(&x.abs()) { number((x * 1e4).round() / 1e4) } else { format!("{x:.2e}") }
}

/// Whether two numbers differ by no more than that. False for what is no number.
pub(crate) fn is_near(a: f64, b: f64, slack: f64) -> bool {
    (a - b).abs() <= slack
}
