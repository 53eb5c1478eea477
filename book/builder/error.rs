//! What can be wrong with the book, and where.

use std::{fmt, io, path::PathBuf, sync::Arc};

use thiserror::Error;

/// A line of a text file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// The file, relative to the root of the workspace.
    pub file: Arc<str>,
    /// The line, from 1.
    pub line: usize,
}

impl Place {
    /// A line of a file.
    #[must_use]
    pub fn new(file: &Arc<str>, line: usize) -> Self {
        Self { file: Arc::clone(file), line }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.file, self.line)
    }
}

/// A mistake in the text of the book, in one line: where, what, and what would be right.
#[derive(Clone, Debug, Error, PartialEq, Eq, PartialOrd, Ord)]
#[error("{place}: {what}")]
pub struct Mistake {
    /// Where it is.
    pub place: Place,
    /// What it is, and what would be right.
    pub what: String,
}

/// Why the book could not be built.
#[derive(Debug, Error)]
pub enum BookError {
    /// Mistakes in the text: all that were found.
    #[error("{}", one_a_line(.0))]
    Mistakes(Vec<Mistake>),
    /// What mdBook only warns of.
    #[error("{}", one_a_line(.0))]
    Warnings(Vec<String>),
    /// mdBook did not succeed.
    #[error("mdBook: {0}")]
    MdBook(String),
    /// A file could not be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// The place for the book holds something else.
    #[error("{}: this folder holds something that is no book, and is left alone: choose another", .0.display())]
    NotABook(PathBuf),
}

impl BookError {
    /// The reason that a file could not be read or written.
    pub(crate) fn file(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |source| Self::File { path, source }
    }
}

/// Several things, each on its line.
fn one_a_line<T: ToString>(all: &[T]) -> String {
    all.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}
