//! What is remembered of an exercise: in `target/exercises`, so that `cargo clean` forgets it.

use std::{
    fs,
    path::{Path, PathBuf},
};

use crate::{Failure, exercise::Exercise};

/// What a student has seen and done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Progress {
    /// How many hints are open.
    pub(crate) hints: usize,
    /// Whether the solution was asked for before the answer was right.
    pub(crate) asked_for_solution: bool,
    /// Whether the answer was right once.
    pub(crate) passed: bool,
}

impl Progress {
    /// What is remembered; nothing if there is no file, or one that cannot be read.
    pub(crate) fn load(root: &Path, exercise: &Exercise) -> Self {
        let mut progress = Self::default();
        for line in fs::read_to_string(file(root, exercise)).unwrap_or_default().lines() {
            match line.split_once(' ').unwrap_or((line, "")) {
                ("hints", count) => progress.hints = count.parse().unwrap_or(0),
                ("asked-for-solution", _) => progress.asked_for_solution = true,
                ("passed", _) => progress.passed = true,
                _ => {}
            }
        }
        progress
    }

    /// Remember it.
    pub(crate) fn save(&self, root: &Path, exercise: &Exercise) -> Result<(), Failure> {
        let mut text = format!("hints {}\n", self.hints);
        for (is_so, line) in [(self.asked_for_solution, "asked-for-solution\n"), (self.passed, "passed\n")] {
            text += if is_so { line } else { "" };
        }
        begin(root)?;
        let file = file(root, exercise);
        fs::write(&file, text).map_err(|e| Failure::system(format!("cannot write {}: {e}", file.display())))
    }
}

/// Whether nothing was ever remembered.
pub(crate) fn is_new(root: &Path) -> bool {
    !folder(root).exists()
}

/// Make the place where things are remembered.
pub(crate) fn begin(root: &Path) -> Result<(), Failure> {
    let folder = folder(root);
    fs::create_dir_all(&folder).map_err(|e| Failure::system(format!("cannot make {}: {e}", folder.display())))
}

fn folder(root: &Path) -> PathBuf {
    root.join("target/exercises")
}

fn file(root: &Path, exercise: &Exercise) -> PathBuf {
    folder(root).join(format!("{}.txt", exercise.picture()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discovery::{all, tests::workspace};

    #[test]
    fn what_was_saved_is_loaded_and_rubbish_is_nothing() {
        let folder = workspace(&[("chapters/01-toy/exercises/2-cube.rs", "")]);
        let (root, cube) = (folder.path(), &all(folder.path()).unwrap()[0]);
        assert!(is_new(root));
        assert_eq!(Progress::load(root, cube), Progress::default());
        let some = Progress { hints: 2, asked_for_solution: true, passed: false };
        some.save(root, cube).unwrap();
        assert_eq!(Progress::load(root, cube), some);
        assert!(!is_new(root));
        fs::write(file(root, cube), "hints many\n\u{0}\n").unwrap();
        assert_eq!(Progress::load(root, cube), Progress::default());
    }
}
