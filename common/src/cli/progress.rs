//! Who watches a rendering that goes to a file: a progress bar, Ctrl-C, and the error that is small enough.

use std::{
    sync::{
        OnceLock,
        atomic::{AtomicBool, Ordering},
    },
    time::{Duration, Instant},
};

use indicatif::{ProgressBar, ProgressState, ProgressStyle};

use super::{Request, interrupt};
use crate::{
    error_goal::{ErrorGoal, percent},
    film::{Film, Pixel, Tile},
    renderer::Watch,
};

/// Shows how far a rendering is, its rate and the time left; nothing when standard error is no terminal.
pub(crate) struct Progress {
    bar: ProgressBar,
    goal: Option<ErrorGoal>,
    /// Samples per pixel at most.
    samples: u32,
    /// Whether every pixel has a sample.
    whole: AtomicBool,
    /// When it was first seen that somebody asked to end.
    asked: OnceLock<Instant>,
}

impl Progress {
    /// How long an interrupted rendering goes on for a first sample in every pixel.
    const FOR_THE_WHOLE: Duration = Duration::from_secs(1);

    /// Progress from a film to so many samples per pixel.
    pub(crate) fn new(request: &Request, film: &Film, samples: u32) -> Self {
        // An empty film need not be looked through.
        let goes_on = request.resume.is_some();
        let has = |pixel: &Pixel| u64::from(pixel.count().min(samples));
        let has: u64 = if goes_on { film.tiles().iter().flat_map(|tile| &tile.pixels).map(has).sum() } else { 0 };
        let missing = film.size().pixels() as u64 * u64::from(samples) - has;
        let bar = if request.quiet { ProgressBar::hidden() } else { ProgressBar::new(missing) };
        let style = ProgressStyle::with_template("{bar:40} {percent:>3} %  {rate}  {eta} left  {msg}");
        if let Ok(style) = style {
            bar.set_style(style.with_key("rate", |state: &ProgressState, f: &mut dyn std::fmt::Write| {
                let _ = write!(f, "{:.2} million samples/s", state.per_sec() / 1e6);
            }));
        }
        // A picture that is done at once needs no bar; one that is slow moves even between two tiles.
        if !request.quiet {
            bar.enable_steady_tick(Duration::from_millis(200));
        }
        let whole = AtomicBool::new(goes_on && film.counts().0 > 0);
        Self { bar, goal: request.until_error, samples, whole, asked: OnceLock::new() }
    }

    /// Take the bar away.
    pub(crate) fn finish(&self) {
        self.bar.finish_and_clear();
    }

    /// Tell the error, and let the bar end where it will probably be small enough.
    fn tell(&self, film: &Film, samples: u32, goal: ErrorGoal) {
        let Some(error) = film.relative_error() else { return };
        self.bar.set_message(format!("error {}, until {goal}", percent(error)));
        let missing = goal.forecast(error, samples).min(self.samples.into()) - f64::from(samples);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates; limited above")]
        let missing = missing.max(1.0) as u64 * film.size().pixels() as u64;
        self.bar.set_length(self.bar.position() + missing);
    }
}

impl Watch for Progress {
    fn tile_done(&self, _tile: &Tile, samples: u64) {
        self.bar.inc(samples);
    }

    fn pass_done(&self, _film: &Film, _samples: u32) {
        self.whole.store(true, Ordering::Relaxed);
    }

    fn is_cancelled(&self) -> bool {
        interrupt::is_asked()
            && (self.whole.load(Ordering::Relaxed)
                || self.asked.get_or_init(Instant::now).elapsed() > Self::FOR_THE_WHOLE)
    }

    fn is_enough(&self, film: &Film, samples: u32) -> bool {
        self.goal.is_some_and(|goal| {
            self.tell(film, samples, goal);
            goal.is_reached(film, samples)
        })
    }
}
