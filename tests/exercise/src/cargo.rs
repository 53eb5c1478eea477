//! Builds and runs examples with cargo.

use std::{
    env,
    ffi::OsString,
    io::{self, Read},
    path::Path,
    process::{Command, Output, Stdio},
    thread,
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

    /// The verdict that the program of an exercise has given: the name, and in the next lines the message.
    fn told(verdict: &str) -> Option<Self> {
        let (name, message) = verdict.split_once('\n')?;
        let message = message.trim_end().to_owned();
        Some(match name.trim_end() {
            "accepted" => Self::Done,
            "not-started" => Self::NotStarted(message),
            name => Self::NotRight { name: name.into(), message },
        })
    }
}

/// What has become of an answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Outcome {
    /// How far it is.
    pub(crate) state: State,
    /// What it has printed by itself, ready to be shown; often nothing.
    pub(crate) printed: String,
}

impl Outcome {
    /// What the program of an exercise has said when it was run with `--check`. `how` says how it ended.
    ///
    /// On standard output there is what the answer prints, then `verdict: NAME`, the message, and `verdict ends`. On
    /// standard error there is what the compiler says, then `check begins`, and what the answer writes there.
    fn told(stdout: &str, stderr: &str, how: &str) -> Self {
        let (stdout, stderr) = (stdout.replace("\r\n", "\n"), stderr.replace("\r\n", "\n"));
        // A line begins behind the end of another one. The last such line counts: an answer may print anything before.
        let stdout = format!("\n{stdout}");
        let (printed, verdict) = stdout.rsplit_once("\nverdict: ").unwrap_or((&stdout, ""));
        let verdict = verdict.split_once("\nverdict ends\n").map_or(verdict, |(verdict, _)| verdict);
        let written = stderr.split_once("check begins\n").map_or(&*stderr, |(_, written)| written);
        let state = State::told(&format!("{verdict}\n")).filter(|_| !verdict.is_empty());
        Self {
            state: state.unwrap_or_else(|| State::NotRight {
                name: "crashed".into(),
                message: format!(
                    "Your program ended without an answer: {how}.\n\n\
                     Does a function call itself without end? That uses up the stack."
                ),
            }),
            printed: last_lines("Your program printed", printed)
                + &last_lines("Your program wrote on standard error", written),
        }
    }
}

/// The last lines of what a program has said, under a heading; nothing if it has said nothing.
pub(crate) fn last_lines(heading: &str, text: &str) -> String {
    const LINES: usize = 20;
    const WIDTH: usize = 200;
    let text = text.trim_matches('\n').trim_end();
    let count = text.lines().count();
    let mut shown = match count {
        0 => return String::new(),
        1..=LINES => format!("{heading}:\n"),
        _ => format!("{heading}, the last {LINES} lines:\n"),
    };
    for line in text.lines().skip(count.saturating_sub(LINES)) {
        let end = line.char_indices().nth(WIDTH).map(|(end, _)| end);
        shown += &end.map_or_else(|| format!("  {line}\n"), |end| format!("  {} …\n", &line[..end]));
    }
    shown
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

/// How far one example of an exercise is: the stub's or the solution's.
pub(crate) fn check(root: &Path, exercise: &Exercise, example: &str, messages: Messages) -> Result<State, Failure> {
    Ok(try_out(root, exercise, example, messages)?.state)
}

/// Check one example of an exercise.
pub(crate) fn try_out(root: &Path, exercise: &Exercise, example: &str, messages: Messages) -> Result<Outcome, Failure> {
    if !build(root, &exercise.package, &[example.to_owned()], messages)? {
        return Ok(Outcome { state: State::DoesNotCompile, printed: String::new() });
    }
    let Output { stdout, stderr, status } = run(root, exercise, example, &["--check"])?;
    let [stdout, stderr] = [&stdout, &stderr].map(|bytes| String::from_utf8_lossy(bytes));
    Ok(Outcome::told(&stdout, &stderr, &status.to_string()))
}

/// Run an example that is built already, and catch what it says.
pub(crate) fn run(root: &Path, exercise: &Exercise, example: &str, arguments: &[&str]) -> Result<Output, Failure> {
    let mut command = command(root);
    command.args(["run", "--quiet", "--package", &exercise.package, "--example", example, "--"]).args(arguments);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().map_err(no_cargo)?;
    // Both at once, so that neither waits for the other.
    let stderr = child.stderr.take().map(|pipe| thread::spawn(|| end_of(pipe)));
    let stdout = child.stdout.take().map(end_of).unwrap_or_default();
    let stderr = stderr.and_then(|reader| reader.join().ok()).unwrap_or_default();
    Ok(Output { status: child.wait().map_err(no_cargo)?, stdout, stderr })
}

/// What comes last from a pipe: an endless loop that prints must not fill the memory.
fn end_of(mut pipe: impl Read) -> Vec<u8> {
    const KEPT: usize = 1 << 20;
    let (mut all, mut part) = (Vec::new(), [0; 1 << 14]);
    loop {
        match pipe.read(&mut part) {
            Ok(0) => return all,
            Ok(count) => all.extend_from_slice(&part[..count]),
            Err(e) if e.kind() == io::ErrorKind::Interrupted => {}
            Err(_) => return all,
        }
        if all.len() > 2 * KEPT {
            all.drain(..all.len() - KEPT);
        }
    }
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

    fn told(stdout: &str, stderr: &str) -> (State, String) {
        let Outcome { state, printed } = Outcome::told(stdout, stderr, "exit status: 1");
        (state, printed)
    }

    #[test]
    fn a_verdict_is_read_whatever_is_printed_before() {
        let silent = String::new;
        assert_eq!(told("\nverdict: accepted\nverdict ends\n", "check begins\n"), (State::Done, silent()));
        let fresh = State::NotStarted("Begin.".into());
        assert_eq!(told("verdict: not-started\r\nBegin.\r\nverdict ends\r\n", ""), (fresh, silent()));
        let wrong = State::NotRight { name: "wrong-sign".into(), message: "Tried: a\nGot: b".into() };
        assert_eq!(
            told("t = 1\nverdict: mine\nt = 2\nverdict: wrong-sign\nTried: a\nGot: b\nverdict ends\nt = 3\n", ""),
            (wrong, "Your program printed:\n  t = 1\n  verdict: mine\n  t = 2\n".into())
        );
        assert_eq!(
            told("\nverdict: accepted\n", "warning: unused\ncheck begins\nt = 1\n"),
            (State::Done, "Your program wrote on standard error:\n  t = 1\n".into())
        );
    }

    #[test]
    fn of_very_much_only_the_end_is_kept() {
        let much = io::repeat(b'x').take(5 << 20).chain(&b"end"[..]);
        let kept = end_of(much);
        assert!(kept.ends_with(b"xend") && kept.len() < 3 << 20);
        assert_eq!(end_of(&b"little"[..]), b"little");
    }

    #[test]
    fn no_verdict_is_a_crash() {
        for (stdout, stderr) in [("", ""), ("something else\n", "check begins\nstack overflow\n")] {
            let (state, printed) = told(stdout, stderr);
            let State::NotRight { name, message } = state else { panic!("{state:?}") };
            assert!(name == "crashed" && message.contains("exit status: 1"), "{message}");
            assert_eq!(printed.contains("  stack overflow\n"), !stderr.is_empty());
        }
    }

    #[test]
    fn only_the_last_lines_are_shown() {
        let many: String = (1..=50).map(|i| format!("line {i}\n")).collect();
        let shown = last_lines("It printed", &many);
        assert!(shown.starts_with("It printed, the last 20 lines:\n  line 31\n"), "{shown}");
        assert!(shown.ends_with("  line 50\n"));
        assert_eq!(
            last_lines("It printed", &"x".repeat(500)).lines().nth(1).map(|line| line.chars().count()),
            Some(204)
        );
        assert_eq!(last_lines("It printed", " \n\n"), "");
    }
}
