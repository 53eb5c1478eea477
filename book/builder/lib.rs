//! Builds the book: mdBook does the pages, and this crate does what must never differ from the code.
//!
//! Authors write Markdown in `book/src`, with directives such as `{{#listing …}}` that show compiled source, pinned
//! pictures, pinned numbers, exercises and diagrams. A directive that cannot be done fails the build, with one line
//! that says where, what, and what would be right.
//!
//! [`build()`] writes the book; [`check()`] looks at what was written, and at what was left out.

mod anchor;
mod check;
mod crates;
mod diagram;
mod directive;
mod error;
mod exercise;
mod expand;
mod figure;
#[cfg(test)]
mod fixture;
mod graph;
mod house;
mod html;
mod knows;
mod layout;
mod links;
mod listing;
mod live;
mod math;
mod number;
mod output;
mod render;
pub mod serve;
#[cfg(test)]
mod tests;
mod tokens;
mod warnings;
mod watch;

use std::path::Path;

pub use crate::error::{BookError, Mistake, Place};
use crate::house::House;

/// Build the book of the workspace in `root` into the folder `out`, which is replaced as a whole or not at all.
///
/// # Errors
/// [`BookError`], with all mistakes in the text that were found.
pub fn build(root: &Path, out: &Path) -> Result<(), BookError> {
    render::build(&House::new(root, course::CHAPTERS), out)
}

/// What the book of the workspace in `root` lacks although nothing is wrong with it, in one line; `None` if nothing.
#[must_use]
pub fn note(root: &Path) -> Option<String> {
    live::note(&House::new(root, course::CHAPTERS))
}

/// What is wrong with the book of the workspace in `root` that was built into `out`: one line for each problem.
///
/// It finds links that lead nowhere, images without a file or without words, anything that a network would be needed
/// for, and whatever the book forgot: pages, chapters, anchors, exercises.
#[must_use]
pub fn check(root: &Path, out: &Path) -> Vec<String> {
    check::problems(&House::new(root, course::CHAPTERS), out)
}
