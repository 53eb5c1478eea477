//! The program of an exercise: check the answer, and show its picture once it is accepted.

use std::{
    ffi::OsString,
    panic,
    process::ExitCode,
    sync::mpsc::{self, RecvTimeoutError},
    thread,
    time::Duration,
};

use super::{Diagnosis, Verdict};
use crate::{cli, output, picture::Chapter};

/// How long an answer may take before it counts as an endless loop. Every check takes less than a second.
const PATIENCE: Duration = Duration::from_secs(20);

/// All that the `main` of an exercise does: check the answer, then render the picture of `chapter`, whose name begins
/// with the exercise's number.
///
/// With the argument `--check` it only checks. The first line of its output is then `verdict: accepted`, or `verdict: `
/// and the name of the diagnosis; the message follows. Whoever names the picture sees it whatever the check says.
///
/// Exit code 0 when the answer is accepted and the picture was made, 2 when the command line was wrong, otherwise 1.
#[must_use]
pub fn main(check: fn() -> Verdict, chapter: &Chapter) -> ExitCode {
    let arguments: Vec<_> = std::env::args_os().skip(1).collect();
    let is = |argument: &OsString, word: &str| argument.as_os_str() == word;
    if arguments.iter().any(|a| is(a, "--help") || is(a, "-h")) {
        return print(&help(chapter), ExitCode::SUCCESS);
    }
    match judge(check) {
        Ok(()) if is_check(&arguments) => print("verdict: accepted\n", ExitCode::SUCCESS),
        Ok(()) => cli::run(chapter),
        Err(Diagnosis { name, message }) if is_check(&arguments) => {
            print(&format!("verdict: {name}\n{message}\n"), ExitCode::FAILURE)
        }
        Err(diagnosis) => {
            cli::say(&refusal(&diagnosis, chapter));
            let is_named = arguments.iter().any(|a| chapter.pictures.iter().any(|p| is(a, p.name)));
            if is_named {
                // The picture helps to find the mistake. Whether it could be made or not: the answer is not right yet.
                let _ = cli::run(chapter);
            }
            ExitCode::FAILURE
        }
    }
}

fn is_check(arguments: &[OsString]) -> bool {
    matches!(arguments, [only] if only.as_os_str() == "--check")
}

/// The verdict of a check; a panic in the answer or an endless loop is a diagnosis too.
fn judge(check: fn() -> Verdict) -> Verdict {
    let (verdict, verdicts) = mpsc::channel();
    let panicked = verdict.clone();
    panic::set_hook(Box::new(move |panic| {
        // Nobody listens any more only after the verdict is known.
        let _ = panicked.send(Err(Diagnosis::new(
            "panicked",
            format!("While it was tried, your code gave up: it {panic}\n\nThe line above says where."),
        )));
    }));
    thread::spawn(move || verdict.send(check()));
    let verdict = verdicts.recv_timeout(PATIENCE).unwrap_or_else(|error| {
        let what = match error {
            RecvTimeoutError::Timeout => format!("no answer after {} seconds", PATIENCE.as_secs()),
            RecvTimeoutError::Disconnected => "the check ended without a verdict".into(),
        };
        Err(Diagnosis::new("endless", format!("There was {what}. Is there a loop that never ends?")))
    });
    drop(panic::take_hook());
    verdict
}

/// What to say when the answer is not accepted.
fn refusal(Diagnosis { name, message }: &Diagnosis, chapter: &Chapter) -> String {
    let picture = chapter.pictures.first().map_or("", |p| p.name);
    let number = number(chapter);
    let heading = if *name == Diagnosis::NOT_STARTED { "Not started yet." } else { "Not right yet." };
    format!(
        "{heading} [{name}]\n\n{message}\n\n\
         A hint:                      cargo exercise {number} --hint\n\
         The picture as it is so far: add '-- {picture}' to the command"
    )
}

/// The number of the exercise, from the name of its picture.
fn number(chapter: &Chapter) -> &'static str {
    chapter.pictures.first().and_then(|p| p.name.split('-').next()).unwrap_or_default()
}

fn help(chapter: &Chapter) -> String {
    let picture = chapter.pictures.first().map_or("", |p| p.name);
    format!(
        "Exercise {}: checks your answer and, once it is accepted, shows its picture.\n\n\
         --check     only check\n\
         {picture}   show the picture whatever the check says\n\n\
         The options for pictures are those of every chapter: --no-window, --output FILE, --size WxH, --samples N,\n\
         --set KNOB=VALUE, --pixel X,Y, --list and more.\n",
        number(chapter)
    )
}

/// Write to standard output. Whoever closed the pipe has seen enough.
fn print(text: &str, code: ExitCode) -> ExitCode {
    match output::write_to_stdout(text.as_bytes()) {
        Ok(()) | Err(crate::Error::ClosedPipe) => code,
        Err(error) => {
            cli::say(&format!("error: {error}"));
            ExitCode::FAILURE
        }
    }
}
