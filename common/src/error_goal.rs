//! The error that is small enough: when a rendering with `--until-error` ends.

use std::{fmt, str::FromStr};

use crate::film::Film;

/// A relative error that a picture is to reach, in percent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorGoal(f64);

impl ErrorGoal {
    /// A film with fewer samples per pixel knows its own error too badly to be believed.
    pub const BELIEVED: u32 = 16;

    /// Whether a film whose pixels have `samples` samples each has reached it.
    #[must_use]
    pub fn is_reached(self, film: &Film, samples: u32) -> bool {
        samples >= Self::BELIEVED && film.relative_error().is_some_and(|error| error <= self.share())
    }

    /// How many samples per pixel it will probably take, when there is so much error with so many: the error falls
    /// with the square root of their number.
    #[must_use]
    pub fn forecast(self, error: f64, samples: u32) -> f64 {
        let ratio = error / self.share();
        f64::from(samples) * ratio * ratio
    }

    fn share(self) -> f64 {
        self.0 / 100.0
    }
}

impl FromStr for ErrorGoal {
    type Err = String;

    /// Reads `1%`, `0.5 %` or `1`, which are all in percent.
    fn from_str(text: &str) -> Result<Self, String> {
        let number = text.trim().trim_end_matches('%').trim_end();
        let is_once = text.matches('%').count() <= 1;
        let percent = number.parse().ok().filter(|percent| is_once && *percent > 0.0 && *percent <= 100.0);
        percent.map(Self).ok_or_else(|| "expected a percentage greater than 0 and at most 100, like 1%".into())
    }
}

impl fmt::Display for ErrorGoal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} %", self.0)
    }
}

/// An error in percent, with three digits that count.
#[must_use]
pub fn percent(error: f64) -> String {
    let percent = 100.0 * error;
    // A number that was just written can be read again.
    format!("{} %", format!("{percent:.2e}").parse().unwrap_or(percent))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{color::Rgb, film::Size};

    #[test]
    fn percentages_are_read() {
        for (text, share) in
            [("1%", 0.01), ("1", 0.01), ("0.5%", 0.005), (" 2.5 % ", 0.025), ("100%", 1.0), ("1e-3", 1e-5)]
        {
            assert_eq!(text.parse().map(ErrorGoal::share), Ok(share), "{text}");
        }
        for text in ["", "%", "0", "0%", "-1", "101", "NaN", "inf", "1%%", "%1", "one", "1‰", "1 5", "1e-400"] {
            assert!(text.parse::<ErrorGoal>().unwrap_err().contains("like 1%"), "{text}");
        }
        assert_eq!("0.50%".parse::<ErrorGoal>().unwrap().to_string(), "0.5 %");
    }

    #[test]
    fn errors_are_shown_with_three_digits() {
        let shown = [0.012_345, 1.0, 2e-6, 0.5, 12.345].map(percent);
        assert_eq!(shown, ["1.23 %", "100 %", "0.0002 %", "50 %", "1230 %"]);
    }

    #[test]
    fn it_is_reached_by_enough_samples_only() {
        let mut film = Film::new(Size::of::<1, 1>());
        let goal: ErrorGoal = "25".parse().unwrap();
        for i in 1..=17 {
            assert_eq!(goal.is_reached(&film, i - 1), i == 17);
            film.tiles_mut()[0].pixels[0].add(Rgb::splat(if i % 2 == 0 { 0.5 } else { 1.5 }));
        }
        // Standard deviation about ½ of the mean 1, so the error of the mean of 17 is about ⅛.
        let error = film.relative_error().unwrap();
        assert!((0.12..0.13).contains(&error));
        assert!((goal.forecast(0.5, 10) - 40.0).abs() < 1e-9);
        // A black film does not know its error.
        assert!(!goal.is_reached(&Film::new(Size::of::<1, 1>()), 100));
    }
}
