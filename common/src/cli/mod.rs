//! The command line, the same in every chapter.

mod arguments;
mod options;
mod progress;
mod reports;

use std::{
    ffi::OsString,
    io::Write as _,
    path::{Path, PathBuf},
    process::ExitCode,
    time::{Duration, Instant},
};

pub use arguments::{Output, Request};

use crate::{
    error::Error,
    film::{Film, Size},
    knob::Knob,
    output::{self, Format},
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
    let target = Target::prepare(chapter, request)?;
    #[cfg(feature = "window")]
    if request.window {
        match crate::window::show(chapter, request, picture.as_ref()) {
            Ok(()) => return Ok(()),
            Err(crate::window::Failed::Picture(error)) => return Err(error),
            Err(crate::window::Failed::NoDisplay) => {
                request.note("No display here, so no window: the picture goes to a file.");
            }
        }
    }
    let mut film = Film::new(request.size);
    let start = Instant::now();
    let watch = progress::Bar::new(request);
    renderer::render(picture.as_ref(), &mut film, &request.plan, &watch);
    watch.finish();
    target.save(&film, request, Some(start.elapsed()))
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
        match self {
            Self::Stdout => output::write_to_stdout(&output::encode(film, Format::Png, request.exposure)?),
            Self::File(path, format) => {
                output::write(path, &output::encode(film, *format, request.exposure)?)?;
                let samples = film.pixel(0, 0).map_or(0, |p| p.count());
                let time = time.map(|t| format!(", {:.2} s", t.as_secs_f64())).unwrap_or_default();
                request.note(&format!(
                    "Wrote {} ({}, {samples} per pixel{time}).",
                    path.display(),
                    dimensions(film.size())
                ));
                Ok(())
            }
        }
    }
}

impl Request {
    /// A line for people, unless they asked for silence.
    pub(crate) fn note(&self, line: &str) {
        if !self.quiet {
            say(line);
        }
    }
}

fn dimensions(size: Size) -> String {
    format!("{}×{} pixels", size.width(), size.height())
}
