//! Brings a stub back, and keeps what stood in its place.

use std::{
    fs::{self, OpenOptions},
    io::{self, Write as _},
    path::{Path, PathBuf},
};

use crate::{
    Failure,
    exercise::{Exercise, read},
    progress::Progress,
    stub::stub_of,
};

/// Start an exercise again: the stub, all hints closed, nothing remembered. What to say about it.
pub(crate) fn run(root: &Path, exercise: &Exercise) -> Result<String, Failure> {
    let (id, stub) = (exercise.id(), exercise.stub());
    let kept = reset(root, exercise)?;
    Progress::default().save(root, exercise)?;
    Ok(match kept {
        Reset::Untouched => format!("{} is as it was delivered.", stub.display()),
        Reset::Made => format!("{} was missing, and is there again.", stub.display()),
        Reset::Kept(kept) => {
            format!("Exercise {id} starts again: {}\nWhat you wrote is kept in {}", stub.display(), kept.display())
        }
    })
}

/// What became of the student's version.
#[derive(Debug, PartialEq, Eq)]
enum Reset {
    /// There was none: the stub is as it was delivered.
    Untouched,
    /// There was no file.
    Made,
    /// It is kept in this file, relative to the root.
    Kept(PathBuf),
}

/// Whether the stub is as it was delivered. Its lines count: another tool may have changed how they end.
pub(crate) fn is_untouched(root: &Path, exercise: &Exercise) -> bool {
    let (written, delivered) = (read(root, &exercise.stub()), delivered(root, exercise));
    written.is_ok_and(|written| delivered.is_ok_and(|delivered| written.lines().eq(delivered.lines())))
}

/// The text of the stub, made of the solution.
fn delivered(root: &Path, exercise: &Exercise) -> Result<String, Failure> {
    let solution = exercise.solution();
    stub_of(&read(root, &solution)?)
        .map_err(|what| Failure::system(format!("{} is damaged: {what}", solution.display())))
}

/// Put the stub back.
fn reset(root: &Path, exercise: &Exercise) -> Result<Reset, Failure> {
    let delivered = delivered(root, exercise)?;
    let stub = exercise.stub();
    // Whatever bytes there are, also if they are no text. There may be no file at all.
    let kept = match fs::read(root.join(&stub)) {
        Ok(written) if written == delivered.as_bytes() => return Ok(Reset::Untouched),
        Ok(written) => Reset::Kept(keep(root, exercise, &written)?),
        Err(e) if e.kind() == io::ErrorKind::NotFound => Reset::Made,
        Err(e) => return Err(failed("read", &stub, &e)),
    };
    // Write beside the place and rename, so that there is always one whole file.
    let neighbor = root.join(&stub).with_extension("rs.part");
    fs::write(&neighbor, delivered).and_then(|()| fs::rename(&neighbor, root.join(&stub))).map_err(|e| {
        // The first error is the one to tell.
        let _ = fs::remove_file(&neighbor);
        failed("write", &stub, &e)
    })?;
    Ok(kept)
}

/// Store the student's version under a name that is not taken.
fn keep(root: &Path, exercise: &Exercise, written: &[u8]) -> Result<PathBuf, Failure> {
    let folder = exercise.folder.join("exercises/kept");
    let ignore = folder.join(".gitignore");
    // Kept files are the student's own matter, not the course's.
    fs::create_dir_all(root.join(&folder))
        .and_then(|()| fs::write(root.join(&ignore), "*\n"))
        .map_err(|e| failed("write", &ignore, &e))?;
    let mut version = 1_u32;
    loop {
        let kept = folder.join(format!("{}-{}.{version}.rs", exercise.number, exercise.slug));
        // Fails if the file is there: nothing is ever written over.
        let stored = OpenOptions::new().write(true).create_new(true).open(root.join(&kept));
        match stored.and_then(|mut file| file.write_all(written).and_then(|()| file.sync_all())) {
            Ok(()) => return Ok(kept),
            Err(e) if e.kind() == io::ErrorKind::AlreadyExists => version += 1,
            Err(e) => return Err(failed("write", &kept, &e)),
        }
    }
}

fn failed(what: &str, file: &Path, error: &io::Error) -> Failure {
    Failure::system(format!("cannot {what} {}: {error}", file.display()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discovery::{all, tests::workspace};

    const SOLUTION: &str = "//! # Exercise 1.2: a cube\n// STUB: none\nsome\n// END STUB\n";
    const STUB: &str = "//! # Exercise 1.2: a cube\nnone\n";

    fn toy() -> (tempfile::TempDir, Exercise) {
        let folder = workspace(&[
            ("chapters/01-toy/exercises/2-cube.rs", STUB),
            ("chapters/01-toy/solutions/2-cube.rs", SOLUTION),
        ]);
        let cube = all(folder.path()).unwrap().remove(0);
        (folder, cube)
    }

    #[test]
    fn every_version_is_kept() {
        let (folder, cube) = toy();
        let root = folder.path();
        assert_eq!(reset(root, &cube).unwrap(), Reset::Untouched);
        for (number, text) in [(1, "first"), (2, "second")] {
            fs::write(root.join(cube.stub()), text).unwrap();
            let kept = PathBuf::from(format!("chapters/01-toy/exercises/kept/2-cube.{number}.rs"));
            assert_eq!(reset(root, &cube).unwrap(), Reset::Kept(kept.clone()));
            assert_eq!(fs::read_to_string(root.join(kept)).unwrap(), text);
            assert_eq!(fs::read_to_string(root.join(cube.stub())).unwrap(), STUB);
        }
        assert_eq!(fs::read(root.join("chapters/01-toy/exercises/kept/2-cube.1.rs")).unwrap(), b"first");
        // A kept version is no exercise.
        assert_eq!(all(root).unwrap().len(), 1);
    }

    #[test]
    fn a_stub_is_untouched_until_a_line_is_changed() {
        let (folder, cube) = toy();
        let root = folder.path();
        assert!(is_untouched(root, &cube));
        fs::write(root.join(cube.stub()), STUB.replace('\n', "\r\n")).unwrap();
        assert!(is_untouched(root, &cube));
        fs::write(root.join(cube.stub()), STUB.replace("none", "mine")).unwrap();
        assert!(!is_untouched(root, &cube));
        fs::remove_file(root.join(cube.stub())).unwrap();
        assert!(!is_untouched(root, &cube));
    }

    #[test]
    fn bytes_that_are_no_text_are_kept_too() {
        let (folder, cube) = toy();
        fs::write(folder.path().join(cube.stub()), [0xff, 0xfe]).unwrap();
        let Reset::Kept(kept) = reset(folder.path(), &cube).unwrap() else { panic!("nothing is kept") };
        assert_eq!(fs::read(folder.path().join(kept)).unwrap(), [0xff, 0xfe]);
    }

    #[test]
    fn a_missing_stub_is_made() {
        let (folder, cube) = toy();
        fs::remove_file(folder.path().join(cube.stub())).unwrap();
        assert_eq!(all(folder.path()).unwrap().first(), Some(&cube));
        assert_eq!(reset(folder.path(), &cube).unwrap(), Reset::Made);
        assert_eq!(fs::read_to_string(folder.path().join(cube.stub())).unwrap(), STUB);
    }

    #[test]
    fn a_damaged_solution_changes_nothing() {
        let (folder, cube) = toy();
        let root = folder.path();
        fs::write(root.join(cube.solution()), "// STUB: none\n").unwrap();
        fs::write(root.join(cube.stub()), "mine").unwrap();
        assert!(reset(root, &cube).unwrap_err().message.contains("damaged"));
        assert_eq!(fs::read_to_string(root.join(cube.stub())).unwrap(), "mine");
    }

    #[test]
    fn everything_is_forgotten() {
        let (folder, cube) = toy();
        Progress { hints: 2, asked_for_solution: true, passed: true }.save(folder.path(), &cube).unwrap();
        run(folder.path(), &cube).unwrap();
        assert_eq!(Progress::load(folder.path(), &cube), Progress::default());
    }
}
