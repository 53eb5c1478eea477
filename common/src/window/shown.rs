//! What the worker has to show, for the window to pick up.

use super::{overlay::Line, raster::Raster};
use crate::{film::Size, renderer::Plan};

/// The picture as far as it is, and what is known of it.
#[derive(Debug)]
pub(crate) struct Shown {
    /// The developed picture, as large as the film.
    pub(crate) raster: Raster,
    /// Counts the changes of `raster`.
    pub(crate) version: u64,
    /// Samples that every pixel has.
    pub(crate) samples: u32,
    /// Samples that every pixel will have.
    pub(crate) total: u32,
    /// The picture's own error, as a share of its light.
    pub(crate) error: Option<f64>,
    /// Something to tell.
    pub(crate) message: Option<Line>,
}

impl Shown {
    /// Nothing yet.
    pub(crate) fn new(size: Size, total: u32) -> Self {
        Self { raster: Raster::of(size), version: 0, samples: 0, total, error: None, message: None }
    }

    /// Begin anew; until there is something new to see, the old picture stays, if need be in the new size.
    pub(crate) fn restart(&mut self, size: Size, total: u32) {
        if self.raster.size() != Raster::of(size).size() {
            self.raster = self.raster.stretched(size);
            self.version += 1;
        }
        (self.samples, self.total, self.error) = (0, total, None);
    }

    /// The title of the window.
    pub(crate) fn title(&self, chapter: &str, picture: &str) -> String {
        let error = self.error.map(|error| format!(" · error {:.1} %", error * 100.0)).unwrap_or_default();
        // Without a number that was asked for it goes on and on.
        let total = if self.total == Plan::MAX_SAMPLES { String::new() } else { format!("/{}", self.total) };
        format!("{chapter} · {picture} · {}{total} samples{error}", self.samples)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_title_tells_how_far_it_is() {
        let mut shown = Shown::new(Size::of::<2, 1>(), 64);
        assert_eq!(shown.title("Shadows", "acne"), "Shadows · acne · 0/64 samples");
        (shown.samples, shown.error) = (16, Some(0.0314));
        assert_eq!(shown.title("Shadows", "acne"), "Shadows · acne · 16/64 samples · error 3.1 %");
        shown.total = Plan::MAX_SAMPLES;
        assert_eq!(shown.title("Shadows", "acne"), "Shadows · acne · 16 samples · error 3.1 %");
    }

    #[test]
    fn the_old_picture_stays_in_the_new_size() {
        let mut shown = Shown::new(Size::of::<2, 1>(), 64);
        shown.raster.row_mut(0, 0, 1).fill(7);
        shown.restart(Size::of::<4, 1>(), 9);
        assert_eq!(shown.raster.pixels(), [7, 7, 0, 0]);
        assert_eq!((shown.samples, shown.total), (0, 9));
    }
}
