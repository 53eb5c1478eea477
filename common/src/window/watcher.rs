//! The watcher: passes what is rendered on to the window, and ends a rendering that is not wanted any more.

use std::{
    sync::{Mutex, OnceLock, atomic::Ordering},
    time::Instant,
};

use super::{
    mailbox::{Mailbox, Progress, lock},
    raster::{Raster, screen},
    shown::Shown,
};
use crate::{
    color::Rgb,
    error_goal::ErrorGoal,
    film::{Film, Size, Tile},
    picture::{FilmPoint, Render},
    random::Stream,
    renderer::{self, Ending, Plan, Watch},
    story::Told,
};

/// Watches a rendering for the window.
pub(crate) struct Watcher<'a> {
    mailbox: &'a Mailbox,
    shown: &'a Mutex<Shown>,
    progress: &'a Progress,
    /// Factor of the exposure.
    gain: f32,
    goal: Option<ErrorGoal>,
    first_pass: OnceLock<Instant>,
}

impl<'a> Watcher<'a> {
    /// A watcher for one rendering.
    pub(crate) fn new(
        mailbox: &'a Mailbox,
        shown: &'a Mutex<Shown>,
        progress: &'a Progress,
        gain: f32,
        goal: Option<ErrorGoal>,
    ) -> Self {
        Self { mailbox, shown, progress, gain, goal, first_pass: OnceLock::new() }
    }

    /// When every pixel got its first sample, if that was here.
    pub(crate) fn first_pass(&self) -> Option<Instant> {
        self.first_pass.get().copied()
    }

    /// Show a small rough picture, stretched to `size`.
    pub(crate) fn sketch(&self, picture: &dyn Render, small: Size, size: Size, plan: &Plan) -> Ending {
        let mut film = Film::new(small);
        let ending = renderer::render(picture, &mut film, &Plan { samples: 1, ..*plan }, &Cancel(self));
        if ending == Ending::Finished {
            let mut raster = Raster::of(small);
            for tile in film.tiles() {
                raster.put(tile, &self.developed(tile));
            }
            let mut shown = lock(self.shown);
            shown.raster = raster.stretched(size);
            shown.version += 1;
            self.progress.rough.store(true, Ordering::Release);
        }
        ending
    }

    /// A tile as screen pixels.
    fn developed(&self, tile: &Tile) -> Vec<u32> {
        tile.pixels.iter().map(|pixel| screen(pixel.mean() * self.gain)).collect()
    }
}

impl Watch for Watcher<'_> {
    fn tile_done(&self, tile: &Tile, _samples: u64) {
        let developed = self.developed(tile);
        // A tile that was abandoned shows nothing true.
        if !self.mailbox.is_overtaken(self.progress) {
            let mut shown = lock(self.shown);
            shown.raster.put(tile, &developed);
            shown.version += 1;
        }
    }

    fn pass_done(&self, film: &Film, samples: u32) {
        if samples == 1 {
            self.first_pass.get_or_init(Instant::now);
        }
        let error = film.relative_error();
        let mut shown = lock(self.shown);
        (shown.samples, shown.error) = (samples, error);
        shown.version += 1;
        self.progress.rough.store(true, Ordering::Release);
        self.progress.whole.store(true, Ordering::Release);
    }

    fn is_enough(&self, film: &Film, samples: u32) -> bool {
        self.goal.is_some_and(|goal| goal.is_reached(film, samples))
    }

    fn is_cancelled(&self) -> bool {
        self.mailbox.is_urgent(self.progress)
    }
}

/// Watches only whether to stop.
struct Cancel<'a>(&'a Watcher<'a>);

impl Watch for Cancel<'_> {
    fn is_cancelled(&self) -> bool {
        self.0.is_cancelled()
    }
}

/// A picture that stops looking within a tile when another view takes its place. Its film is of no use then.
pub(crate) struct Abandonable<'a> {
    /// The picture itself.
    pub(crate) picture: &'a dyn Render,
    /// Who knows whether it is still wanted.
    pub(crate) watcher: &'a Watcher<'a>,
}

impl Render for Abandonable<'_> {
    fn sample(&self, point: FilmPoint, random: &mut Stream) -> Rgb {
        let Watcher { mailbox, progress, .. } = self.watcher;
        if mailbox.is_overtaken(progress) { Rgb::ZERO } else { self.picture.sample(point, random) }
    }

    fn explain(&self, point: FilmPoint, random: &mut Stream, story: &mut Told) -> Rgb {
        self.picture.explain(point, random, story)
    }
}
