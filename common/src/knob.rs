//! The numbers of a picture that a student can turn.

use crate::error::Error;

/// One adjustable number of a picture, with its range, default and unit.
///
/// All values are kept as `f32`: a switch is 0 or 1, a choice is the index of its option.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Knob {
    /// Name on the command line: `--set name=value`.
    pub name: &'static str,
    /// What it does, as one phrase.
    pub what: &'static str,
    /// What values it takes.
    pub kind: Kind,
}

/// What values a [`Knob`] takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A number from `min` to `max`, both included.
    Number {
        /// Least value.
        min: f32,
        /// Greatest value.
        max: f32,
        /// Value when nothing is said.
        default: f32,
        /// Unit, empty for a pure number.
        unit: &'static str,
        /// How far one press of a key goes.
        step: Step,
    },
    /// One of several words.
    Choice {
        /// The words.
        options: &'static [&'static str],
        /// Index of the word when nothing is said.
        default: usize,
    },
    /// Off or on.
    Switch {
        /// State when nothing is said.
        default: bool,
    },
}

/// How far one press of a key moves a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// Add or subtract this much.
    Add(f32),
    /// Multiply or divide by this.
    Times(f32),
    /// Whole numbers only, one at a time.
    Whole,
}

impl Knob {
    /// A number between `min` and `max`.
    #[must_use]
    pub const fn number(
        name: &'static str,
        what: &'static str,
        [min, max]: [f32; 2],
        default: f32,
        unit: &'static str,
        step: Step,
    ) -> Self {
        Self { name, what, kind: Kind::Number { min, max, default, unit, step } }
    }

    /// One word of several; `default` is an index.
    #[must_use]
    pub const fn choice(
        name: &'static str,
        what: &'static str,
        options: &'static [&'static str],
        default: usize,
    ) -> Self {
        Self { name, what, kind: Kind::Choice { options, default } }
    }

    /// Off or on.
    #[must_use]
    pub const fn switch(name: &'static str, what: &'static str, default: bool) -> Self {
        Self { name, what, kind: Kind::Switch { default } }
    }

    /// The value when nothing is said.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "a choice has few options")]
    pub const fn default(&self) -> f32 {
        match self.kind {
            Kind::Number { default, .. } => default,
            Kind::Choice { default, .. } => default as f32,
            Kind::Switch { default } => default as u8 as f32,
        }
    }

    /// Read a value that a user typed.
    ///
    /// # Errors
    /// [`Error::KnobValue`] says which values the knob takes.
    pub fn parse(&self, text: &str) -> Result<f32, Error> {
        let range = || match self.kind {
            Kind::Number { step, .. } if step != Step::Whole => format!("a number {}", self.range()),
            _ => self.range(),
        };
        let wrong = || Error::KnobValue { knob: self.name, given: text.into(), range: range() };
        match self.kind {
            Kind::Number { min, max, step, .. } => {
                let value: f32 = text.trim().parse().map_err(|_| wrong())?;
                let whole = step != Step::Whole || value.fract() == 0.0;
                // A NaN is in no range.
                if (min..=max).contains(&value) && whole { Ok(value) } else { Err(wrong()) }
            }
            Kind::Choice { options, .. } =>
            {
                #[expect(clippy::cast_precision_loss, reason = "a choice has few options")]
                options.iter().position(|o| *o == text.trim()).map(|i| i as f32).ok_or_else(wrong)
            }
            Kind::Switch { .. } => match text.trim() {
                "on" | "true" | "1" | "yes" => Ok(1.0),
                "off" | "false" | "0" | "no" => Ok(0.0),
                _ => Err(wrong()),
            },
        }
    }

    /// The values that the knob takes, in words.
    #[must_use]
    pub fn range(&self) -> String {
        match self.kind {
            Kind::Number { min, max, unit, step, .. } => {
                let whole = if step == Step::Whole { "a whole number " } else { "" };
                format!("{whole}from {min} to {max}{}", unit_suffix(unit))
            }
            Kind::Choice { options, .. } => format!("one of {}", options.join(", ")),
            Kind::Switch { .. } => "on or off".into(),
        }
    }

    /// A value in words, with its unit.
    #[must_use]
    pub fn show(&self, value: f32) -> String {
        match self.kind {
            Kind::Number { unit, .. } => format!("{value}{}", unit_suffix(unit)),
            Kind::Choice { options, .. } => options.get(index(value)).copied().unwrap_or("?").into(),
            Kind::Switch { .. } => if value == 0.0 { "off" } else { "on" }.into(),
        }
    }

    /// The next value in direction `up` or down; a number stops at its ends, a choice and a switch go round.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "a choice has few options")]
    pub fn turned(&self, value: f32, up: bool) -> f32 {
        match self.kind {
            Kind::Number { min, max, step, .. } => {
                let next = match (step, up) {
                    (Step::Add(s), true) => round_to(value + s, s),
                    (Step::Add(s), false) => round_to(value - s, s),
                    (Step::Times(s), true) => four_digits(value * s),
                    (Step::Times(s), false) => four_digits(value / s),
                    (Step::Whole, true) => value + 1.0,
                    (Step::Whole, false) => value - 1.0,
                };
                next.clamp(min, max)
            }
            Kind::Choice { options, .. } => {
                let n = options.len().max(1);
                ((index(value) + if up { 1 } else { n - 1 }) % n) as f32
            }
            Kind::Switch { .. } => 1.0 - value,
        }
    }
}

/// A unit as it follows a number: ° without a space, others with one.
fn unit_suffix(unit: &str) -> String {
    if unit.is_empty() || unit == "°" { unit.into() } else { format!(" {unit}") }
}

/// The nearest multiple of `step`, so that many presses of a key add up to round numbers.
fn round_to(value: f32, step: f32) -> f32 {
    let rounded = (value / step).round() * step;
    (rounded * 1e4).round() / 1e4
}

/// The nearest number with four significant digits.
fn four_digits(value: f32) -> f32 {
    // A number that was just written can be read again.
    format!("{value:.3e}").parse().unwrap_or(value)
}

/// The index that a choice keeps as a number.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates, and options are few")]
fn index(value: f32) -> usize {
    value as usize
}

/// The values of a picture's knobs: what was set, and the default for the rest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values(Vec<(&'static str, f32)>);

impl Values {
    /// Remember a value.
    pub fn set(&mut self, knob: &Knob, value: f32) {
        match self.0.iter_mut().find(|(name, _)| *name == knob.name) {
            Some(entry) => entry.1 = value,
            None => self.0.push((knob.name, value)),
        }
    }

    /// The value of a knob.
    #[must_use]
    pub fn number(&self, knob: &Knob) -> f32 {
        self.0.iter().find(|(name, _)| *name == knob.name).map_or(knob.default(), |(_, value)| *value)
    }

    /// The value of a whole-number knob or the index of a choice.
    #[must_use]
    pub fn index(&self, knob: &Knob) -> usize {
        index(self.number(knob))
    }

    /// Whether a switch is on.
    #[must_use]
    pub fn is_on(&self, knob: &Knob) -> bool {
        self.number(knob) != 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ANGLE: Knob = Knob::number("angle", "how far", [-90.0, 90.0], 30.0, "°", Step::Add(0.1));
    const COUNT: Knob = Knob::number("count", "how many", [1.0, 8.0], 3.0, "", Step::Whole);
    const ROOT: Knob = Knob::choice("root", "which formula", &["stable", "naive"], 0);
    const BUG: Knob = Knob::switch("bug", "whether it is wrong", false);

    #[test]
    fn parse_accepts_the_range_and_nothing_else() {
        assert_eq!(ANGLE.parse("-90"), Ok(-90.0));
        assert_eq!(COUNT.parse("8"), Ok(8.0));
        assert_eq!(ROOT.parse("naive"), Ok(1.0));
        assert_eq!(BUG.parse("on"), Ok(1.0));
        for (knob, bad) in [
            (ANGLE, "90.5"),
            (ANGLE, "NaN"),
            (ANGLE, "inf"),
            (ANGLE, ""),
            (ANGLE, "3°x"),
            (COUNT, "2.5"),
            (COUNT, "0"),
            (ROOT, "1"),
            (BUG, "maybe"),
        ] {
            let error = knob.parse(bad).unwrap_err().to_string();
            assert!(error.contains(knob.name) && error.contains(&knob.range()), "{error}");
        }
    }

    #[test]
    fn keys_move_within_the_range() {
        let mut value = ANGLE.default();
        for _ in 0..7 {
            value = ANGLE.turned(value, true);
        }
        assert_eq!(ANGLE.show(value), "30.7°");
        assert_eq!(ANGLE.turned(90.0, true), 90.0);
        assert_eq!(ROOT.turned(1.0, true), 0.0);
        assert_eq!(ROOT.turned(0.0, false), 1.0);
        assert_eq!(BUG.turned(0.0, false), 1.0);
        assert_eq!(COUNT.turned(1.0, false), 1.0);
        let zoom = Knob::number("zoom", "how near", [0.1, 10.0], 1.0, "", Step::Times(1.1));
        assert_eq!(zoom.show(zoom.turned(zoom.turned(1.0, true), true)), "1.21");
    }

    #[test]
    fn values_fall_back_to_defaults() {
        let mut values = Values::default();
        assert_eq!(values.number(&ANGLE), 30.0);
        values.set(&ANGLE, 1.0);
        values.set(&ANGLE, 2.0);
        values.set(&ROOT, 1.0);
        assert_eq!((values.number(&ANGLE), values.index(&ROOT), values.is_on(&BUG)), (2.0, 1, false));
    }
}
