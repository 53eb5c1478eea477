//! The start of a rendering: an empty film, or one from a file that goes on.

use std::path::{Path, PathBuf};

use clap::{ArgMatches, parser::ValueSource};

use super::Request;
use crate::{
    error::Error,
    film::Film,
    origin::Origin,
    output::Format,
    picture::{Chapter, Render},
    state::{self, State},
};

/// The files that `--save-state` and `--resume` name.
pub(super) fn files(matches: &ArgMatches) -> Result<[Option<PathBuf>; 2], String> {
    let is_said = |name: &&str| matches.value_source(name) == Some(ValueSource::CommandLine);
    let mut ours = ["until-error", "save-state", "resume"].iter();
    if let Some(name) = ours.find(|name| is_said(&"pixel") && is_said(name)) {
        return Err(format!("--pixel tells of one pixel and renders nothing; leave out '--{name}'"));
    }
    let files = ["save-state", "resume"].map(|name| matches.get_one::<PathBuf>(name).cloned());
    for path in files.iter().flatten() {
        // A picture of that name would take the place of the state.
        if path.as_os_str() == "-" || Format::of(path).is_ok() {
            return Err(format!("'{}' cannot name a state; big.state could", path.display()));
        }
    }
    Ok(files)
}

/// What a rendering starts from, known to be usable before work begins.
pub(crate) struct Start {
    state: Option<State>,
}

impl Start {
    /// The start that the request asks for; `picture` is the picture that it asks for, already made.
    pub(crate) fn prepare(chapter: &Chapter, request: &Request, picture: &dyn Render) -> Result<Self, Error> {
        if let Some(path) = &request.save_state {
            state::check_writable(path)?;
        }
        let Some(path) = &request.resume else { return Ok(Self { state: None }) };
        let state = state::read(path)?;
        match origin(chapter, request, picture).difference(&state.origin) {
            Some(reason) => Err(Error::State { file: path.display().to_string(), reason }),
            None => Ok(Self { state: Some(state) }),
        }
    }

    /// How many samples per pixel the rendering was to have that goes on, if one does.
    pub(crate) fn goal(&self) -> Option<u32> {
        self.state.as_ref().map(|state| state.goal)
    }

    /// The film to go on with up to `samples` samples per pixel, and the goal to be stored with it.
    ///
    /// A lone sample lies in the center of its pixel and several lie elsewhere, so that one does not lead to the other:
    /// the film is empty then. There is one sample to be lost at most.
    pub(crate) fn film(self, request: &Request, samples: u32) -> (Film, u32) {
        let (Some(State { goal, film, .. }), Some(path)) = (self.state, &request.resume) else {
            return (Film::new(request.size), samples);
        };
        let least = film.counts().0;
        if least >= samples {
            request.note(&format!(
                "{} has {least} samples per pixel already, and --samples {samples} asks for no more.",
                path.display()
            ));
            (film, goal)
        } else if (goal == 1) == (samples == 1) {
            (film, samples)
        } else {
            let has = if goal == 1 { "a lone sample" } else { "some of several samples" };
            request.note(&format!(
                "{} has {has} per pixel, {samples} lie elsewhere in the pixel: beginning anew.",
                path.display()
            ));
            (Film::new(request.size), samples)
        }
    }
}

/// Store a rendering where the request wants it, if it does; `picture` is the picture as it was made.
pub(crate) fn store(
    chapter: &Chapter,
    request: &Request,
    picture: &dyn Render,
    goal: u32,
    film: &Film,
) -> Result<(), Error> {
    let Some(path) = &request.save_state else { return Ok(()) };
    state::write(path, &origin(chapter, request, picture), goal, film)?;
    request.note(&format!("Wrote {}, from which --resume goes on.", Path::display(path)));
    Ok(())
}

fn origin(chapter: &Chapter, request: &Request, picture: &dyn Render) -> Origin {
    let Request { picture: defined, settings, size, plan, .. } = request;
    Origin::new(chapter, defined, settings, *size, plan.seed, picture)
}
