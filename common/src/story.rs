//! The story of one pixel: what happened on the way to its color.
//!
//! The code that computes a color also tells how. It tells it to a [`Story`]: to [`Untold`], which compiles to
//! nothing, when a picture is rendered, and to [`Told`], which writes it down, for `--pixel X,Y`. Because both are the
//! same code, the story cannot disagree with the picture.

use std::fmt;

/// Somebody to tell what happens to a ray.
pub trait Story {
    /// One line; the closure runs only when somebody listens.
    fn tell(&mut self, line: impl FnOnce() -> String);

    /// A line whose details follow, until [`Story::leave`].
    fn enter(&mut self, line: impl FnOnce() -> String);

    /// The end of the details of the last [`Story::enter`].
    fn leave(&mut self);
}

/// Nobody listens: costs nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Untold;

impl Story for Untold {
    #[inline(always)]
    fn tell(&mut self, _line: impl FnOnce() -> String) {}

    #[inline(always)]
    fn enter(&mut self, _line: impl FnOnce() -> String) {}

    #[inline(always)]
    fn leave(&mut self) {}
}

/// Writes the story down, one line each, details indented by two spaces.
#[derive(Clone, Debug, Default)]
pub struct Told {
    text: String,
    depth: usize,
}

impl Story for Told {
    fn tell(&mut self, line: impl FnOnce() -> String) {
        for part in line().lines() {
            self.text.push_str(&"  ".repeat(self.depth));
            self.text.push_str(part);
            self.text.push('\n');
        }
    }

    fn enter(&mut self, line: impl FnOnce() -> String) {
        self.tell(line);
        self.depth += 1;
    }

    fn leave(&mut self) {
        self.depth = self.depth.saturating_sub(1);
    }
}

impl fmt::Display for Told {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// A vector or color as a story prints it: three numbers with four significant digits.
#[must_use]
pub fn triple(v: glam::Vec3) -> String {
    format!("({}, {}, {})", number(v.x), number(v.y), number(v.z))
}

/// A number as a story prints it: four significant digits, plain where that is short.
#[must_use]
pub fn number(x: f32) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    if !(1e-4..1e6).contains(&x.abs()) {
        return format!("{x:.3e}");
    }
    // Four significant digits: one decimal fewer for each digit before the point.
    let decimals = [(1000.0, 0), (100.0, 1), (10.0, 2), (1.0, 3), (0.1, 4), (0.01, 5), (0.001, 6)]
        .into_iter()
        .find_map(|(at_least, decimals)| (x.abs() >= at_least).then_some(decimals))
        .unwrap_or(7);
    format!("{x:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn details_are_indented() {
        let mut story = Told::default();
        story.tell(|| "one".into());
        story.enter(|| "two".into());
        story.tell(|| "three\nfour".into());
        story.leave();
        story.leave();
        story.tell(|| "five".into());
        assert_eq!(story.to_string(), "one\ntwo\n  three\n  four\nfive\n");
    }

    #[test]
    fn nobody_listening_runs_no_closure() {
        Untold.tell(|| unreachable!());
        Untold.enter(|| unreachable!());
        Untold.leave();
    }

    #[test]
    fn numbers_have_four_digits() {
        let printed = [0.0, 1.0, -2.5, 123.456, 98_765.4, 0.012_345_6, 1e-9, 3e8, f32::INFINITY].map(number);
        assert_eq!(printed, ["0", "1.000", "-2.500", "123.5", "98765", "0.01235", "1.000e-9", "3.000e8", "inf"]);
    }
}
