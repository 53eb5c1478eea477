//! The program of an exercise: check the answer, and show its picture once it is accepted.

use std::{
    ffi::OsString,
    panic::{self, PanicHookInfo},
    process::ExitCode,
    sync::mpsc::{self, RecvTimeoutError},
    thread,
    time::Duration,
};

use super::{Diagnosis, Finding, TRIED, Verdict};
use crate::{cli, output, picture::Chapter};

/// How long an answer may take before it counts as an endless loop. Every check takes less than a second.
const PATIENCE: Duration = Duration::from_secs(20);

/// All that the `main` of an exercise does: check the answer, then render the picture of `chapter`, whose name begins
/// with the exercise's number.
///
/// With the argument `--check` it only checks. The answer may print what it likes; after that there is a line
/// `verdict: accepted`, or `verdict: ` and the name of the diagnosis, then the message, and a line `verdict ends`. On
/// standard error a line `check begins` parts what the answer writes from what the compiler has written.
///
/// Whoever names the picture sees it whatever the check says.
///
/// Exit code 0 when the answer is accepted and the picture was made, 2 when the command line was wrong, otherwise 1.
#[must_use]
pub fn main(check: fn() -> Verdict, chapter: &Chapter) -> ExitCode {
    let arguments: Vec<_> = std::env::args_os().skip(1).collect();
    let is = |argument: &OsString, word: &str| argument.as_os_str() == word;
    if arguments.iter().any(|a| is(a, "--help") || is(a, "-h")) {
        return print(&help(chapter), ExitCode::SUCCESS);
    }
    if is_check(&arguments) {
        cli::say("check begins");
    }
    match judge(check) {
        // What the answer has printed may lack the end of its last line.
        Ok(()) if is_check(&arguments) => print("\nverdict: accepted\nverdict ends\n", ExitCode::SUCCESS),
        Ok(()) => cli::run(chapter),
        Err(Diagnosis { name, message }) if is_check(&arguments) => {
            print(&format!("\nverdict: {name}\n{message}\nverdict ends\n"), ExitCode::FAILURE)
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
    let (panicked, panics) = mpsc::channel();
    panic::set_hook(Box::new(move |panic| {
        // Nobody listens any more only after the verdict is known.
        let _ = panicked.send(place_and_words(panic));
    }));
    let (verdict, verdicts) = mpsc::channel();
    thread::spawn(move || {
        let judged = panic::catch_unwind(check).unwrap_or_else(|_| {
            let what = panics.try_iter().last().unwrap_or_default();
            Err(gave_up(TRIED.take(), &what))
        });
        verdict.send(judged)
    });
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

/// Where there was a panic, and what it said.
fn place_and_words(panic: &PanicHookInfo<'_>) -> String {
    let place = panic.location().map_or_else(|| "an unknown place".into(), ToString::to_string);
    let payload = panic.payload();
    let words =
        payload.downcast_ref::<&str>().copied().or_else(|| payload.downcast_ref::<String>().map(String::as_str));
    format!("{place}: {}", words.unwrap_or("no words"))
}

/// The diagnosis for an answer that panics.
fn gave_up(tried: Option<String>, what: &str) -> Diagnosis {
    const NAME: &str = "panicked";
    const ADVICE: &str = "Your code panicked, in the file and line above. This happens, for instance, by `unwrap` where there is nothing, \
                          by an index outside of an array, and by `todo!`.";
    match tried {
        Some(tried) => {
            let (got, expected) = (format!("a panic at {what}"), "an answer without a panic".into());
            Finding { tried, got, expected, advice: ADVICE.into() }.named(NAME)
        }
        None => Diagnosis::new(NAME, format!("There was a panic at {what}\n\n{ADVICE}")),
    }
}

/// What to say when the answer is not accepted.
fn refusal(Diagnosis { name, message }: &Diagnosis, chapter: &Chapter) -> String {
    let picture = chapter.pictures.first().map_or("", |p| p.name);
    let number = number(chapter);
    let heading = if *name == Diagnosis::NOT_STARTED { "Not started yet." } else { "Not right yet." };
    format!(
        "{heading} [{name}]\n\n{message}\n\n\
         A hint:                      cargo exercise {number} --hint\n\
         The picture as it is so far: {}",
        picture_command(picture)
    )
}

/// The command that shows the picture whatever the check says.
fn picture_command(picture: &str) -> String {
    // The program is called PACKAGE-3-NAME, for a solution with `-solution` behind it, and its picture 1.3-NAME.
    let program = std::env::current_exe().unwrap_or_default();
    let program = program.file_stem().unwrap_or_default().to_string_lossy();
    let package = picture.split_once('.').and_then(|(_, number_and_name)| {
        program.trim_end_matches("-solution").strip_suffix(number_and_name)?.strip_suffix('-')
    });
    match package {
        Some(package) => format!("cargo run -p {package} --example {program} -- {picture}"),
        None => format!("add '-- {picture}' to the command"),
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_a_diagnosis_with_what_was_tried() {
        let told = gave_up(Some("a ray".into()), "cube.rs:3:4: none");
        assert_eq!(told.name, "panicked");
        assert!(told.message.starts_with("Tried:    a ray\nGot:      a panic at cube.rs:3:4: none\n"), "{told}");
        assert!(
            gave_up(None, "cube.rs:3:4: none").message.starts_with("There was a panic at cube.rs:3:4: none\n\nYour")
        );
    }
}
