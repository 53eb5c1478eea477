//! What the exercises of all chapters share: a check ends in a diagnosis, and a diagnosis is said in a friendly way.
//!
//! An exercise is a stub, a check and a solution with the same signatures. The check is told what the student has
//! written, tries it, and either accepts it or names the likely mistake.

use std::fmt;

#[cfg(feature = "cli")]
mod run;

#[cfg(feature = "cli")]
pub use run::main;

/// The likely mistake in a student's answer.
///
/// Printed by [`fmt::Debug`] as well as by [`fmt::Display`] as plain text, so that a failing `cargo test` shows the
/// message and not a data structure.
#[derive(Clone, PartialEq, Eq)]
pub struct Diagnosis {
    /// Name of the mistake, which tests refer to.
    pub name: &'static str,
    /// What was tried, what came out, what was expected, and where to look.
    pub message: String,
}

impl Diagnosis {
    /// Name of the diagnosis for a stub that nobody has touched.
    pub const NOT_STARTED: &'static str = "not-started";

    /// A named mistake with its message.
    #[must_use]
    pub fn new(name: &'static str, message: impl Into<String>) -> Self {
        Self { name, message: message.into() }
    }

    /// The stub as it was delivered; `what` says what is still missing.
    #[must_use]
    pub fn not_started(what: impl Into<String>) -> Self {
        Self::new(Self::NOT_STARTED, what)
    }
}

impl fmt::Display for Diagnosis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} [{}]", self.message, self.name)
    }
}

impl fmt::Debug for Diagnosis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// Accepted, or the likely mistake.
pub type Verdict = Result<(), Diagnosis>;

/// Go on if `right`, otherwise end the check with this diagnosis.
///
/// # Errors
/// The diagnosis, with the message that `message` makes.
pub fn expect(right: bool, name: &'static str, message: impl FnOnce() -> String) -> Verdict {
    if right { Ok(()) } else { Err(Diagnosis::new(name, message())) }
}

/// What a check has found out, in the four parts that every message has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// What was tried.
    pub tried: String,
    /// What came out.
    pub got: String,
    /// What was expected instead.
    pub expected: String,
    /// The likely mistake, and where to look for it.
    pub advice: String,
}

impl Finding {
    /// The diagnosis of that name with this message.
    #[must_use]
    pub fn named(self, name: &'static str) -> Diagnosis {
        Diagnosis::new(name, self.to_string())
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { tried, got, expected, advice } = self;
        write!(f, "Tried:    {tried}\nGot:      {got}\nExpected: {expected}\n\n{advice}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_diagnosis_is_plain_text_also_for_debug() {
        let finding = Finding {
            tried: "a ray".into(),
            got: "no hit".into(),
            expected: "a hit".into(),
            advice: "Look at the sign.".into(),
        };
        let diagnosis = finding.named("sign");
        let text = "Tried:    a ray\nGot:      no hit\nExpected: a hit\n\nLook at the sign. [sign]";
        assert_eq!(format!("{diagnosis}"), text);
        assert_eq!(format!("{diagnosis:?}"), text);
    }

    #[test]
    fn the_message_is_made_only_when_it_is_needed() {
        assert_eq!(expect(true, "a", || unreachable!()), Ok(()));
        assert_eq!(expect(false, "a", || "b".into()), Err(Diagnosis::new("a", "b")));
        assert_eq!(Diagnosis::not_started("c").name, Diagnosis::NOT_STARTED);
    }
}
