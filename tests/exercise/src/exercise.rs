//! An exercise by its files.

use std::{
    fs,
    path::{Path, PathBuf},
};

use crate::Failure;

/// An exercise of a chapter.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Exercise {
    /// Number of the chapter.
    pub(crate) chapter: u32,
    /// Number within the chapter.
    pub(crate) number: u32,
    /// Its name in file names.
    pub(crate) slug: String,
    /// Folder of the chapter, relative to the root: `chapters/01-ray-casting`.
    pub(crate) folder: PathBuf,
    /// Name of the chapter's package: `ray-casting`.
    pub(crate) package: String,
    /// Name for people, from the first line of the stub.
    pub(crate) title: String,
}

impl Exercise {
    /// Its number in the course: `1.2`.
    pub(crate) fn id(&self) -> String {
        format!("{}.{}", self.chapter, self.number)
    }

    /// Number and title.
    pub(crate) fn name(&self) -> String {
        format!("{} {}", self.id(), self.title)
    }

    /// The file that the student writes in, relative to the root, like all these files.
    pub(crate) fn stub(&self) -> PathBuf {
        self.folder.join("exercises").join(format!("{}-{}.rs", self.number, self.slug))
    }

    /// The solution.
    pub(crate) fn solution(&self) -> PathBuf {
        self.folder.join("solutions").join(format!("{}-{}.rs", self.number, self.slug))
    }

    /// The hints.
    pub(crate) fn hints(&self) -> PathBuf {
        self.folder.join("exercises/hints").join(format!("{}-{}.md", self.number, self.slug))
    }

    /// Name of the stub's example.
    pub(crate) fn example(&self) -> String {
        format!("{}-{}-{}", self.package, self.number, self.slug)
    }

    /// Name of the solution's example.
    pub(crate) fn solution_example(&self) -> String {
        format!("{}-solution", self.example())
    }

    /// Name of its picture.
    pub(crate) fn picture(&self) -> String {
        format!("{}-{}", self.id(), self.slug)
    }
}

/// The text of a file, named relative to the root.
pub(crate) fn read(root: &Path, file: &Path) -> Result<String, Failure> {
    fs::read_to_string(root.join(file)).map_err(|e| Failure::system(format!("cannot read {}: {e}", file.display())))
}
