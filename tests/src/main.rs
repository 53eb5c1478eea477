//! Any chapter of the course: `chapter NAME …` does what the chapter's own program does with `…`. The tests of the
//! command line run this one, since a test can run only the programs of its own package.

use std::process::ExitCode;

fn main() -> ExitCode {
    let mut arguments = std::env::args_os();
    let _program = arguments.next();
    let name = arguments.next().unwrap_or_default();
    match course::CHAPTERS.iter().find(|c| name == c.name) {
        Some(chapter) => common::cli::run_with(chapter, std::iter::once(name).chain(arguments)),
        None => {
            eprintln!("error: no chapter is called '{}'", name.display());
            ExitCode::from(2)
        }
    }
}
