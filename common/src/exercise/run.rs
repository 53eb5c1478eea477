//! The program of an exercise: check the answer, and show its picture once it is accepted.

use std::{ffi::OsString, process::ExitCode};

use super::{Diagnosis, Verdict, judge::judge, paragraph, trial::Telling};
use crate::{cli, output, picture::Chapter};

/// All that the `main` of an exercise does: check the answer, then render the picture of `chapter`, whose name begins
/// with the exercise's number.
///
/// With the argument `--check` it only checks. The answer may print what it likes; after that there is a line
/// `verdict: accepted`, or `verdict: ` and the name of the diagnosis, then the message, and a line `verdict ends`. On
/// standard error a line `check begins` parts what the answer writes from what the compiler has written.
///
/// With `--check --tell` it also says on standard error what it tries, before it does so: a line `trial begins`, what is
/// tried, and a line `trial ends`. So it is known what a crash comes from. That takes time, and is done only when it is
/// needed.
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
    match judge(check, if is_telling(&arguments) { Telling::Each(tell) } else { Telling::Nothing }) {
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
    matches!(arguments, [only] if only.as_os_str() == "--check") || is_telling(arguments)
}

fn is_telling(arguments: &[OsString]) -> bool {
    matches!(arguments, [check, tell] if check.as_os_str() == "--check" && tell.as_os_str() == "--tell")
}

/// Say what is tried next. What the answer has written may lack the end of its last line.
fn tell(tried: &str) {
    cli::say(&format!("\ntrial begins\n{}\ntrial ends", paragraph("Tried:    ", tried)));
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
