//! The progress bar.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressState, ProgressStyle};

use super::Request;
use crate::{film::Tile, renderer::Watch};

/// Shows how far a rendering is, its rate and the time left; nothing when standard error is no terminal.
pub(crate) struct Bar(ProgressBar);

impl Bar {
    pub(crate) fn new(request: &Request) -> Self {
        if request.quiet {
            return Self(ProgressBar::hidden());
        }
        let bar = ProgressBar::new(request.size.pixels() as u64 * u64::from(request.plan.samples));
        let style = ProgressStyle::with_template("{bar:40} {percent:>3} %  {rate}  {eta} left  {msg}");
        if let Ok(style) = style {
            bar.set_style(style.with_key("rate", |state: &ProgressState, f: &mut dyn std::fmt::Write| {
                let _ = write!(f, "{:.2} million samples/s", state.per_sec() / 1e6);
            }));
        }
        // A picture that is done at once needs no bar; one that is slow moves even between two tiles.
        bar.enable_steady_tick(Duration::from_millis(200));
        Self(bar)
    }

    pub(crate) fn finish(&self) {
        self.0.finish_and_clear();
    }
}

impl Watch for Bar {
    fn tile_done(&self, _tile: &Tile, samples: u64) {
        self.0.inc(samples);
    }
}
