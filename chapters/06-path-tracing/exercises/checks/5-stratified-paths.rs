//! Checks exercise 6.5, stratified samples in a path.

use common::exercise::{Diagnosis, Finding, Verdict};

use super::{
    fixed_paths, garden,
    orders::{self, Shuffle},
    pixel_means::{Points, Spread, Trace, independent},
    point_sets,
};

/// What the student writes.
#[derive(Clone, Copy)]
pub(crate) struct Answer {
    /// Puts points into a random order.
    pub(crate) shuffle: Shuffle,
    /// The points of all n·n samples of a pixel.
    pub(crate) path_points: Points,
    /// The radiance along one path.
    pub(crate) trace: Trace,
}

/// Rows of the grids of the last question.
const SIDE: u16 = 5;
/// How often each pixel is computed.
const RUNS: u64 = 150;
/// What may be left of the variance of light of one and of two bounces. Measured with 60 seeds: 29.5 ± 1.1 % and
/// 53.9 ± 2.4 %, so that right points stay below by six standard deviations.
const MOST_LEFT: [f64; 2] = [0.36, 0.7];
/// How many standard deviations the means may be apart. A right answer misses it once in 100,000 times.
const SIGMAS: f64 = 4.5;

/// Accept stratified paths, or name what is wrong with them.
pub(crate) fn check(answer: Answer) -> Verdict {
    if orders::does_nothing(answer.shuffle) {
        return Err(Diagnosis::not_started("Nothing moves yet: `shuffle` leaves all points where they are."));
    }
    orders::check(answer.shuffle)?;
    point_sets::check(answer.path_points)?;
    fixed_paths::check(answer.trace)?;
    (1..).zip(MOST_LEFT).try_for_each(|(bounces, most)| gain(answer, bounces, most))
}

/// All together: the mean is right, and the variance is smaller than with independent points.
fn gain(answer: Answer, bounces: u32, most: f64) -> Verdict {
    let tracer = garden::tracer(bounces..=bounces);
    // Streams of their own: with the same ones both would err alike.
    let measure = |points: Points, seed| Spread::measure(&tracer, (points, answer.trace, SIDE), RUNS, seed);
    let (ours, theirs) = (measure(independent, 72), measure(answer.path_points, 73));
    let tried = format!("pixels with {SIDE}·{SIDE} samples, and the light of bounce number {bounces} alone");
    let allowed = SIGMAS * (ours.sigma * ours.sigma + theirs.sigma * theirs.sigma).sqrt();
    let is_near = (ours.mean - theirs.mean).abs() <= allowed;
    if !is_near {
        let advice = "The mean is wrong. Each sample for itself must be as random as before, so which cells go together must be left to \
                      chance.";
        let expected = format!("on average {:.4} ± {allowed:.4}, as with independent points", ours.mean);
        return Err(Finding { tried, got: format!("on average {:.4}", theirs.mean), expected, advice: advice.into() }
            .named("mean-off"));
    }
    let left = theirs.variance / ours.variance;
    if left > most {
        let advice = "The mean is right, but the samples are no better than independent ones. Does `path_points` stratify all three sets \
                      for every n?";
        let [got, expected] =
            [left, most].map(|share| format!("{:.0} % of the variance of independent points", share * 100.0));
        return Err(
            Finding { tried, got, expected: format!("at most {expected}"), advice: advice.into() }.named("no-gain")
        );
    }
    Ok(())
}
