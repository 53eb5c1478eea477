//! What is said, and where.

use std::io::{self, Write as _};

/// Say something on standard output.
///
/// Whoever has closed the pipe, as in `cargo exercise | head -1`, has seen enough, and that is no error.
pub(crate) fn say(text: &str) {
    let mut out = io::stdout().lock();
    let _ = writeln!(out, "{text}").and_then(|()| out.flush());
}

/// Say in one line on standard error what was wrong.
pub(crate) fn complain(message: &str) {
    note(&format!("error: {message}"));
}

/// A line on standard error, for people only.
pub(crate) fn note(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}
