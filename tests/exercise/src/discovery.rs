//! Finds the workspace and its exercises.

use std::{
    collections::BTreeSet,
    env, fs,
    path::{Path, PathBuf},
};

use crate::{
    Failure,
    exercise::{Exercise, read},
};

/// The folder of the workspace.
pub(crate) fn root() -> Result<PathBuf, Failure> {
    // Cargo says where this package is when it runs it. Started by hand, the program is where it was built.
    let package = env::var_os("CARGO_MANIFEST_DIR").map_or_else(|| env!("CARGO_MANIFEST_DIR").into(), PathBuf::from);
    let root = package.ancestors().find(|folder| folder.join("chapters").is_dir());
    root.map(Path::to_path_buf).ok_or_else(|| Failure::system(format!("no chapters above {}", package.display())))
}

/// All exercises of all chapters, in order.
pub(crate) fn all(root: &Path) -> Result<Vec<Exercise>, Failure> {
    let mut exercises = Vec::new();
    for chapter in names_in(&root.join("chapters")) {
        let Some((number, package)) = numbered(&chapter) else { continue };
        let folder = Path::new("chapters").join(&chapter);
        // A stub may be missing: it can be made of the solution.
        let places = ["exercises", "solutions"].map(|place| root.join(&folder).join(place));
        let files: BTreeSet<_> = places.iter().flat_map(|place| names_in(place)).collect();
        for file in files {
            let Some((number_in_chapter, slug)) = file.strip_suffix(".rs").and_then(numbered) else { continue };
            let mut exercise = Exercise {
                chapter: number,
                number: number_in_chapter,
                slug: slug.into(),
                folder: folder.clone(),
                package: package.into(),
                title: String::new(),
            };
            let text = read(root, &exercise.stub()).or_else(|_| read(root, &exercise.solution()))?;
            exercise.title = title(&text).unwrap_or(slug).into();
            exercises.push(exercise);
        }
    }
    exercises.sort();
    Ok(exercises)
}

/// The exercise of that number or name.
pub(crate) fn named<'a>(exercises: &'a [Exercise], name: &str) -> Result<&'a Exercise, Failure> {
    exercises.iter().find(|e| e.id() == name || e.slug == name || e.picture() == name).ok_or_else(|| {
        let known: Vec<_> = exercises.iter().map(Exercise::name).collect();
        Failure::usage(format!("there is no exercise '{name}'; there are: {}", known.join(", ")))
    })
}

/// The names of the files and folders in a folder, sorted; none if there is no such folder.
pub(crate) fn names_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<_> = entries.filter_map(|entry| entry.file_name().into_string().ok()).collect();
    names.sort();
    names
}

/// A number and what stands behind the dash: `01-ray-casting`.
fn numbered(name: &str) -> Option<(u32, &str)> {
    let (number, rest) = name.split_once('-')?;
    Some((number.parse().ok()?, rest)).filter(|(_, rest)| !rest.is_empty() && !rest.contains('.'))
}

/// The title in the first line: `//! # Exercise 1.2: a capped cylinder`.
fn title(text: &str) -> Option<&str> {
    let (_, title) = text.lines().next()?.strip_prefix("//! # Exercise ")?.split_once(": ")?;
    Some(title.trim()).filter(|title| !title.is_empty())
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A workspace with files of these names and texts.
    pub(crate) fn workspace(files: &[(&str, &str)]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in files {
            let path = folder.path().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        folder
    }

    #[test]
    fn exercises_are_found_in_order_and_nothing_else_is() {
        let folder = workspace(&[
            ("chapters/01-toy/exercises/2-cube.rs", "//! # Exercise 1.2: a cube\n"),
            ("chapters/01-toy/exercises/10-ball.rs", "fn main() {}"),
            ("chapters/01-toy/exercises/checks/2-cube.rs", ""),
            ("chapters/01-toy/exercises/kept/2-cube.1.rs", ""),
            ("chapters/01-toy/exercises/3-notes.txt", ""),
            ("chapters/01-toy/exercises/mine.rs", ""),
            ("chapters/02-box/exercises/1-lid.rs", "//! # Exercise 2.1: a lid\n"),
            ("chapters/02-box/solutions/1-lid.rs", "//! # Exercise 2.1: a solution\n"),
            ("chapters/02-box/solutions/2-latch.rs", "//! # Exercise 2.2: a latch\n"),
            ("chapters/03-none/src/lib.rs", ""),
            ("chapters/README.md", ""),
        ]);
        let exercises = all(folder.path()).unwrap();
        let names: Vec<_> = exercises.iter().map(Exercise::name).collect();
        assert_eq!(names, ["1.2 a cube", "1.10 ball", "2.1 a lid", "2.2 a latch"]);
        let cube = &exercises[0];
        assert_eq!(cube.example(), "toy-2-cube");
        assert_eq!(cube.solution(), Path::new("chapters/01-toy/solutions/2-cube.rs"));
        assert_eq!(cube.hints(), Path::new("chapters/01-toy/exercises/hints/2-cube.md"));
    }

    #[test]
    fn an_exercise_goes_by_number_or_name() {
        let folder = workspace(&[("chapters/01-toy/exercises/2-cube.rs", "//! # Exercise 1.2: a cube\n")]);
        let exercises = all(folder.path()).unwrap();
        for name in ["1.2", "cube", "1.2-cube"] {
            assert_eq!(named(&exercises, name).unwrap().number, 2);
        }
        let message = named(&exercises, "1.3").unwrap_err().message;
        assert_eq!(message, "there is no exercise '1.3'; there are: 1.2 a cube");
    }

    #[test]
    fn this_workspace_is_found() {
        assert!(root().unwrap().join("Cargo.toml").is_file());
    }
}
