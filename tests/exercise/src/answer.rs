//! Checks one answer and says what to do next.

use std::{path::Path, process::ExitCode};

use crate::{
    Failure,
    cargo::{self, Messages, Outcome, Run, State},
    crash::{self, Ending},
    exercise::Exercise,
    progress::Progress,
    terminal,
};

/// Check the answer to an exercise. Exit code 0 if it is right and its picture was made, otherwise 1.
pub(crate) fn check(root: &Path, exercises: &[Exercise], exercise: &Exercise) -> Result<ExitCode, Failure> {
    let Outcome { state, printed, lines } = cargo::try_out(root, exercise, &exercise.example(), Messages::Shown)?;
    if !printed.is_empty() {
        terminal::say(&printed);
    }
    if state != State::Done {
        terminal::say(&refusal(exercise, &state));
        return Ok(ExitCode::FAILURE);
    }
    Progress { passed: true, ..Progress::load(root, exercise) }.save(root, exercise)?;
    // Say so before the picture is made: that may take a while.
    terminal::say(&praise(exercise, lines));
    let next = next(exercises, exercise, |e| Progress::load(root, e).passed);
    let drawn = render(root, exercise)?;
    terminal::say(&farewell(exercise, next, &drawn));
    Ok(if drawn.picture.is_ok() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// What has become of the picture of an exercise that is done.
struct Drawn {
    /// Where it is, or why it could not be made.
    picture: Result<String, String>,
    /// How many lines were printed meanwhile.
    lines: usize,
}

/// Render the picture of an exercise that is done.
fn render(root: &Path, exercise: &Exercise) -> Result<Drawn, Failure> {
    let file = Path::new("pictures/exercises").join(format!("{}.png", exercise.picture()));
    let path = root.join(&file);
    let path = path.to_string_lossy();
    let Run { stdout, stderr, status } =
        cargo::run(root, exercise, &exercise.example(), &["--no-window", "--quiet", "--output", &path])?;
    // What it says of its failure is no print of the student's.
    let lines = stdout.lines() + if status.success() { stderr.lines() } else { 0 };
    let end = Ending { code: status.code(), words: &status.to_string(), written: &stderr.end };
    let why = || failure(end, &stderr.last_lines("It wrote on standard error"));
    Ok(Drawn { picture: if status.success() { Ok(file.display().to_string()) } else { Err(why()) }, lines })
}

/// Why a picture could not be made. `said` are the last lines of its program.
fn failure(end: Ending<'_>, said: &str) -> String {
    // A picture that differs everywhere panics in every pixel; the first places tell all.
    const PANICS: usize = 3;
    // So a program ends that has said by itself what was wrong.
    const SAID: [Option<i32>; 2] = [Some(1), Some(2)];
    let panics = crash::panics(end.written);
    if !panics.is_empty() {
        let panics: Vec<_> = panics.iter().take(PANICS).map(|panic| format!("There was a panic at {panic}")).collect();
        return panics.join("\n") + "\n\nThe picture asks your code for more than the check does.";
    }
    if SAID.contains(&end.code) && !said.is_empty() {
        return said.trim_end().to_owned();
    }
    format!("{}\n\n{said}", end.cause()).trim_end().to_owned()
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

/// What to say when the answer is right. `lines` were printed by it while it was checked.
fn praise(exercise: &Exercise, lines: usize) -> String {
    let prints = match lines {
        0 => String::new(),
        _ => format!(
            " Your code printed while it was checked ({lines} lines). A picture asks it far more often: take the prints \
             away, or you will wait long."
        ),
    };
    format!("Well done: {} is right.\n\nIts picture is being made.{prints}", exercise.name())
}

/// What to say after the picture was made, or could not be made.
fn farewell(exercise: &Exercise, next: Option<&Exercise>, drawn: &Drawn) -> String {
    // So many lines are not read by anybody.
    const MANY: usize = 1000;
    let lines = drawn.lines;
    let slow = if lines > MANY {
        format!("Your code printed {lines} lines, which slows it down: take the prints away.\n\n")
    } else {
        String::new()
    };
    let next = match next {
        Some(next) => {
            format!("Next:         cargo exercise {}, {}, in {}", next.id(), next.title, next.stub().display())
        }
        None => "This was the last exercise. All done!".into(),
    };
    let picture = match &drawn.picture {
        Ok(file) => format!("Its picture:  {file}"),
        Err(why) => {
            format!(
                "The check accepts your answer, but its picture could not be made.\n\n{why}\n\nYour file:    {}",
                exercise.stub().display()
            )
        }
    };
    format!(
        "{slow}{picture}\nIn a window:  {}\nThe solution: cargo exercise {} --solution (open now)\n{next}",
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
        let drawn = Drawn { picture: Ok("a.png".into()), lines: 0 };
        assert_eq!(praise(cube, 0), "Well done: 1.2 a cube is right.\n\nIts picture is being made.");
        let told = farewell(cube, None, &drawn);
        assert!(told.starts_with("Its picture:  a.png") && told.ends_with("All done!"), "{told}");
        assert!(farewell(cube, Some(cube), &drawn).contains("cargo exercise 1.2, a cube, in chapters"));
    }

    #[test]
    fn many_prints_are_told_in_one_line() {
        let folder = workspace(&[("chapters/01-toy/exercises/2-cube.rs", "")]);
        let cube = &all(folder.path()).unwrap()[0];
        let drawn = |lines| Drawn { picture: Ok("a.png".into()), lines };
        assert!(!farewell(cube, None, &drawn(900)).contains("prints"));
        assert!(farewell(cube, None, &drawn(1100)).contains("Your code printed 1100 lines, which slows it down"));
        // Before the picture a single line is told: the picture multiplies it.
        assert!(praise(cube, 1).contains("take the prints away"));
    }

    #[test]
    fn a_picture_that_fails_shows_the_panic_first() {
        let folder = workspace(&[("chapters/01-toy/exercises/2-cube.rs", "")]);
        let cube = &all(folder.path()).unwrap()[0];
        let written =
            "\nthread 'a' (1) panicked at cube.rs:3:4:\nno lid\n\nthread 'b' (2) panicked at cube.rs:3:4:\nno lid\n";
        let end = Ending { code: Some(101), words: "exit status: 101", written };
        let why = failure(end, written);
        assert!(why.starts_with("There was a panic at cube.rs:3:4:\n  no lid\n\nThe picture"), "{why}");
        let told = farewell(cube, None, &Drawn { picture: Err(why), lines: 4 });
        assert!(told.contains("could not be made.\n\nThere was a panic"), "{told}");

        let full = "thread 'a' (1) has overflowed its stack\n";
        let why = failure(Ending { code: None, words: "signal: 6", written: full }, full);
        assert!(why.starts_with("The stack is used up"), "{why}");
        let said = "error: cannot write a.png\n";
        assert_eq!(failure(Ending { code: Some(1), words: "exit status: 1", written: said }, said), said.trim_end());
    }
}
