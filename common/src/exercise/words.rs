//! How messages put things: what was tried in full, so that a student can type it off, and what came out and what was
//! expected with equally many digits, so that rounding does not look like a mistake.

use glam::{DVec3, Vec3};

use crate::interval::Interval;

/// A point, a vector or a color.
#[must_use]
pub fn triple(v: Vec3) -> String {
    // Adding zero turns −0 into 0.
    let [x, y, z] = (v + 0.0).to_array();
    format!("({x}, {y}, {z})")
}

/// The same of an f64, rounded to what an f32 could tell.
#[must_use]
pub fn rounded(v: DVec3) -> String {
    let [x, y, z] = v.to_array().map(number);
    format!("({x}, {y}, {z})")
}

/// A number with six digits behind the point, without zeros at the end.
#[must_use]
pub fn number(x: f64) -> String {
    let text = format!("{x:.6}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".into() } else { short.into() }
}

/// A range of ray parameters.
#[must_use]
pub fn range(range: Interval) -> String {
    let end = |t: f32| match t {
        f32::INFINITY => "∞".into(),
        f32::NEG_INFINITY => "−∞".into(),
        t => t.to_string(),
    };
    format!("range {} < t < {}", end(range.min), end(range.max))
}
