//! Hints in stages: each call opens one more.

use std::path::Path;

use crate::{
    Failure,
    exercise::{Exercise, read},
    progress::Progress,
};

/// The hints of a file, parted by lines `---`.
pub(crate) fn staged(text: &str) -> Vec<String> {
    let mut hints = vec![String::new()];
    for line in text.lines() {
        if line.trim_end() == "---" {
            hints.push(String::new());
        } else if let Some(hint) = hints.last_mut() {
            *hint += line;
            hint.push('\n');
        }
    }
    hints.iter().map(|hint| without_blank_ends(hint)).collect()
}

/// A text without blank lines before and after it. The first line keeps its indent: it may be code.
fn without_blank_ends(text: &str) -> String {
    let lines: Vec<_> = text.trim_end().lines().skip_while(|line| line.trim().is_empty()).collect();
    lines.join("\n")
}

/// Open the next hint: its text; when all are open, that of all of them.
pub(crate) fn open_next(root: &Path, exercise: &Exercise) -> Result<String, Failure> {
    let hints = staged(&read(root, &exercise.hints())?);
    let progress = Progress::load(root, exercise);
    Progress { hints: (progress.hints + 1).min(hints.len()), ..progress }.save(root, exercise)?;
    Ok(shown(&hints, progress.hints, &exercise.id()))
}

/// What to show when `open` hints were open before.
fn shown(hints: &[String], open: usize, id: &str) -> String {
    let count = hints.len();
    let titled =
        |(index, hint): (usize, &String)| format!("Hint {} of {count} for exercise {id}\n\n{hint}\n", index + 1);
    match hints.get(open) {
        Some(hint) => {
            let left = count - open - 1;
            let more = match left {
                0 => "This was the last hint.".into(),
                1 => "One more hint is left: ask again.".into(),
                _ => format!("{left} more hints are left: ask again."),
            };
            format!("{}\n{more}", titled((open, hint)))
        }
        None => {
            let all: Vec<_> = hints.iter().enumerate().map(titled).collect();
            format!(
                "{}\nThere are no more hints. What is left is the solution: cargo exercise {id} --solution",
                all.join("\n")
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discovery::{all, tests::workspace};

    #[test]
    fn hints_are_parted_by_lines_of_three_dashes() {
        assert_eq!(
            staged("One.\n\nStill --- one.\n---\n\nTwo.\n--- \n  Three.\n"),
            ["One.\n\nStill --- one.", "Two.", "  Three."]
        );
        assert_eq!(staged("One.\r\n---\r\nTwo.\r\n"), ["One.", "Two."]);
        assert_eq!(staged("---\n"), ["", ""]);
    }

    #[test]
    fn each_call_opens_one_more() {
        let folder = workspace(&[
            ("chapters/01-toy/exercises/2-cube.rs", ""),
            ("chapters/01-toy/exercises/hints/2-cube.md", "First.\n---\nSecond.\n---\nThird.\n"),
        ]);
        let (root, cube) = (folder.path(), &all(folder.path()).unwrap()[0]);
        for expected in [1, 2, 3, 3] {
            open_next(root, cube).unwrap();
            assert_eq!(Progress::load(root, cube).hints, expected);
        }
    }

    #[test]
    fn what_is_shown_says_how_many_are_left() {
        let hints: Vec<String> = ["First.", "Second.", "Third."].map(String::from).to_vec();
        assert!(shown(&hints, 0, "1.2").starts_with("Hint 1 of 3 for exercise 1.2\n\nFirst.\n"));
        assert!(shown(&hints, 0, "1.2").ends_with("2 more hints are left: ask again."));
        assert!(shown(&hints, 1, "1.2").ends_with("One more hint is left: ask again."));
        assert!(shown(&hints, 2, "1.2").ends_with("last hint."));
        let all = shown(&hints, 3, "1.2");
        assert!(
            all.contains("First.") && all.contains("Third.") && all.ends_with("cargo exercise 1.2 --solution"),
            "{all}"
        );
    }
}
