//! The options of a command line.

use std::path::PathBuf;

use clap::{Arg, ArgAction, Command, builder::ValueParser, value_parser};

use crate::{error_goal::ErrorGoal, film::Size, picture::Chapter, renderer::Plan, report::Report};

/// The options that every chapter has.
pub(super) fn command(chapter: &Chapter) -> Command {
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
             {name} {first} --output - --no-window | other-program\n  \
             {name} {first} --no-window --samples 1000000 --save-state big.state      Ctrl-C ends it well\n  \
             {name} {first} --no-window --resume big.state --save-state big.state     and this goes on"
        ))
        .arg(Arg::new("picture").value_name("PICTURE").help("Which picture; the chapter's cover if none is named"))
        .arg(flag("list", "List the pictures and reports with their knobs"))
        .args(chapter.reports.iter().map(report))
        .arg(
            option(
                "set",
                "KNOB=VALUE",
                value_parser!(String),
                "Turn a knob of the picture or the report; may be repeated",
            )
            .action(ArgAction::Append),
        )
        .arg(option("mesh", "FILE", value_parser!(PathBuf), "Take the mesh in this OBJ file"))
        .arg(option("size", "WxH", ValueParser::new(size), "Width and height in pixels"))
        .arg(option("samples", "N", ValueParser::new(samples), "Samples per pixel, 1 to 100 million"))
        .arg(option("until-error", "PERCENT", ValueParser::new(until_error), UNTIL_ERROR))
        .arg(option("save-state", "FILE", value_parser!(PathBuf), "Store the rendering too, so that it can go on"))
        .arg(option("resume", "FILE", value_parser!(PathBuf), "Go on from there, up to --samples N in all"))
        .arg(option("seed", "N", value_parser!(u64).into(), "Seed of the random numbers [default: 0]"))
        .arg(option("threads", "N", ValueParser::new(threads), "Threads, 1 to 1024 [default: one a core]"))
        .arg(option("exposure", "STOPS", ValueParser::new(exposure), "Brighten by a factor of 2^STOPS, -20 to 20"))
        .arg(option("output", "FILE", value_parser!(PathBuf), output(chapter)))
        .arg(flag("no-window", "Do not open a window"))
        .arg(option("pixel", "X,Y", ValueParser::new(pixel), "Tell how this pixel got its color, instead of rendering"))
        .arg(flag("quiet", "Tell nothing but errors"))
}

/// Samples per pixel at most with `--until-error`, when nothing is said.
pub(super) const UNTIL_ERROR_SAMPLES: u32 = 1_000_000;
const UNTIL_ERROR: &str = "Add samples until the picture's own error is this small, like 1%, or there are --samples N \
                           [default then: 1 million]";

/// What can be named with `--output`.
fn output(chapter: &Chapter) -> &'static str {
    if chapter.reports.iter().any(|report| report.gives_files) {
        "File to write, .png or .exr; - for standard output; for a report, the folder of its files"
    } else {
        "File to write, .png or .exr; - for standard output"
    }
}

/// The option that asks for a report.
fn report(report: &'static Report) -> Arg {
    let option =
        Arg::new(report.name).long(report.name).help(format!("{} (a report; --list shows its knobs)", report.what));
    match report.subject {
        None => option.action(ArgAction::SetTrue),
        Some(knob) => option.value_name(knob.name).value_parser(value_parser!(String)),
    }
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
    within(text, 1..=Plan::MAX_SAMPLES, "expected a whole number from 1 to 100000000")
}

fn until_error(text: &str) -> Result<ErrorGoal, String> {
    text.parse()
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
