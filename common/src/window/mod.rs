//! The window: a picture refines while it is watched, its knobs are on keys, its camera is on the mouse.
//!
//! Two threads share the work. The one that opened the window polls keys and mouse, draws, and never waits; the
//! `worker` renders and saves. Orders go to the worker through a `mailbox`; what is to be seen comes back in
//! `shown`.

mod controls;
#[cfg(test)]
mod fixture;
mod keys;
mod mailbox;
mod mouse;
mod overlay;
mod raster;
mod resize;
mod session;
mod shown;
mod watcher;
mod worker;

use std::{sync::Mutex, thread};

use minifb::{ScaleMode, Window, WindowOptions};

use self::{mailbox::Mailbox, raster::Raster, session::Session, shown::Shown, worker::Worker};
use crate::{
    cli::{Request, interrupt, start::Start},
    error::Error,
    film::Film,
    picture::{Chapter, Render},
    renderer::Plan,
};

/// Why no picture was shown.
pub(crate) enum Failed {
    /// There is no display.
    NoDisplay,
    /// The picture could not be made or saved.
    Picture(Error),
}

/// Show the picture that the request asks for, already made, until the window is closed; it is saved then. What it
/// starts from is taken once there is a window.
pub(crate) fn show(
    chapter: &Chapter,
    request: &Request,
    picture: &dyn Render,
    start: &mut Option<Start>,
) -> Result<(), Failed> {
    let samples = request.samples_in_window(request.picture);
    let request = &Request { plan: Plan { samples, ..request.plan }, ..request.clone() };
    let shown = Shown::new(request.size, request.plan.samples);
    let (width, height) = resize::opening(Raster::of(request.size).size());
    let options = WindowOptions { resize: true, scale_mode: ScaleMode::UpperLeft, ..Default::default() };
    let title = shown.title(chapter.title, request.picture.name);
    let window = Window::new(&title, width, height, options).map_err(|_| Failed::NoDisplay)?;

    let empty = || (Film::new(request.size), samples);
    let (film, goal) = start.take().map_or_else(empty, |start| start.film(request, samples));
    let (mailbox, shown) = (Mailbox::default(), Mutex::new(shown));
    let ended = thread::scope(|scope| {
        let closing = mailbox.closing();
        let worker = scope.spawn(|| Worker::new(chapter, request, picture, (film, goal), &mailbox, &shown).run());
        Session::new(chapter, request, window, &mailbox, &shown).run(|| worker.is_finished() || interrupt::is_asked());
        // The window is gone by now; the worker still saves.
        drop(closing);
        worker.join()
    });
    match ended {
        Ok(saved) => saved.map_err(Failed::Picture),
        // A picture that panics does so here as it would without a window.
        Err(panic) => std::panic::resume_unwind(panic),
    }
}
