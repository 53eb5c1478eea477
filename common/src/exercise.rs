//! What the exercises of all chapters share: a check ends in a diagnosis, and a diagnosis is said in a friendly way.
//!
//! An exercise is a stub, a check and a solution with the same signatures. The check is told what the student has
//! written, tries it, and either accepts it or names the likely mistake.

use std::fmt;

pub mod dice;
#[cfg(feature = "cli")]
mod judge;
#[cfg(feature = "cli")]
mod panic;
#[cfg(feature = "cli")]
mod run;
#[cfg_attr(not(feature = "cli"), allow(dead_code, reason = "only the program of an exercise asks what was tried"))]
mod trial;
pub mod words;

#[cfg(feature = "cli")]
pub use run::main;
pub use trial::trying;

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
        for (lead, text) in [("Tried:    ", &self.tried), ("Got:      ", &self.got), ("Expected: ", &self.expected)] {
            writeln!(f, "{}", paragraph(lead, text))?;
        }
        write!(f, "\n{}", paragraph("", &self.advice))
    }
}

/// Longest line of a message, in characters.
const WIDTH: usize = 100;

/// Text behind a lead, in lines of at most [`WIDTH`] characters, all of them as far from the margin as the first.
fn paragraph(lead: &str, text: &str) -> String {
    let (mut paragraph, mut width) = (lead.to_owned(), lead.len());
    for (i, word) in words(text).iter().enumerate() {
        let length = word.chars().count();
        if i > 0 && width + 1 + length > WIDTH {
            paragraph += &format!("\n{}", " ".repeat(lead.len()));
            width = lead.len();
        } else if i > 0 {
            paragraph.push(' ');
            width += 1;
        }
        paragraph += word;
        width += length;
    }
    paragraph
}

/// The words of a text. What stands in parentheses is not parted, so that points stay whole.
fn words(text: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let is_open = |word: &String| word.matches('(').count() > word.matches(')').count();
    for word in text.split_whitespace() {
        match words.last_mut().filter(|last| is_open(last)) {
            Some(last) => *last += &format!(" {word}"),
            None => words.push(word.to_owned()),
        }
    }
    words
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
    fn long_texts_are_broken_between_words() {
        let text = ["twelve chars"; 12].join(" ");
        let broken = paragraph("Got: ", &text);
        assert!(broken.lines().all(|line| line.chars().count() <= WIDTH));
        assert_eq!(broken.lines().count(), 2);
        assert!(broken.lines().nth(1).unwrap().starts_with("     "));
        assert_eq!(broken.split_whitespace().skip(1).collect::<Vec<_>>().join(" "), text);
        // A word that is too long stands alone, and a point stays whole.
        assert_eq!(paragraph("", &"x".repeat(200)).len(), 200);
        assert_eq!(words("from (1, 2, 3) on"), ["from", "(1, 2, 3)", "on"]);
    }

    #[test]
    fn the_message_is_made_only_when_it_is_needed() {
        assert_eq!(expect(true, "a", || unreachable!()), Ok(()));
        assert_eq!(expect(false, "a", || "b".into()), Err(Diagnosis::new("a", "b")));
        assert_eq!(Diagnosis::not_started("c").name, Diagnosis::NOT_STARTED);
    }
}
