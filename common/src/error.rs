//! What can go wrong, each in one line: what, where, and what would be right.

use std::path::PathBuf;

use crate::{film::Size, obj::ObjError};

/// An error that a user can cause and mend.
#[derive(Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// A knob was given a value outside its range.
    #[error("knob '{knob}' cannot be '{given}': it takes {range}")]
    KnobValue {
        /// Name of the knob.
        knob: &'static str,
        /// What was typed.
        given: String,
        /// What would be right.
        range: String,
    },
    /// The picture cannot be made of what it was given.
    #[error("the picture cannot be made: {0}")]
    Picture(String),
    /// The report cannot be made of what it was given.
    #[error("the report cannot be made: {0}")]
    Report(String),
    /// A mesh file could not be used.
    #[error("{file}: {error}")]
    Obj {
        /// The file as the user named it.
        file: String,
        /// What is wrong inside.
        error: ObjError,
    },
    /// A size that no film can have.
    #[error("size {width}x{height} is impossible: each side takes 1 to {} pixels, both together at most {} million", Size::MAX_SIDE, Size::MAX_PIXELS / 1_000_000)]
    Size {
        /// Width in pixels.
        width: u64,
        /// Height in pixels.
        height: u64,
    },
    /// An output file whose name does not say what it is.
    #[error("cannot tell what kind of file '{}' should be: the name must end in .png or .exr", .0.display())]
    Extension(PathBuf),
    /// A file that a rendering cannot go on from.
    #[error("cannot go on from {file}: {reason}")]
    State {
        /// The file as the user named it.
        file: String,
        /// What is wrong with it.
        reason: String,
    },
    /// An output that could not be written.
    #[error("cannot write {name}: {reason}")]
    Write {
        /// The file as the user named it.
        name: String,
        /// What the system said.
        reason: String,
    },
    /// An input that could not be read.
    #[error("cannot read {name}: {reason}")]
    Read {
        /// The file as the user named it.
        name: String,
        /// What the system said.
        reason: String,
    },
    /// Whoever read our output has stopped reading. Not worth a message.
    #[error("the reader of the output has gone")]
    ClosedPipe,
}

/// What the system said, without its error number.
pub(crate) fn reason(error: &std::io::Error) -> String {
    let text = error.to_string();
    text.split(" (os error").next().unwrap_or(&text).to_lowercase()
}
