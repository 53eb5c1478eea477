//! From the words of a command line to a request.

use std::{ffi::OsString, path::PathBuf};

use clap::{Arg, ArgAction, ArgMatches, Command, builder::ValueParser, value_parser};

use crate::{
    error::Error,
    film::Size,
    knob::Knob,
    obj,
    picture::{Chapter, Picture, Settings},
    renderer::Plan,
};

/// What a user asks for.
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
pub(crate) fn parse(chapter: &Chapter, arguments: impl IntoIterator<Item = OsString>) -> Result<Request, Stop> {
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
    understand(chapter, &matches)
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

    let mut settings = Settings::default();
    for setting in matches.get_many::<String>("set").into_iter().flatten() {
        let (name, value) =
            setting.split_once('=').ok_or_else(|| format!("--set takes knob=value, not '{setting}'"))?;
        let knob = knob(picture, name)?;
        settings.values.set(knob, knob.parse(value).map_err(|e| e.to_string())?);
    }
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
    Ok(Request {
        picture,
        settings,
        size,
        plan: Plan {
            samples: matches.get_one("samples").copied().unwrap_or(picture.samples),
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

fn knob(picture: &Picture, name: &str) -> Result<&'static Knob, String> {
    let names = picture.knobs.iter().map(|k| k.name);
    let found = picture.knobs.iter().find(|k| k.name == name);
    found.ok_or_else(|| format!("picture '{}' has no knob '{name}'; {}", picture.name, instead(name, names)))
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

/// The options that every chapter has.
fn command(chapter: &Chapter) -> Command {
    let name = chapter.name;
    let option = |name: &'static str, value: &'static str, parser: ValueParser, help: &'static str| {
        Arg::new(name).long(name).value_name(value).value_parser(parser).help(help).allow_hyphen_values(true)
    };
    let flag = |name: &'static str, help: &'static str| Arg::new(name).long(name).action(ArgAction::SetTrue).help(help);
    let first = chapter.pictures.first().map_or("", |p| p.name);
    Command::new(name)
        .bin_name(name)
        .version(env!("CARGO_PKG_VERSION"))
        .about(format!("Chapter {}, {}: renders its pictures.", chapter.number, chapter.title))
        .after_help(format!(
            "Examples (with cargo, put 'cargo run -p {name} --' in front of the options):\n  \
             {name}                                     the cover, in a window or a file\n  \
             {name} --list                              all pictures and their knobs\n  \
             {name} {first} --size 1920x1080 --samples 64 --output poster.png\n  \
             {name} {first} --set yaw=40 --set pitch=10\n  \
             {name} {first} --pixel 300,200 --samples 1    why this pixel has its color\n  \
             {name} {first} --output - --no-window | other-program"
        ))
        .arg(Arg::new("picture").value_name("PICTURE").help("Which picture; the chapter's cover if none is named"))
        .arg(flag("list", "List the pictures with their knobs"))
        .arg(
            option("set", "KNOB=VALUE", value_parser!(String), "Turn a knob of the picture; may be repeated")
                .action(ArgAction::Append),
        )
        .arg(option("mesh", "FILE", value_parser!(PathBuf), "Show the mesh in this OBJ file"))
        .arg(option("size", "WxH", ValueParser::new(size), "Width and height in pixels"))
        .arg(option("samples", "N", ValueParser::new(samples), "Samples per pixel, 1 to 100 million"))
        .arg(option("seed", "N", value_parser!(u64).into(), "Seed of the random numbers [default: 0]"))
        .arg(option("threads", "N", ValueParser::new(threads), "Threads, 1 to 1024 [default: one a core]"))
        .arg(option("exposure", "STOPS", ValueParser::new(exposure), "Brighten by a factor of 2^STOPS, -20 to 20"))
        .arg(option("output", "FILE", value_parser!(PathBuf), "File to write, .png or .exr; - for standard output"))
        .arg(flag("no-window", "Do not open a window"))
        .arg(option("pixel", "X,Y", ValueParser::new(pixel), "Tell how this pixel got its color, instead of rendering"))
        .arg(flag("quiet", "Tell nothing but errors"))
}

fn size(text: &str) -> Result<Size, String> {
    let (width, height) = text.split_once(['x', 'X', '×']).ok_or("expected WIDTHxHEIGHT, like 640x360")?;
    let side = |text: &str| text.parse::<u64>().map_err(|_| "expected WIDTHxHEIGHT, like 640x360");
    Size::new(side(width)?, side(height)?).map_err(|e| e.to_string())
}

fn pixel(text: &str) -> Result<(u32, u32), String> {
    let wrong = || "expected X,Y, like 320,180".to_string();
    let (x, y) = text.split_once(',').ok_or_else(wrong)?;
    Ok((x.trim().parse().map_err(|_| wrong())?, y.trim().parse().map_err(|_| wrong())?))
}

fn samples(text: &str) -> Result<u32, String> {
    within(text, 1..=100_000_000, "expected a whole number from 1 to 100000000")
}

fn threads(text: &str) -> Result<usize, String> {
    within(text, 1..=1024, "expected a whole number from 1 to 1024")
}

fn exposure(text: &str) -> Result<f32, String> {
    within(text, -20.0..=20.0, "expected a number of stops from -20 to 20")
}

fn within<T: std::str::FromStr + PartialOrd>(
    text: &str,
    range: std::ops::RangeInclusive<T>,
    expected: &str,
) -> Result<T, String> {
    text.parse().ok().filter(|value| range.contains(value)).ok_or_else(|| expected.into())
}
