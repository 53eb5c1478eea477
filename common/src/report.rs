//! The report contract: what a chapter tells in words and numbers instead of a picture, such as a table that compares.

use crate::{error::Error, knob::Knob, picture::Settings};

// ANCHOR: report
/// The definition of one report. On the command line it is the option `--NAME` of its chapter.
#[derive(Clone, Copy, Debug)]
pub struct Report {
    /// Name on the command line.
    pub name: &'static str,
    /// What it tells: its line in the help.
    pub what: &'static str,
    /// The knob whose value stands right behind the name, `--NAME VALUE`, if there is one.
    pub subject: Option<&'static Knob>,
    /// What else can be turned, with `--set`.
    pub knobs: &'static [Knob],
    /// Whether it can be about a mesh that the user names with `--mesh FILE`.
    pub takes_mesh: bool,
    /// Whether it has files to give, such as a plot, for a folder that the user names with `--output FOLDER`.
    pub gives_files: bool,
    /// Does the work and puts it into lines, each ended, of at most 100 characters.
    pub make: fn(&Task) -> Result<Told, Error>,
}
// ANCHOR_END: report

/// What a report has to tell.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Told {
    /// Its lines.
    pub text: String,
    /// The same in more detail, as files. They are written only where the user wants them.
    pub files: Vec<Attachment>,
}

/// A file that a report gives along with its text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attachment {
    /// Name of the file, without a folder.
    pub name: String,
    /// All that is in it.
    pub content: String,
}

impl From<String> for Told {
    fn from(text: String) -> Self {
        Self { text, files: Vec::new() }
    }
}

/// What a user wants a report about, and what may be used for it.
#[derive(Clone, Copy)]
pub struct Task<'t> {
    /// Values of the knobs, and the mesh that the user named.
    pub settings: &'t Settings,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Number of threads, 0 for as many as there are cores. [`crate::parallel`] keeps to it by itself.
    pub threads: usize,
    /// Is told each step before it begins.
    pub progress: &'t (dyn Fn(&str) + Sync),
}
