//! The command line, the same in every chapter.

mod arguments;
pub(crate) mod interrupt;
mod options;
mod progress;
mod rendering;
mod reports;
pub(crate) mod start;
mod target;

use std::{ffi::OsString, io::Write as _, process::ExitCode};

pub use arguments::{Output, Request};
pub(crate) use target::Target;

use self::start::Start;
use crate::{
    error::Error,
    knob::Knob,
    output,
    picture::{Chapter, Picture, Render},
    renderer,
    report::Report,
    story::number,
};

/// Run a chapter: do what its command line asks for. This is all that a chapter's `main` does.
///
/// Exit code 0 when that was done, 1 when it could not be done, 2 when the command line was wrong.
#[must_use]
pub fn run(chapter: &Chapter) -> ExitCode {
    run_with(chapter, std::env::args_os())
}

/// The same for a command line from elsewhere. Its first word is the program's name.
#[must_use]
pub fn run_with(chapter: &Chapter, arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let wish = match arguments::parse(chapter, arguments) {
        Ok(wish) => wish,
        Err(arguments::Stop::Help(text)) => return end(output::write_to_stdout(text.as_bytes())),
        Err(arguments::Stop::Wrong(message)) => {
            say(&format!("error: {message}"));
            return ExitCode::from(2);
        }
        Err(arguments::Stop::Unusable(error)) => return end(Err(error)),
    };
    end(match wish {
        arguments::Wish::Picture(request) => perform(chapter, &request),
        arguments::Wish::Report(inquiry) => inquiry.answer(),
    })
}

/// One line for people, on standard error. If even that cannot be written there is nobody to tell.
pub(crate) fn say(line: &str) {
    let _ = writeln!(std::io::stderr(), "{line}");
}

fn end(result: Result<(), Error>) -> ExitCode {
    match result {
        // Whoever closed the pipe has seen enough.
        Ok(()) | Err(Error::ClosedPipe) => ExitCode::SUCCESS,
        Err(error) => {
            say(&format!("error: {error}"));
            ExitCode::FAILURE
        }
    }
}

fn perform(chapter: &Chapter, request: &Request) -> Result<(), Error> {
    if request.list {
        return output::write_to_stdout(list(chapter).as_bytes());
    }
    let picture = (request.picture.make)(&request.settings)?;
    if let Some(pixel) = request.pixel {
        return output::write_to_stdout(story(picture.as_ref(), request, pixel).as_bytes());
    }
    let mut start = Some(Start::prepare(chapter, request, picture.as_ref())?);
    let target = Target::prepare(chapter, request)?;
    interrupt::listen();
    #[cfg(feature = "window")]
    if request.window {
        match crate::window::show(chapter, request, picture.as_ref(), &mut start) {
            Ok(()) => return Ok(()),
            Err(crate::window::Failed::Picture(error)) => return Err(error),
            Err(crate::window::Failed::NoDisplay) => {
                request.note("No display here, so no window: the picture goes to a file.");
            }
        }
    }
    match start.take() {
        Some(start) => rendering::run(chapter, request, picture.as_ref(), start, &target),
        None => Ok(()),
    }
}

/// The pictures and the reports of a chapter with their knobs, for `--list`.
fn list(chapter: &Chapter) -> String {
    let mut text = format!("Pictures of chapter {}, {}:\n", chapter.number, chapter.title);
    for (i, Picture { name, alt, knobs, size, samples, takes_mesh, .. }) in chapter.pictures.iter().enumerate() {
        let cover = if i == 0 { ", the cover" } else { "" };
        let mesh = if *takes_mesh { ", takes --mesh FILE" } else { "" };
        let size = format!("{}x{}", size.width(), size.height());
        text += &format!("\n{name} ({size}, {samples} samples{cover}{mesh})\n  {alt}\n");
        text += &list_knobs(knobs);
    }
    for Report { name, what, subject, knobs, takes_mesh, gives_files, .. } in chapter.reports {
        let words = subject.map(|knob| format!("    {}: {}, {}\n", knob.name, knob.what, knob.range()));
        let words = words.unwrap_or_default();
        let subject = subject.map(|knob| format!(" {}", knob.name)).unwrap_or_default();
        let mesh = if *takes_mesh { ", takes --mesh FILE" } else { "" };
        let files = if *gives_files { ", gives files with --output FOLDER" } else { "" };
        text += &format!("\n--{name}{subject} (a report{mesh}{files})\n  {what}\n{words}{}", list_knobs(knobs));
    }
    text
}

fn list_knobs(knobs: &[Knob]) -> String {
    let line =
        |knob: &Knob| format!("    {} = {}: {}, {}\n", knob.name, knob.show(knob.default()), knob.what, knob.range());
    knobs.iter().map(line).collect()
}

/// The story of one pixel, for `--pixel`.
fn story(picture: &dyn Render, request: &Request, (x, y): (u32, u32)) -> String {
    let Request { size, plan, .. } = request;
    let mut text = format!(
        "{}, {}x{} pixels: column {x} from the left, row {y} from the top, counted from 0\n",
        request.picture.name,
        size.width(),
        size.height()
    );
    // More samples than anybody reads are counted, but not told.
    const TOLD: u32 = 4;
    let mut pixel = crate::film::Pixel::default();
    for sample in 0..plan.samples {
        let (color, story) = renderer::explain(picture, (x, y), *size, plan, sample);
        pixel.add(color);
        if sample < TOLD {
            text += &format!("\nSample {} of {}\n{story}", sample + 1, plan.samples);
        }
    }
    if plan.samples > TOLD {
        text +=
            &format!("\n… and {} more samples (--samples 1 tells of the pixel's center alone)\n", plan.samples - TOLD);
    }
    let mean = pixel.mean();
    let [r, g, b] = (mean * crate::float::exp2(request.exposure)).to_array().map(crate::color::to_byte);
    text += &format!(
        "\nPixel: radiance ({}, {}, {}), on screen {r} {g} {b} (#{r:02x}{g:02x}{b:02x})\n",
        number(mean.x),
        number(mean.y),
        number(mean.z)
    );
    text
}

impl Request {
    /// Samples per pixel of a picture in a window: unless a number was said, it refines until the window is closed. A
    /// picture that takes a lone sample keeps it, in the center of the pixel.
    #[cfg(feature = "window")]
    pub(crate) fn samples_in_window(&self, picture: &Picture) -> u32 {
        match self.samples {
            Some(samples) if picture.name == self.picture.name => samples,
            _ if picture.samples == 1 && self.until_error.is_none() => 1,
            _ => renderer::Plan::MAX_SAMPLES,
        }
    }

    /// A line for people, unless they asked for silence.
    pub(crate) fn note(&self, line: &str) {
        if !self.quiet {
            say(line);
        }
    }
}
