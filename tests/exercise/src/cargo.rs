//! Builds and runs examples with cargo.

use std::{
    env,
    ffi::OsString,
    path::Path,
    process::{Command, Output, Stdio},
};

use crate::{Failure, exercise::Exercise, progress, terminal};

/// How far an answer is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum State {
    /// The check accepts it.
    Done,
    /// It is the stub as it was delivered; the message of the check.
    NotStarted(String),
    /// The check does not accept it.
    NotRight {
        /// Name of the diagnosis.
        name: String,
        /// The message of the check.
        message: String,
    },
    /// The compiler does not accept it.
    DoesNotCompile,
}

impl State {
    /// The state in few words.
    pub(crate) fn words(&self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::NotStarted(_) => "not started",
            Self::NotRight { .. } => "not right yet",
            Self::DoesNotCompile => "does not compile",
        }
    }

    /// What the program of an exercise says when it is run with `--check`: a line `verdict: NAME`, then the message.
    fn told(text: &str) -> Option<Self> {
        let (first, message) = text.split_once('\n')?;
        let message = message.trim_end().to_owned();
        Some(match first.strip_prefix("verdict: ")?.trim_end() {
            "accepted" => Self::Done,
            "not-started" => Self::NotStarted(message),
            name => Self::NotRight { name: name.into(), message },
        })
    }
}

/// Whether the compiler's messages are wanted.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Messages {
    /// They go to standard error, as they come.
    Shown,
    /// Nobody sees them.
    Hidden,
}

/// Build these examples of a package as far as possible. Whether all of them could be built.
pub(crate) fn build(root: &Path, package: &str, examples: &[String], messages: Messages) -> Result<bool, Failure> {
    let mut command = command(root);
    command.args(["build", "--keep-going", "--package", package]);
    for example in examples {
        command.args(["--example", example]);
    }
    if progress::is_new(root) {
        // All libraries are built too, which takes a while: let cargo show that something happens.
        terminal::note("The first time, everything must be built. This takes a minute or two.");
        progress::begin(root)?;
    } else {
        command.arg("--quiet");
        if messages == Messages::Hidden {
            command.stderr(Stdio::null());
        }
    }
    Ok(command.status().map_err(no_cargo)?.success())
}

/// Check one example of an exercise: the stub's or the solution's.
pub(crate) fn check(root: &Path, exercise: &Exercise, example: &str, messages: Messages) -> Result<State, Failure> {
    if !build(root, &exercise.package, &[example.to_owned()], messages)? {
        return Ok(State::DoesNotCompile);
    }
    let Output { stdout, status, .. } = run(root, exercise, example, &["--check"])?;
    Ok(State::told(&String::from_utf8_lossy(&stdout)).unwrap_or_else(|| State::NotRight {
        name: "crashed".into(),
        message: format!(
            "Your program ended without an answer: {status}.\n\nDoes a function call itself without end? That uses up the stack."
        ),
    }))
}

/// Run an example that is built already, and catch what it says.
pub(crate) fn run(root: &Path, exercise: &Exercise, example: &str, arguments: &[&str]) -> Result<Output, Failure> {
    let mut command = command(root);
    command.args(["run", "--quiet", "--package", &exercise.package, "--example", example, "--"]).args(arguments);
    command.output().map_err(no_cargo)
}

/// Cargo, in the workspace's folder, by the name under which it runs us.
fn command(root: &Path) -> Command {
    let mut command = Command::new(env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo")));
    command.current_dir(root).stdin(Stdio::null());
    command
}

fn no_cargo(error: std::io::Error) -> Failure {
    Failure::system(format!("cannot start cargo: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_verdict_is_read_from_the_first_line() {
        assert_eq!(State::told("verdict: accepted\n"), Some(State::Done));
        assert_eq!(State::told("verdict: not-started\nBegin.\n"), Some(State::NotStarted("Begin.".into())));
        assert_eq!(
            State::told("verdict: wrong-sign\nTried: a\nGot: b\n"),
            Some(State::NotRight { name: "wrong-sign".into(), message: "Tried: a\nGot: b".into() })
        );
        assert_eq!(State::told(""), None);
        assert_eq!(State::told("something else\n"), None);
    }
}
