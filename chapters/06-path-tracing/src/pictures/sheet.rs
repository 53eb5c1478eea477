//! Several ways to look at a scene on one sheet, each with its own number of samples, named and measured.

use std::sync::Arc;

use common::{
    Rgb, Stream, Vec2,
    color::luminance,
    drawing::{
        CHALK, Drawing, FAINT, SLATE,
        lettering::{Align, Lettering},
    },
    picture::{FilmPoint, Integrator},
    story::{Story, Untold, number, triple},
};
use sampling::{estimate::Estimate, unit_square::sample_unit_square};
use whitted::probe::Listener;

use crate::path_tracer::PathTracer;

/// Panels in rows and columns, with a line of text above and below each.
pub(super) struct Sheet {
    columns: u8,
    panels: Vec<Panel>,
    size: Vec2,
    drawing: Drawing,
}

/// One of the panels.
pub(super) struct Panel {
    /// What is seen there.
    pub(super) tracer: Arc<PathTracer>,
    /// Samples of each of its pixels. It has them all at once, for each sample of the picture.
    pub(super) samples: u32,
    /// What of them is shown.
    pub(super) shown: Shown,
    /// What stands above.
    pub(super) title: String,
    /// What stands below.
    pub(super) caption: String,
}

/// What is shown of the samples of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Shown {
    /// Their mean: the picture.
    Mean,
    /// The standard error of their luminance as a color: black for 0, white for this much and more.
    Error(f32),
}

impl Sheet {
    const GAP: f32 = 12.0;
    const TITLE: f32 = 34.0;
    const CAPTION: f32 = 28.0;

    /// Width and height of a sheet of panels.
    pub(super) const fn page(columns: u8, rows: u8, panel: Vec2) -> Vec2 {
        Vec2::new(
            Self::GAP + (panel.x + Self::GAP) * columns as f32,
            (panel.y + Self::TITLE + Self::CAPTION) * rows as f32 + Self::GAP / 2.0,
        )
    }

    /// Lay out panels of this size from left to right, then from top to bottom.
    pub(super) fn new(columns: u8, size: Vec2, panels: Vec<Panel>) -> Self {
        let rows = panels.len().div_ceil(columns.into());
        let page = Self::page(columns, u8::try_from(rows).unwrap_or(u8::MAX), size);
        let mut drawing = Drawing::new(page, SLATE);
        for (i, panel) in panels.iter().enumerate() {
            let at = Self::corner(i, columns, size);
            let letters = |size, color| Lettering::new(size, color).aligned(Align::Center);
            drawing.text(&panel.title, at + Vec2::new(size.x / 2.0, -10.0), letters(18.0, CHALK));
            drawing.text(&panel.caption, at + Vec2::new(size.x / 2.0, size.y + 20.0), letters(15.0, FAINT));
        }
        Self { columns, panels, size, drawing }
    }

    /// The upper left corner of a panel.
    #[expect(clippy::cast_precision_loss, reason = "few panels")]
    fn corner(i: usize, columns: u8, size: Vec2) -> Vec2 {
        let cell = Vec2::new((i % usize::from(columns)) as f32, (i / usize::from(columns)) as f32);
        let step = Vec2::new(size.x + Self::GAP, size.y + Self::TITLE + Self::CAPTION);
        Vec2::new(Self::GAP, Self::TITLE) + cell * step
    }
}

impl Panel {
    /// The color of a place in the panel; a pixel reaches `pixel` units to the right and down.
    fn color(&self, local: Vec2, pixel: Vec2, size: Vec2, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let mut sum = Rgb::ZERO;
        let mut brightness = Estimate::default();
        for sample in 0..self.samples {
            // Several samples lie anywhere in the pixel, a lone one in its middle.
            let offset = if self.samples == 1 { Vec2::ZERO } else { sample_unit_square(random) - 0.5 };
            let ray = self.tracer.camera.ray(FilmPoint { position: local + offset * pixel, size });
            // Only the first is told.
            let radiance = if sample == 0 {
                self.tracer.trace(ray, random, &mut Listener(&mut *story))
            } else {
                self.tracer.trace(ray, random, &mut Untold)
            };
            brightness.add(luminance(radiance).into());
            sum += radiance;
        }
        match self.shown {
            Shown::Mean => {
                let mean = sum / self.samples as f32;
                story.tell(|| format!("mean of {} such samples: {}", self.samples, triple(mean)));
                mean
            }
            Shown::Error(most) => {
                #[expect(clippy::cast_possible_truncation, reason = "a color")]
                let error = brightness.three_sigma() as f32 / 3.0;
                story.tell(|| format!("standard error of {} such samples: {}", self.samples, number(error)));
                heat(error / most)
            }
        }
    }
}

impl Integrator for Sheet {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let place = self.drawing.place(point);
        let pixel = self.drawing.place(FilmPoint { position: point.position + 1.0, ..point }) - place;
        for (i, panel) in self.panels.iter().enumerate() {
            let local = place - Self::corner(i, self.columns, self.size);
            if local.cmpge(Vec2::ZERO).all() && local.cmplt(self.size).all() {
                return panel.color(local, pixel, self.size, random, story);
            }
        }
        self.drawing.radiance(point, random, story)
    }
}

/// From black over violet, red and yellow to white, for a number from 0 to 1.
fn heat(share: f32) -> Rgb {
    const COLORS: [Rgb; 5] =
        [Rgb::ZERO, Rgb::new(0.10, 0.02, 0.22), Rgb::new(0.66, 0.05, 0.10), Rgb::new(1.0, 0.55, 0.05), Rgb::ONE];
    let at = share.clamp(0.0, 1.0) * 4.0;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 4")]
    let step = (at as usize).min(3);
    COLORS[step].lerp(COLORS[step + 1], at - step as f32)
}
