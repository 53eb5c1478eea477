//! The watcher: passes what is rendered on to the window, and ends a rendering that is not wanted any more.

use std::{
    sync::{
        Mutex,
        atomic::{AtomicBool, Ordering},
    },
    time::{Duration, Instant},
};

use super::{
    mailbox::{Mailbox, Progress, lock},
    raster::{Raster, screen},
    shown::Shown,
};
use crate::{
    color::Rgb,
    film::{Film, Tile},
    picture::{FilmPoint, Render},
    random::Stream,
    renderer::{self, Ending, Plan, Watch},
    story::Told,
};

/// Watches a rendering for the window.
pub(crate) struct Watcher<'a> {
    /// Where orders wait.
    pub(crate) mailbox: &'a Mailbox,
    /// Where the window looks.
    pub(crate) shown: &'a Mutex<Shown>,
    /// How much there is to see.
    pub(crate) progress: &'a Progress,
    /// Whether the last first pass took so long that something rougher should come before it.
    pub(crate) slow: &'a AtomicBool,
    /// Factor of the exposure.
    pub(crate) gain: f32,
    /// When the rendering began.
    pub(crate) start: Instant,
}

impl Watcher<'_> {
    /// Show a small rough picture, stretched, before the first pass of a slow one.
    pub(crate) fn sketch(&self, picture: &dyn Render, film: &Film, plan: &Plan) {
        const SHARE: u32 = 4;
        let size = film.size();
        let mut small = Film::new(size.scaled_to((size.width().max(size.height()) / SHARE).max(1)));
        let cancel = Cancel(self);
        if renderer::render(picture, &mut small, &Plan { samples: 1, ..*plan }, &cancel) == Ending::Finished {
            let mut raster = Raster::of(small.size());
            for tile in small.tiles() {
                raster.put(tile, &self.developed(tile));
            }
            let mut shown = lock(self.shown);
            shown.raster = raster.stretched(size);
            shown.version += 1;
            self.progress.rough.store(true, Ordering::Release);
        }
    }

    /// A tile as screen pixels.
    fn developed(&self, tile: &Tile) -> Vec<u32> {
        tile.pixels.iter().map(|pixel| screen(pixel.mean() * self.gain)).collect()
    }
}

impl Watch for Watcher<'_> {
    fn tile_done(&self, tile: &Tile, _samples: u32) {
        let developed = self.developed(tile);
        // A tile that was abandoned shows nothing true.
        if !self.mailbox.is_overtaken(self.progress) {
            let mut shown = lock(self.shown);
            shown.raster.put(tile, &developed);
            shown.version += 1;
        }
    }

    fn pass_done(&self, film: &Film, samples: u32) {
        const LONG: Duration = Duration::from_millis(150);
        if samples == 1 {
            self.slow.store(self.start.elapsed() > LONG, Ordering::Relaxed);
        }
        let error = film.relative_error();
        let mut shown = lock(self.shown);
        (shown.samples, shown.error) = (samples, error);
        shown.version += 1;
        self.progress.rough.store(true, Ordering::Release);
        self.progress.whole.store(true, Ordering::Release);
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
