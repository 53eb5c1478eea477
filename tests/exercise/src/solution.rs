//! Shows a solution: at once when the answer is right, otherwise when asked twice.

use std::path::Path;

use crate::{
    Failure,
    cargo::{Messages, State, check},
    exercise::{Exercise, read},
    progress::Progress,
    stub,
};

/// How the line begins behind which nothing is the student's.
const MACHINERY: &str = "// From here on";

/// The solution, or the question whether it is really wanted.
pub(crate) fn show(root: &Path, exercise: &Exercise) -> Result<String, Failure> {
    let progress = Progress::load(root, exercise);
    let is_open = progress.passed || progress.asked_for_solution || is_right(root, exercise)?;
    if is_open {
        return text(root, exercise);
    }
    Progress { asked_for_solution: true, ..progress }.save(root, exercise)?;
    Ok(question(exercise))
}

fn is_right(root: &Path, exercise: &Exercise) -> Result<bool, Failure> {
    Ok(check(root, exercise, &exercise.example(), Messages::Hidden)? == State::Done)
}

fn question(exercise: &Exercise) -> String {
    let id = exercise.id();
    format!(
        "Your answer to {id} is not right yet. Do you really want to see the solution? Then ask again.\n\n\
         A hint gives away less: cargo exercise {id} --hint"
    )
}

/// The solution from the student's own part on: the task above it and the machinery below are known.
fn text(root: &Path, exercise: &Exercise) -> Result<String, Failure> {
    let file = exercise.solution();
    let code = stub::without_marks(&read(root, &file)?);
    let own = code.lines().skip_while(|line| line.starts_with("//!")).take_while(|line| !line.starts_with(MACHINERY));
    let own: Vec<_> = own.collect();
    Ok(format!("// {}\n{}", file.display(), own.join("\n").trim_end()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discovery::{all, tests::workspace};

    #[test]
    fn before_the_answer_is_right_it_must_be_asked_for_twice() {
        let folder = workspace(&[
            ("chapters/01-toy/exercises/2-cube.rs", "fn main() {}"),
            (
                "chapters/01-toy/solutions/2-cube.rs",
                "//! # Task\n\nfn main() {\n    // STUB:\n    cube();\n    // END STUB\n}\n\n// From here on it is tested.\nmod check;\n",
            ),
        ]);
        let (root, cube) = (folder.path(), &all(folder.path()).unwrap()[0]);
        let asked = Progress { asked_for_solution: true, ..Progress::default() };
        asked.save(root, cube).unwrap();
        let text = show(root, cube).unwrap();
        assert_eq!(Progress::load(root, cube), asked);
        assert!(text.ends_with("2-cube.rs\n\nfn main() {\n    cube();\n}"), "{text}");
        assert!(question(cube).contains("ask again") && question(cube).contains("1.2 --hint"));
    }
}
