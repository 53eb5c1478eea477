//! Builds and runs examples with cargo.

use std::{
    env,
    ffi::OsString,
    path::{Path, PathBuf},
    process::{Command, ExitStatus, Stdio},
    thread,
};

use crate::{Failure, crash::Ending, exercise::Exercise, progress, said::Said, terminal};

/// Name of the diagnosis for a program that ends before there is a verdict.
const CRASHED: &str = "crashed";

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
    /// How many lines that was.
    pub(crate) lines: usize,
}

impl Outcome {
    /// What the program of an exercise has said when it was run with `--check`. `code` and `words` say how it ended.
    ///
    /// On standard output there is what the answer prints, then `verdict: NAME`, the message, and `verdict ends`. On
    /// standard error there is what the compiler says, then `check begins`, and what the answer writes there.
    fn told(stdout: Said, stderr: Said, code: Option<i32>, words: &str) -> Self {
        // A line begins behind the end of another one. The last such line counts: an answer may print anything before.
        let text = format!("\n{}", stdout.end);
        let (printed, verdict) = text.rsplit_once("\nverdict: ").unwrap_or((&text, ""));
        let verdict = verdict.split_once("\nverdict ends\n").map_or(verdict, |(verdict, _)| verdict);
        let written = stderr.end.split_once("check begins\n").map_or(&*stderr.end, |(_, written)| written);
        let state = State::told(&format!("{verdict}\n")).filter(|_| !verdict.is_empty());
        let [printed, written] =
            [(printed, stdout.before), (written, stderr.before)].map(|(end, before)| Said { end: end.into(), before });
        Self {
            state: state.unwrap_or_else(|| State::NotRight {
                name: CRASHED.into(),
                message: Ending { code, words, written: &written.end }.cause(),
            }),
            printed: printed.last_lines("Your program printed")
                + &written.last_lines("Your program wrote on standard error"),
            lines: printed.lines() + written.lines(),
        }
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
        terminal::note("The first time, everything must be built. This takes some minutes.");
        progress::begin(root)?;
    } else {
        command.arg("--quiet");
        if messages == Messages::Hidden {
            command.stderr(Stdio::null());
        }
    }
    Ok(command.status().map_err(no_cargo)?.success())
}

/// Build these examples of all packages at once, as `cargo test --workspace` does: what that has built already is not built
/// once more. Returns their programs, without those that do not compile.
pub(crate) fn build_together(root: &Path, examples: &[String]) -> Result<Vec<PathBuf>, Failure> {
    let mut command = command(root);
    command.args(["build", "--workspace", "--keep-going", "--message-format=json-render-diagnostics"]);
    for example in examples {
        command.args(["--example", example]);
    }
    let output = command.stderr(Stdio::inherit()).output().map_err(no_cargo)?;
    let messages = String::from_utf8_lossy(&output.stdout);
    Ok(messages.lines().filter_map(executable).collect())
}

/// The program that a message of cargo tells of.
fn executable(message: &str) -> Option<PathBuf> {
    let (_, rest) = message.split_once(r#""executable":""#)?;
    let (path, _) = rest.split_once('"')?;
    // In JSON, a backslash is written twice.
    Some(path.replace(r"\\", r"\").into())
}

/// How far the example of that name is, among these programs.
pub(crate) fn check_program(root: &Path, programs: &[PathBuf], example: &str) -> Result<State, Failure> {
    let Some(program) = programs.iter().find(|program| program.file_stem().is_some_and(|stem| stem == example)) else {
        return Ok(State::DoesNotCompile);
    };
    let run = |arguments: &[&str]| {
        let mut command = Command::new(program);
        command.current_dir(root).stdin(Stdio::null()).args(arguments);
        caught(command)
    };
    Ok(judge(run)?.state)
}

/// How far one example of an exercise is: the stub's or the solution's.
pub(crate) fn check(root: &Path, exercise: &Exercise, example: &str, messages: Messages) -> Result<State, Failure> {
    Ok(try_out(root, exercise, example, messages)?.state)
}

/// Check one example of an exercise.
pub(crate) fn try_out(root: &Path, exercise: &Exercise, example: &str, messages: Messages) -> Result<Outcome, Failure> {
    if !build(root, &exercise.package, &[example.to_owned()], messages)? {
        return Ok(Outcome { state: State::DoesNotCompile, printed: String::new(), lines: 0 });
    }
    judge(|arguments| run(root, exercise, example, arguments))
}

/// What the program of an exercise says of itself. `run` runs it with these arguments.
fn judge(run: impl Fn(&[&str]) -> Result<Run, Failure>) -> Result<Outcome, Failure> {
    let Run { stdout, stderr, status } = run(&["--check"])?;
    let words = status.to_string();
    let mut outcome = Outcome::told(stdout, stderr, status.code(), &words);
    if let State::NotRight { name, message } = &mut outcome.state
        && name == CRASHED
        && !words.contains("SIGKILL")
    {
        // A check asks the same in every run. Once more, and this time it says what it asks.
        let again = run(&["--check", "--tell"])?;
        if let Some(tried) = last_trial(&again.stderr.end) {
            *message = format!("{tried}\n\n{message}");
        }
    }
    Ok(outcome)
}

/// What a program has tried last that was run with `--tell`.
fn last_trial(stderr: &str) -> Option<&str> {
    let (_, tried) = stderr.rsplit_once("\ntrial begins\n")?;
    Some(tried.split_once("\ntrial ends\n")?.0)
}

/// What a program has said, and how it ended.
pub(crate) struct Run {
    /// On standard output.
    pub(crate) stdout: Said,
    /// On standard error.
    pub(crate) stderr: Said,
    /// Its end.
    pub(crate) status: ExitStatus,
}

/// Run an example that is built already, and catch what it says.
pub(crate) fn run(root: &Path, exercise: &Exercise, example: &str, arguments: &[&str]) -> Result<Run, Failure> {
    let mut command = command(root);
    command.args(["run", "--quiet", "--package", &exercise.package, "--example", example, "--"]).args(arguments);
    caught(command)
}

/// Run a program, and catch what it says.
fn caught(mut command: Command) -> Result<Run, Failure> {
    // Of a panic, its place and its words are shown. The calls that led there would hide them.
    command.env("RUST_BACKTRACE", "0");
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().map_err(no_cargo)?;
    // Both at once, so that neither waits for the other.
    let stderr = child.stderr.take().map(|pipe| thread::spawn(|| Said::read(pipe)));
    let stdout = child.stdout.take().map(Said::read).unwrap_or_default();
    let stderr = stderr.and_then(|reader| reader.join().ok()).unwrap_or_default();
    Ok(Run { status: child.wait().map_err(no_cargo)?, stdout, stderr })
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
    use crate::said::tests::said;

    fn told(stdout: &str, stderr: &str) -> (State, String) {
        let Outcome { state, printed, .. } = Outcome::told(said(stdout), said(stderr), Some(1), "exit status: 1");
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
    fn the_lines_that_an_answer_prints_are_counted() {
        let (stdout, stderr) = ("t = 1\nt = 2\n\nverdict: accepted\nverdict ends\n", "check begins\nt = 3\n");
        assert_eq!(Outcome::told(said(stdout), said(stderr), Some(0), "").lines, 3);
        let silent = "\nverdict: accepted\nverdict ends\n";
        assert_eq!(Outcome::told(said(silent), said("check begins\n"), Some(0), "").lines, 0);
    }

    #[test]
    fn programs_are_found_in_cargos_messages() {
        let artifact =
            r#"{"reason":"compiler-artifact","target":{"name":"a"},"executable":"C:\\a b\\a.exe","fresh":true}"#;
        assert_eq!(executable(artifact), Some(r"C:\a b\a.exe".into()));
        assert_eq!(executable(&artifact.replace(r#""C:\\a b\\a.exe""#, "null")), None);
        assert_eq!(executable(r#"{"reason":"build-finished","success":true}"#), None);
        let state = check_program(Path::new("."), &[PathBuf::from("/some/ball")], "cube").unwrap();
        assert_eq!(state, State::DoesNotCompile);
    }

    #[test]
    fn the_last_trial_is_read() {
        let one = "\ntrial begins\nTried:    a ray\ntrial ends\nt = 1";
        let stderr =
            format!("check begins\n{one}{}\nit has overflowed its stack\n", one.replace("ray", "box\n of two lines"));
        assert_eq!(last_trial(&stderr), Some("Tried:    a box\n of two lines"));
        assert_eq!(last_trial("check begins\n"), None);
    }

    #[test]
    fn no_verdict_is_a_crash() {
        for (stdout, stderr) in [("", ""), ("something else\n", "check begins\nan error\n")] {
            let (state, printed) = told(stdout, stderr);
            let State::NotRight { name, message } = state else { panic!("{state:?}") };
            assert!(name == CRASHED && message.contains("exit status: 1"), "{message}");
            assert_eq!(printed.contains("  an error\n"), !stderr.is_empty());
        }
    }
}
