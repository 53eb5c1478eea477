//! Checks one answer and says what to do next.

use std::{path::Path, process::ExitCode};

use crate::{
    Failure,
    cargo::{self, Messages, Outcome, State},
    exercise::Exercise,
    progress::Progress,
    terminal,
};

/// Check the answer to an exercise. Exit code 0 if it is right, otherwise 1.
pub(crate) fn check(root: &Path, exercises: &[Exercise], exercise: &Exercise) -> Result<ExitCode, Failure> {
    let Outcome { state, printed } = cargo::try_out(root, exercise, &exercise.example(), Messages::Shown)?;
    if !printed.is_empty() {
        terminal::say(&printed);
    }
    if state != State::Done {
        terminal::say(&refusal(exercise, &state));
        return Ok(ExitCode::FAILURE);
    }
    Progress { passed: true, ..Progress::load(root, exercise) }.save(root, exercise)?;
    let next = next(exercises, exercise, |e| Progress::load(root, e).passed);
    terminal::say(&praise(exercise, next, &render(root, exercise)?));
    Ok(ExitCode::SUCCESS)
}

/// Render the picture of an exercise that is done. What to say about it.
fn render(root: &Path, exercise: &Exercise) -> Result<String, Failure> {
    let file = Path::new("pictures/exercises").join(format!("{}.png", exercise.picture()));
    let path = root.join(&file);
    let path = path.to_string_lossy();
    let output = cargo::run(root, exercise, &exercise.example(), &["--no-window", "--quiet", "--output", &path])?;
    Ok(if output.status.success() {
        format!("Its picture:  {}", file.display())
    } else {
        cargo::last_lines("Its picture could not be made", &String::from_utf8_lossy(&output.stderr))
            .trim_end()
            .to_owned()
    })
}

/// The next exercise that is not done: after this one, or else before it.
fn next<'a>(
    exercises: &'a [Exercise],
    exercise: &Exercise,
    is_done: impl Fn(&Exercise) -> bool,
) -> Option<&'a Exercise> {
    let (before, after): (Vec<_>, Vec<_>) = exercises.iter().partition(|e| *e <= exercise);
    after.into_iter().chain(before).find(|e| *e != exercise && !is_done(e))
}

/// What to say when the answer is right.
fn praise(exercise: &Exercise, next: Option<&Exercise>, picture: &str) -> String {
    let next = match next {
        Some(next) => {
            format!("Next:         cargo exercise {}, {}, in {}", next.id(), next.title, next.stub().display())
        }
        None => "This was the last exercise. All done!".into(),
    };
    format!(
        "Well done: {} is right.\n\n{picture}\nIn a window:  {}\nThe solution: cargo exercise {} --solution (open now)\n{next}",
        exercise.name(),
        example(exercise),
        exercise.id()
    )
}

/// What to say when the answer is not right yet.
fn refusal(exercise: &Exercise, state: &State) -> String {
    let (name, id, file) = (exercise.name(), exercise.id(), exercise.stub());
    let file = file.display();
    match state {
        State::Done => String::new(),
        State::NotStarted(message) => format!(
            "{name}: not started.\n\n{message}\n\n\
             Open {file}: the task stands at its top.\n\
             A hint: cargo exercise {id} --hint"
        ),
        State::NotRight { name: mistake, message } => format!(
            "{name}: not right yet. [{mistake}]\n\n{message}\n\n\
             Your file:              {file}\n\
             A hint:                 cargo exercise {id} --hint\n\
             The picture as it is:   {} -- {}",
            example(exercise),
            exercise.picture()
        ),
        State::DoesNotCompile => {
            format!(
                "{name}: does not compile. The compiler says above what it does not understand, the first error first.\n\nYour file: {file}"
            )
        }
    }
}

/// The command that runs the student's program.
fn example(exercise: &Exercise) -> String {
    format!("cargo run -p {} --example {}", exercise.package, exercise.example())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discovery::{all, tests::workspace};

    #[test]
    fn the_next_exercise_is_the_next_that_is_not_done() {
        let stubs = ["1-ball", "2-cube", "3-lid"].map(|name| format!("chapters/01-toy/exercises/{name}.rs"));
        let folder = workspace(&stubs.each_ref().map(|name| (name.as_str(), "")));
        let exercises = all(folder.path()).unwrap();
        let next =
            |done: &[usize]| next(&exercises, &exercises[1], |e| done.contains(&(e.number as usize))).map(|e| e.number);
        assert_eq!(next(&[2]), Some(3));
        assert_eq!(next(&[2, 3]), Some(1));
        assert_eq!(next(&[1, 2, 3]), None);
    }

    #[test]
    fn every_state_says_what_to_do() {
        let folder = workspace(&[("chapters/01-toy/exercises/2-cube.rs", "//! # Exercise 1.2: a cube\n")]);
        let cube = &all(folder.path()).unwrap()[0];
        let wrong = State::NotRight { name: "wrong-sign".into(), message: "Look.".into() };
        let told = refusal(cube, &wrong);
        for expected in [
            "1.2 a cube: not right yet. [wrong-sign]",
            "Look.",
            "exercises/2-cube.rs",
            "1.2 --hint",
            "toy-2-cube -- 1.2-cube",
        ] {
            assert!(told.contains(expected), "{expected} is missing in {told}");
        }
        assert!(refusal(cube, &State::NotStarted("Begin.".into())).contains("task stands at its top"));
        assert!(refusal(cube, &State::DoesNotCompile).contains("compiler"));
        assert!(praise(cube, None, "a picture").ends_with("All done!"));
        assert!(praise(cube, Some(cube), "a picture").contains("cargo exercise 1.2, a cube, in chapters"));
    }
}
