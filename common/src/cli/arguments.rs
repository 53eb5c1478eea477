//! From the words of a command line to a request.

use std::{ffi::OsString, path::PathBuf};

use clap::ArgMatches;

use super::{
    options::{UNTIL_ERROR_SAMPLES, command},
    reports::{self, Inquiry},
    start,
};
use crate::{
    error::Error,
    error_goal::ErrorGoal,
    film::Size,
    knob::{Knob, Values},
    obj,
    picture::{Chapter, Picture, Settings},
    renderer::Plan,
};

/// What a command line asks for.
pub(crate) enum Wish {
    /// A picture, its story, or the list of pictures.
    Picture(Box<Request>),
    /// A report.
    Report(Inquiry),
}

/// What a user asks for who wants a picture.
#[derive(Clone, Debug)]
pub struct Request {
    /// Which picture.
    pub picture: &'static Picture,
    /// With which values of its knobs, and which mesh.
    pub settings: Settings,
    /// How large.
    pub size: Size,
    /// How many samples, which seed, how many threads.
    pub plan: Plan,
    /// How many samples per pixel, if that was said.
    pub samples: Option<u32>,
    /// The error that is small enough to end, if one is.
    pub until_error: Option<ErrorGoal>,
    /// The file to store the rendering in, so that it can go on.
    pub save_state: Option<PathBuf>,
    /// The file with the rendering that goes on.
    pub resume: Option<PathBuf>,
    /// How much brighter, in stops.
    pub exposure: f32,
    /// Where it goes.
    pub output: Output,
    /// Whether a window is wanted.
    pub window: bool,
    /// Whether only errors are told.
    pub quiet: bool,
    /// The pixel whose story is wanted instead of the picture.
    pub pixel: Option<(u32, u32)>,
    /// Whether a list of the pictures is wanted instead.
    pub list: bool,
}

/// Where a picture goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Output {
    /// Nothing was said: `pictures/CHAPTER/PICTURE.png`.
    Default,
    /// A file that the user named.
    File(PathBuf),
    /// `-`: PNG on standard output.
    Stdout,
}

/// Why there is no request.
pub(crate) enum Stop {
    /// Help or version was asked for; this is it.
    Help(String),
    /// The command line is wrong; this line says what would be right.
    Wrong(String),
    /// The command line is right, but a file that it names cannot be used.
    Unusable(Error),
}

impl From<String> for Stop {
    fn from(what: String) -> Self {
        Self::Wrong(what)
    }
}

/// Understand a command line.
pub(crate) fn parse(chapter: &Chapter, arguments: impl IntoIterator<Item = OsString>) -> Result<Wish, Stop> {
    let matches = command(chapter).try_get_matches_from(arguments).map_err(|error| {
        let text = error.to_string();
        if !error.use_stderr() {
            return Stop::Help(text);
        }
        // The first paragraph says what is wrong; usage and hints follow it.
        let what = text.trim_start_matches("error: ").split("\n\n").next().unwrap_or_default();
        let what = what.split_whitespace().collect::<Vec<_>>().join(" ");
        Stop::Wrong(format!("{what} (--help shows all options)"))
    })?;
    match reports::understand(chapter, &matches)? {
        Some(inquiry) => Ok(Wish::Report(inquiry)),
        None => Ok(Wish::Picture(Box::new(understand(chapter, &matches)?))),
    }
}

fn understand(chapter: &Chapter, matches: &ArgMatches) -> Result<Request, Stop> {
    let list = matches.get_flag("list");
    let mesh = matches.get_one::<PathBuf>("mesh");
    let picture = match matches.get_one::<String>("picture") {
        Some(name) => named(chapter, name)?,
        None if mesh.is_some() => chapter
            .pictures
            .iter()
            .find(|p| p.takes_mesh)
            .ok_or_else(|| format!("no picture of chapter {} takes --mesh", chapter.name))?,
        None => chapter.pictures.first().ok_or_else(|| "this chapter has no pictures yet".to_string())?,
    };

    let values = values(matches, picture.knobs, &format!("picture '{}'", picture.name))?;
    let mut settings = Settings { values, mesh: None };
    if let Some(path) = mesh {
        if !picture.takes_mesh {
            let able: Vec<_> = chapter.pictures.iter().filter(|p| p.takes_mesh).map(|p| p.name).collect();
            let able = if able.is_empty() { "none does".into() } else { format!("these do: {}", able.join(", ")) };
            return Err(Stop::Wrong(format!("picture '{}' does not take --mesh; {able}", picture.name)));
        }
        settings.mesh = Some(obj::read(path).map_err(Stop::Unusable)?);
    }

    let size = matches.get_one::<Size>("size").copied().unwrap_or(picture.size);
    let pixel = matches.get_one::<(u32, u32)>("pixel").copied();
    if let Some((x, y)) = pixel.filter(|(x, y)| *x >= size.width() || *y >= size.height()) {
        let (right, bottom) = (size.width() - 1, size.height() - 1);
        return Err(Stop::Wrong(format!(
            "pixel {x},{y} is outside: columns go from 0 to {right}, rows from 0 to {bottom}"
        )));
    }
    let output = match matches.get_one::<PathBuf>("output") {
        None => Output::Default,
        Some(path) if path.as_os_str() == "-" => Output::Stdout,
        Some(path) => Output::File(path.clone()),
    };
    let samples = matches.get_one("samples").copied();
    let until_error = matches.get_one::<ErrorGoal>("until-error").copied();
    let [save_state, resume] = start::files(matches)?;
    if until_error.is_some() && samples == Some(1) {
        return Err(Stop::Wrong("a lone sample has no error: --until-error needs --samples 2 or more".into()));
    }
    Ok(Request {
        picture,
        settings,
        size,
        samples,
        until_error,
        save_state,
        resume,
        plan: Plan {
            samples: samples.unwrap_or(if until_error.is_some() { UNTIL_ERROR_SAMPLES } else { picture.samples }),
            seed: matches.get_one("seed").copied().unwrap_or_default(),
            threads: matches.get_one("threads").copied().unwrap_or_default(),
        },
        exposure: matches.get_one("exposure").copied().unwrap_or_default(),
        window: !matches.get_flag("no-window") && output != Output::Stdout,
        output,
        quiet: matches.get_flag("quiet"),
        pixel,
        list,
    })
}

fn named(chapter: &Chapter, name: &str) -> Result<&'static Picture, String> {
    let names = chapter.pictures.iter().map(|p| p.name);
    chapter.picture(name).ok_or_else(|| format!("no picture is called '{name}'; {}", instead(name, names)))
}

/// The knobs as they are set by `--set`. `owner` is what they belong to, in words.
pub(super) fn values(matches: &ArgMatches, knobs: &'static [Knob], owner: &str) -> Result<Values, Stop> {
    let mut values = Values::default();
    for setting in matches.get_many::<String>("set").into_iter().flatten() {
        let (name, value) =
            setting.split_once('=').ok_or_else(|| format!("--set takes knob=value, not '{setting}'"))?;
        let knob = knobs.iter().find(|k| k.name == name).ok_or_else(|| match knobs {
            [] => format!("{owner} has no knobs"),
            knobs => format!("{owner} has no knob '{name}'; {}", instead(name, knobs.iter().map(|k| k.name))),
        })?;
        values.set(knob, knob.parse(value).map_err(|e| e.to_string())?);
    }
    Ok(values)
}

/// The name that was probably meant, or all there are.
fn instead(name: &str, names: impl Iterator<Item = &'static str> + Clone) -> String {
    let likeness = |candidate: &str| strsim::jaro_winkler(name, candidate);
    let best = names.clone().max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
    match best.filter(|b| likeness(b) > 0.75) {
        Some(best) => format!("did you mean '{best}'?"),
        None => format!("there are: {}", names.collect::<Vec<_>>().join(", ")),
    }
}
