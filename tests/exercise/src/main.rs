//! `cargo exercise`: lists the exercises of all chapters, checks answers, opens hints one by one, shows solutions, and
//! brings a stub back.

mod answer;
mod arguments;
mod cargo;
mod crash;
mod discovery;
mod exercise;
mod hints;
mod list;
mod progress;
mod prove;
mod reset;
mod said;
mod solution;
mod stub;
mod terminal;

use std::process::ExitCode;

use arguments::{Command, Wish};

fn main() -> ExitCode {
    match run() {
        Ok(code) => code,
        Err(failure) => {
            terminal::complain(&failure.message);
            failure.code
        }
    }
}

/// Why the program ends early: one line, and the exit code.
#[derive(Debug)]
struct Failure {
    message: String,
    code: ExitCode,
}

impl Failure {
    /// The command line is wrong.
    fn usage(message: impl Into<String>) -> Self {
        Self { message: message.into(), code: ExitCode::from(2) }
    }

    /// Something could not be read, written or started.
    fn system(message: impl Into<String>) -> Self {
        Self { message: message.into(), code: ExitCode::FAILURE }
    }
}

fn run() -> Result<ExitCode, Failure> {
    // An argument that is no text names nothing, and is refused by what can be shown of it.
    let given = std::env::args_os().skip(1).map(|argument| argument.to_string_lossy().into_owned());
    let command = arguments::parse(given)?;
    let root = discovery::root()?;
    let exercises = discovery::all(&root)?;
    let text = match command {
        Command::Help => arguments::HELP.into(),
        Command::Prove => return prove::all(&root, &exercises),
        Command::List => list::show(&root, &exercises)?,
        Command::One { name, wish } => {
            let exercise = discovery::named(&exercises, &name)?;
            match wish {
                Wish::Check => return answer::check(&root, &exercises, exercise),
                Wish::Hint => hints::open_next(&root, exercise)?,
                Wish::Solution => solution::show(&root, exercise)?,
                Wish::Reset => reset::run(&root, exercise)?,
            }
        }
    };
    terminal::say(&text);
    Ok(ExitCode::SUCCESS)
}
