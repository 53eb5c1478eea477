//! All exercises and how far they are.

use std::path::Path;

use crate::{
    Failure,
    cargo::{Messages, State, build, check},
    exercise::Exercise,
    progress::Progress,
    reset::is_untouched,
};

/// Check all exercises: the list of them.
pub(crate) fn show(root: &Path, exercises: &[Exercise]) -> Result<String, Failure> {
    let states = states(root, exercises)?;
    for (exercise, state) in exercises.iter().zip(&states) {
        if *state == State::Done {
            Progress { passed: true, ..Progress::load(root, exercise) }.save(root, exercise)?;
        }
    }
    Ok(text(exercises, &states))
}

/// The state of each. What nobody has touched is not built, so that the first list comes at once.
fn states(root: &Path, exercises: &[Exercise]) -> Result<Vec<State>, Failure> {
    let touched: Vec<_> = exercises.iter().filter(|exercise| !is_untouched(root, exercise)).collect();
    // Build what belongs together at once: on many cores that is faster.
    for chapter in touched.chunk_by(|a, b| a.package == b.package) {
        let examples: Vec<_> = chapter.iter().map(|exercise| exercise.example()).collect();
        build(root, &chapter[0].package, &examples, Messages::Hidden)?;
    }
    let state = |exercise| match touched.contains(&exercise) {
        true => check(root, exercise, &exercise.example(), Messages::Hidden),
        false => Ok(State::NotStarted(String::new())),
    };
    exercises.iter().map(state).collect()
}

/// The list, and what to do next.
fn text(exercises: &[Exercise], states: &[State]) -> String {
    let mut text = String::new();
    let mut package = "";
    for (exercise, state) in exercises.iter().zip(states) {
        if package != exercise.package {
            package = &exercise.package;
            text += &format!("Chapter {}, {package}\n", exercise.chapter);
        }
        let name = if let State::NotRight { name, .. } = state { format!("  [{name}]") } else { String::new() };
        text += &format!("  {:<5} {:<17} {}{name}\n", exercise.id(), state.words(), exercise.title);
    }
    // What was begun comes before what was not.
    let next = |wanted: fn(&State) -> bool| exercises.iter().zip(states).find(|(_, state)| wanted(state));
    let next = next(|s| !matches!(s, State::Done | State::NotStarted(_))).or_else(|| next(|s| *s != State::Done));
    let next = match next {
        Some((exercise, _)) => format!("Next: cargo exercise {}, in {}", exercise.id(), exercise.stub().display()),
        None if exercises.is_empty() => "There are no exercises.".into(),
        None => "All done.".into(),
    };
    format!("{text}\n{next}").trim_start().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discovery::{all, tests::workspace};

    #[test]
    fn what_nobody_has_touched_is_listed_without_building() {
        let stub = "//! # Exercise 1.2: a cube\nnone\n";
        let solution = "//! # Exercise 1.2: a cube\n// STUB: none\nsome\n// END STUB\n";
        let folder = workspace(&[
            ("chapters/01-toy/exercises/2-cube.rs", stub),
            ("chapters/01-toy/solutions/2-cube.rs", solution),
        ]);
        // There is no package here that could be built.
        let states = states(folder.path(), &all(folder.path()).unwrap()).unwrap();
        assert_eq!(states, [State::NotStarted(String::new())]);
        assert!(!folder.path().join("target").exists());
    }

    #[test]
    fn what_was_begun_comes_next() {
        let folder = workspace(&[
            ("chapters/01-toy/exercises/1-ball.rs", "//! # Exercise 1.1: a ball\n"),
            ("chapters/01-toy/exercises/2-cube.rs", "//! # Exercise 1.2: a cube\n"),
            ("chapters/02-box/exercises/1-lid.rs", "//! # Exercise 2.1: a lid\n"),
        ]);
        let exercises = all(folder.path()).unwrap();
        let fresh = || State::NotStarted("Begin.".into());
        let wrong = State::NotRight { name: "wrong-sign".into(), message: "No.".into() };
        let listed = text(&exercises, &[fresh(), wrong, State::DoesNotCompile]);
        let expected = "\
Chapter 1, toy
  1.1   not started       a ball
  1.2   not right yet     a cube  [wrong-sign]
Chapter 2, box
  2.1   does not compile  a lid

Next: cargo exercise 1.2, in chapters/01-toy/exercises/2-cube.rs";
        assert_eq!(listed, expected);
        let next = |states: [State; 3]| text(&exercises, &states).lines().last().unwrap().to_owned();
        assert!(next([State::Done, fresh(), fresh()]).contains("exercise 1.2,"));
        assert_eq!(next([State::Done, State::Done, State::Done]), "All done.");
        assert_eq!(text(&[], &[]), "There are no exercises.");
    }
}
