//! Means over all samples of a pixel: what they are on average, and how much they vary.

use common::{Rgb, Stream, Vec2, color::luminance, exercise::trying, picture::FilmPoint};
use path_tracing::path_tracer::PathTracer;
use sampling::{estimate::Estimate, unit_square::sample_unit_square};

/// Makes the points of all n·n samples of a pixel.
pub(crate) type Points = fn(u16, &mut Stream) -> Vec<[Vec2; 3]>;
/// Follows one path through a pixel, by its upper left corner.
pub(crate) type Trace = fn(&PathTracer, FilmPoint, [Vec2; 3], &mut Stream) -> Rgb;

/// Points that know nothing of each other.
pub(crate) fn independent(n: u16, random: &mut Stream) -> Vec<[Vec2; 3]> {
    (0..n * n).map(|_| [(); 3].map(|()| sample_unit_square(random))).collect()
}

/// The mean over all samples of a pixel.
pub(crate) fn pixel_mean(
    tracer: &PathTracer,
    pixel: FilmPoint,
    (points, trace, n): (Points, Trace, u16),
    random: &mut Stream,
) -> Rgb {
    let points = points(n, random);
    let count = points.len().max(1) as f32;
    points.into_iter().map(|points| trace(tracer, pixel, points, random)).sum::<Rgb>() / count
}

/// What pixels all over a small film are on average, and the mean of their variances.
#[derive(Clone, Copy)]
pub(crate) struct Spread {
    /// All pixels of all runs.
    pub(crate) mean: f64,
    /// The standard error of that mean.
    pub(crate) sigma: f64,
    /// How much a pixel varies from run to run.
    pub(crate) variance: f64,
}

impl Spread {
    /// Measure so many runs of 40 pixels all over a film of 320 × 200, by their luminance.
    pub(crate) fn measure(tracer: &PathTracer, way: (Points, Trace, u16), runs: u64, seed: u64) -> Self {
        let size = Vec2::new(320.0, 200.0);
        let pixel = |i: usize| {
            let position = Vec2::new((i % 8) as f32, (i / 8) as f32) * 40.0 + 20.0;
            let mut estimate = Estimate::default();
            for run in 0..runs {
                let mut random = Stream::new(seed, i as u64, run);
                let tried = || format!("`path_points({}, random)` and `trace` with its points", way.2);
                let mean = trying(tried, || pixel_mean(tracer, FilmPoint { position, size }, way, &mut random));
                estimate.add(luminance(mean).into());
            }
            estimate
        };
        let pixels: Vec<_> = (0..40).map(pixel).collect();
        let mean_of = |value: fn(&Estimate) -> f64| pixels.iter().map(value).sum::<f64>() / pixels.len() as f64;
        let variance = mean_of(Estimate::variance);
        let sigma = (variance / (runs as f64 * pixels.len() as f64)).sqrt();
        Self { mean: mean_of(Estimate::mean), sigma, variance }
    }
}
