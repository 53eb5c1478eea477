//! What the exercises of all chapters share: a check ends in a diagnosis, and a diagnosis is said in a friendly way.
//!
//! An exercise is a stub, a check and a solution with the same signatures. The check is told what the student has
//! written, tries it, and either accepts it or names the likely mistake.

use std::fmt;

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
