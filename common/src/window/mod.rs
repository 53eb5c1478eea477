//! The window.

use crate::{
    cli::{Request, Target},
    error::Error,
    picture::Chapter,
};

/// Why no picture was shown.
pub(crate) enum Failed {
    /// There is no display.
    NoDisplay,
    /// The picture could not be made or saved.
    Picture(Error),
}

/// Show the picture.
pub(crate) fn show(_chapter: &Chapter, _request: &Request, _target: &Target) -> Result<(), Failed> {
    Err(Failed::NoDisplay)
}
