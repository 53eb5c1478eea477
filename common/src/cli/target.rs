//! Where a picture goes.

use std::{
    path::{Path, PathBuf},
    time::Duration,
};

use super::{Output, Request, say};
use crate::{
    error::Error,
    film::{Film, Size},
    output::{self, Format},
    picture::Chapter,
};

/// Where the picture goes, known to be writable before work begins.
pub(crate) enum Target {
    /// The bytes of a PNG go to standard output.
    Stdout,
    /// A file in one of the formats.
    File(PathBuf, Format),
}

impl Target {
    /// The place that the request asks for.
    pub(crate) fn prepare(chapter: &Chapter, request: &Request) -> Result<Self, Error> {
        let path = match &request.output {
            Output::Stdout => return Ok(Self::Stdout),
            Output::File(path) => path.clone(),
            Output::Default => Path::new("pictures").join(chapter.name).join(format!("{}.png", request.picture.name)),
        };
        let format = output::check_writable(&path)?;
        Ok(Self::File(path, format))
    }

    /// Store the picture and say so, with the time it took if that is known.
    pub(crate) fn save(&self, film: &Film, request: &Request, time: Option<Duration>) -> Result<(), Error> {
        let bad = film.bad_samples();
        if bad > 0 {
            say(&format!("warning: {bad} samples were not a number or infinite; they are left out of the picture"));
        }
        let counts = film.counts();
        if counts.0 == 0 {
            say("warning: not every pixel had a sample yet; those without are black");
        }
        match self {
            Self::Stdout => output::write_to_stdout(&output::encode(film, Format::Png, request.exposure)?),
            Self::File(path, format) => {
                output::write(path, &output::encode(film, *format, request.exposure)?)?;
                let time = time.map(|t| format!(", {:.2} s", t.as_secs_f64())).unwrap_or_default();
                request.note(&format!(
                    "Wrote {} ({}, {} per pixel{time}).",
                    path.display(),
                    dimensions(film.size()),
                    samples(counts)
                ));
                Ok(())
            }
        }
    }
}

/// The least and the greatest number of samples of a film in words.
pub(super) fn samples((least, most): (u32, u32)) -> String {
    if least == most { least.to_string() } else { format!("{least} to {most}") }
}

fn dimensions(size: Size) -> String {
    format!("{}×{} pixels", size.width(), size.height())
}
