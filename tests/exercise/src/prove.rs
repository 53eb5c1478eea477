//! Proves that the exercises fit together, for authors and for CI. Nothing is changed.

use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
    process::ExitCode,
};

use crate::{
    Failure,
    cargo::{State, build_together, check_program},
    discovery::names_in,
    exercise::{Exercise, read},
    hints::staged,
    stub::stub_of,
    terminal,
};

/// Prove everything, with one line for each exercise and for each folder. Exit code 0 if all is well.
pub(crate) fn all(root: &Path, exercises: &[Exercise]) -> Result<ExitCode, Failure> {
    if exercises.is_empty() {
        return Err(Failure::system("there are no exercises"));
    }
    let mut is_well = true;
    let mut tell = |what: &str, mistakes: &[String]| {
        is_well &= mistakes.is_empty();
        terminal::say(&if mistakes.is_empty() {
            format!("{what}: ok")
        } else {
            format!("{what}: {}", mistakes.join("; "))
        });
    };
    let examples: Vec<_> = exercises.iter().flat_map(|e| [e.example(), e.solution_example()]).collect();
    let programs = build_together(root, &examples)?;
    for chapter in exercises.chunk_by(|a, b| a.folder == b.folder) {
        tell(&chapter[0].folder.display().to_string(), &unexpected_files(root, chapter));
        for exercise in chapter {
            let mut mistakes = texts(root, exercise);
            mistakes.extend(verdicts(root, &programs, exercise)?);
            tell(&exercise.name(), &mistakes);
        }
    }
    Ok(if is_well { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// What is wrong with the files of an exercise.
fn texts(root: &Path, exercise: &Exercise) -> Vec<String> {
    let mut mistakes = Vec::new();
    let mut try_read = |file: &Path| read(root, file).map_err(|failure| mistakes.push(failure.message)).ok();
    let (stub, solution, hints) =
        (try_read(&exercise.stub()), try_read(&exercise.solution()), try_read(&exercise.hints()));
    let start = format!("//! # Exercise {}: ", exercise.id());
    if let Some(stub) = &stub
        && !stub.starts_with(&start)
    {
        mistakes.push(format!("the stub does not begin with '{start}TITLE'"));
    }
    match solution.map(|text| stub_of(&text)) {
        Some(Err(what)) => mistakes.push(format!("the marks of the solution: {what}")),
        Some(Ok(derived)) => mistakes.extend(stub.and_then(|stub| difference(&stub, &derived))),
        None => {}
    }
    if let Some(hints) = hints
        && staged(&hints).iter().any(String::is_empty)
    {
        mistakes.push("a hint is empty".into());
    }
    mistakes
}

/// The first line in which a stub is not what its solution says.
fn difference(stub: &str, derived: &str) -> Option<String> {
    let lines = stub.lines().count().max(derived.lines().count());
    let differs = (0..lines).find(|&i| stub.lines().nth(i) != derived.lines().nth(i))?;
    Some(format!("the stub is not what the solution's marks say, first in line {}", differs + 1))
}

/// What is wrong with the verdicts of the check.
fn verdicts(root: &Path, programs: &[PathBuf], exercise: &Exercise) -> Result<Vec<String>, Failure> {
    let mut mistakes = Vec::new();
    match check_program(root, programs, &exercise.example())? {
        State::NotStarted(message) if !message.is_empty() => {}
        state => mistakes.push(format!("the stub is told '{}'{}", state.words(), mistake(&state))),
    }
    match check_program(root, programs, &exercise.solution_example())? {
        State::Done => {}
        state => mistakes.push(format!("the solution is told '{}'{}", state.words(), mistake(&state))),
    }
    Ok(mistakes)
}

fn mistake(state: &State) -> String {
    if let State::NotRight { name, .. } = state { format!(" [{name}]") } else { String::new() }
}

/// Files of a chapter's exercises that belong to none of them.
fn unexpected_files(root: &Path, exercises: &[Exercise]) -> Vec<String> {
    let Some(Exercise { folder, .. }) = exercises.first() else { return Vec::new() };
    let known = |extension: &str| -> BTreeSet<String> {
        exercises.iter().map(|e| format!("{}-{}.{extension}", e.number, e.slug)).collect()
    };
    let (code, text) = (known("rs"), known("md"));
    // What several exercises share has a name without a number.
    let is_shared = |name: &str| name.ends_with(".rs") && !name.starts_with(|c: char| c.is_ascii_digit());
    let is_folder = |name: &str| ["checks", "hints", "kept", "pictures"].contains(&name);
    let mut unexpected = Vec::new();
    let mut look = |place: &str, is_expected: &dyn Fn(&str) -> bool| {
        let names = names_in(&root.join(folder).join(place));
        unexpected
            .extend(names.iter().filter(|name| !is_expected(name)).map(|name| format!("what is {place}/{name}?")));
    };
    look("exercises", &|name| code.contains(name) || is_folder(name));
    look("exercises/checks", &|name| code.contains(name) || is_shared(name));
    look("exercises/pictures", &|name| code.contains(name) || is_shared(name));
    look("exercises/hints", &|name| text.contains(name));
    look("solutions", &|name| code.contains(name));
    unexpected
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discovery::{self, tests::workspace};

    const STUB: &str = "//! # Exercise 1.2: a cube\nnone\n";
    const SOLUTION: &str = "//! # Exercise 1.2: a cube\n// STUB: none\nsome\n// END STUB\n";

    fn mistakes(stub: &str, solution: &str, hints: &str) -> String {
        let folder = workspace(&[
            ("chapters/01-toy/exercises/2-cube.rs", stub),
            ("chapters/01-toy/solutions/2-cube.rs", solution),
            ("chapters/01-toy/exercises/hints/2-cube.md", hints),
        ]);
        texts(folder.path(), &discovery::all(folder.path()).unwrap()[0]).join("; ")
    }

    #[test]
    fn stub_solution_and_hints_fit_together() {
        assert_eq!(mistakes(STUB, SOLUTION, "One.\n---\nTwo.\n"), "");
        assert!(mistakes(&STUB.replace("none", "mine"), SOLUTION, "One.").contains("line 2"));
        assert!(mistakes(STUB, &SOLUTION.replace("// END STUB", ""), "One.").contains("does not end"));
        assert!(mistakes(STUB, SOLUTION, "One.\n---\n").contains("a hint is empty"));
        let other = STUB.replace("1.2", "1.3");
        assert!(mistakes(&other, &SOLUTION.replace("1.2", "1.3"), "One.").contains("does not begin with"));
    }

    #[test]
    fn files_that_belong_to_no_exercise_are_found() {
        let folder = workspace(&[
            ("chapters/01-toy/exercises/2-cube.rs", STUB),
            ("chapters/01-toy/exercises/checks/2-cube.rs", ""),
            ("chapters/01-toy/exercises/checks/shared.rs", ""),
            ("chapters/01-toy/exercises/kept/2-cube.1.rs", ""),
        ]);
        let exercises = discovery::all(folder.path()).unwrap();
        assert_eq!(unexpected_files(folder.path(), &exercises), Vec::<String>::new());
        for file in
            ["exercises/2-cube.rs.part", "exercises/checks/3-ball.rs", "exercises/hints/2-ball.md", "solutions/old.rs"]
        {
            let path = folder.path().join("chapters/01-toy").join(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, "").unwrap();
        }
        assert_eq!(unexpected_files(folder.path(), &exercises).len(), 4);
    }
}
