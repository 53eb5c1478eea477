//! Scenes that an independent program rendered, and how far our pictures are from its.
//!
//! The figures are of Mitsuba 3.9.1, 64×64 pixels, with a noise of ±0.02 % in the mean and at most 0.6 % in a block of 8×8
//! pixels. The scenes are described where they are built.

use common::{
    Error, Rgb,
    film::{Film, Size},
    renderer::{Plan, render},
};
use whitted::material::Fresnel;

use super::cornell_box;
use crate::{method::Method, path_tracer::PathTracer};

/// A scene that was rendered elsewhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// B3: the box with two boxes.
    Boxes,
    /// C3: the box with a gold ball. The reference has the approximation of Fresnel's equations.
    Gold,
}

impl Reference {
    /// Its tracer here.
    ///
    /// # Errors
    /// None.
    pub fn tracer(self) -> Result<PathTracer, Error> {
        let fresnel = if self == Self::Boxes { Fresnel::Exact } else { Fresnel::Approximate };
        cornell_box::tracer(self == Self::Boxes, Method { fresnel, ..Method::BEST })
    }

    /// The means of its blocks of 8×8 pixels there, row by row from the top.
    #[must_use]
    pub fn figures(self) -> Vec<Rgb> {
        let text = match self {
            Self::Boxes => include_str!("figures/B3.txt"),
            Self::Gold => include_str!("figures/C3.txt"),
        };
        let number = |word: &str| word.parse::<f32>().unwrap_or(f32::NAN);
        let lines = text.lines().filter(|line| !line.starts_with('#'));
        lines.map(|line| Rgb::from_slice(&line.split(' ').map(number).collect::<Vec<_>>())).collect()
    }
}

/// A picture of 64×64 pixels.
#[must_use]
pub fn film(tracer: &PathTracer, samples: u32) -> Film {
    let mut film = Film::new(Size::of::<64, 64>());
    render(tracer, &mut film, &Plan { samples, seed: 68, threads: 0 }, &());
    film
}

/// The means of its blocks of 8×8 pixels, and their standard errors.
#[must_use]
pub fn blocks(film: &Film) -> Vec<[Rgb; 2]> {
    let block = |i: u32| {
        let (x, y) = (i % 8 * 8, i / 8 * 8);
        let pixels = || (0..64).filter_map(|k| film.pixel(x + k % 8, y + k / 8));
        let variance: Rgb = pixels().map(|pixel| pixel.standard_error() * pixel.standard_error()).sum();
        let sigma = Rgb::from_array(variance.to_array().map(f32::sqrt)) / 64.0;
        [pixels().map(|pixel| pixel.mean()).sum::<Rgb>() / 64.0, sigma]
    };
    (0..64).map(block).collect()
}

/// The mean over all blocks.
#[must_use]
pub fn mean(blocks: &[[Rgb; 2]]) -> Rgb {
    blocks.iter().map(|block| block[0]).sum::<Rgb>() / 64.0
}

/// How far a picture is from the reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// The relative difference of the means of both pictures, by channel.
    pub mean: Rgb,
    /// The relative difference of each channel of each block, and the standard error of our own block beside it.
    pub blocks: Vec<[f32; 2]>,
}

impl Comparison {
    /// Compare a picture.
    #[must_use]
    pub fn of(film: &Film, reference: Reference) -> Self {
        let (ours, theirs) = (blocks(film), reference.figures());
        let relative = |([block, sigma], figure): (&[Rgb; 2], &Rgb)| {
            let [differs, noise] = [(*block / *figure - 1.0).abs(), *sigma / *figure].map(|color| color.to_array());
            [0, 1, 2].map(|channel| [differs[channel], noise[channel]])
        };
        Self {
            mean: (mean(&ours) / (theirs.iter().sum::<Rgb>() / 64.0) - 1.0).abs(),
            blocks: ours.iter().zip(&theirs).flat_map(relative).collect(),
        }
    }

    /// The median difference of the blocks; and in standard errors of our own.
    #[must_use]
    pub fn medians(&self) -> [f32; 2] {
        let median = |mut all: Vec<f32>| {
            all.sort_by(f32::total_cmp);
            all.get(all.len() / 2).copied().unwrap_or(f32::NAN)
        };
        [
            median(self.blocks.iter().map(|[differs, _]| *differs).collect()),
            median(self.blocks.iter().map(|[differs, noise]| differs / noise).collect()),
        ]
    }
}
