//! A rendering that goes to a file, from its start to its end, however it ends.

use std::time::Instant;

use super::{
    Request, Target,
    progress::Progress,
    start::{self, Start},
    target,
};
use crate::{
    error::Error,
    error_goal::{ErrorGoal, percent},
    film::Film,
    picture::{Chapter, Render},
    renderer::{self, Ending, Plan},
};

/// Render into a file, and tell how it ended.
pub(super) fn run(
    chapter: &Chapter,
    request: &Request,
    picture: &dyn Render,
    start: Start,
    target: &Target,
) -> Result<(), Error> {
    let samples = match (request.samples, request.until_error) {
        (None, None) => start.goal().unwrap_or(request.plan.samples),
        _ => request.plan.samples,
    };
    let (mut film, goal) = start.film(request, samples);
    let begun = Instant::now();
    let watch = Progress::new(request, &film, samples);
    let ending = renderer::render(picture, &mut film, &Plan { samples, ..request.plan }, &watch);
    let time = begun.elapsed();
    watch.finish();
    // One of the two is better than none.
    let stored = start::store(chapter, request, picture, goal, &film);
    target.save(&film, request, Some(time)).and(stored)?;
    if ending == Ending::Cancelled && film.counts().0 < samples {
        request.note(&interrupted(request, &film, samples));
    } else if let Some(goal) = request.until_error {
        request.note(&error_told(goal, &film));
    }
    Ok(())
}

/// What error there is in the end, with `--until-error`.
fn error_told(goal: ErrorGoal, film: &Film) -> String {
    let has = target::samples(film.counts());
    let Some(error) = film.relative_error() else {
        return format!("A black picture does not know its error ({has} samples per pixel).");
    };
    let reached = if goal.is_reached(film, film.counts().0) { "small enough" } else { "not yet small enough" };
    format!("The error is {}, {reached} for --until-error {goal}, with {has} samples per pixel.", percent(error))
}

/// What there is after Ctrl-C, and how to go on.
fn interrupted(request: &Request, film: &Film, samples: u32) -> String {
    let has = target::samples(film.counts());
    match &request.save_state {
        Some(path) => format!(
            "Interrupted with {has} of {samples} samples per pixel; the same command with --resume {} goes on.",
            path.display()
        ),
        None => format!(
            "Interrupted with {has} of {samples} samples per pixel; with --save-state FILE, --resume FILE could go on."
        ),
    }
}
