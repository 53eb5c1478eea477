//! How the error falls as samples are added, in one dimension and in eight: regular samples against random ones.

use common::{Stream, parallel};

use super::Findings;
use crate::{
    chart::{Axis, Chart, Line},
    estimate::three_sigma,
    integrals::{Integral, MAX_DIMENSION, Placement},
    slope::log_log_slope,
};

/// How much is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// At most how many samples are taken.
    pub samples: u64,
    /// Over how many runs the random error is averaged.
    pub runs: usize,
    /// Seed of the random numbers.
    pub seed: u64,
}

/// How the error falls in one dimension.
#[derive(Clone, Debug, PartialEq)]
pub struct Convergence {
    /// The dimension D.
    pub dimension: usize,
    /// `[count, error]` of regular samples at the left ends of their cells.
    pub regular: Vec<[f64; 2]>,
    /// `[count, error]` of random samples; the error is the root of the mean square over all runs.
    pub random: Vec<[f64; 2]>,
    /// What the last error of the random samples should be: σ, the standard deviation of the function over √M.
    pub sigma: f64,
}

impl Convergence {
    // ANCHOR: measure
    /// Measure `integral` in one dimension.
    #[must_use]
    pub fn measure(integral: &Integral, dimension: usize, effort: Effort) -> Self {
        let value = (integral.value)(dimension);
        let regular = grids(dimension, effort.samples).into_iter().map(|per_axis| {
            let error = (integral.regular(dimension, per_axis, Placement::LeftEnds) - value).abs();
            [total(dimension, per_axis) as f64, error]
        });
        let regular = regular.collect();
        // Each run goes on from count to count.
        let counts: Vec<u64> = (4..64).map(|power| 1 << power).take_while(|count| *count <= effort.samples).collect();
        let runs = parallel::map(effort.runs, |run| {
            let mut random = Stream::new(effort.seed, run as u64, dimension as u64);
            let (mut sum, mut done) = (0.0, 0);
            let errors = counts.iter().map(|&count| {
                sum += (done..count).map(|_| integral.sample(dimension, &mut random)).sum::<f64>();
                done = count;
                sum / count as f64 - value
            });
            errors.collect::<Vec<f64>>()
        });
        let mean_square = |i: usize| runs.iter().map(|run| run[i] * run[i]).sum::<f64>() / runs.len().max(1) as f64;
        let random = counts.iter().enumerate().map(|(i, &count)| [count as f64, mean_square(i).sqrt()]).collect();
        let last = counts.last().copied().unwrap_or(1);
        Self { dimension, regular, random, sigma: three_sigma((integral.variance)(dimension), last) / 3.0 }
    }
    // ANCHOR_END: measure

    /// The orders that were measured, of regular and of random samples, where they can be told.
    #[must_use]
    pub fn slopes(&self) -> [Option<f64>; 2] {
        [log_log_slope(&self.regular), log_log_slope(&self.random)]
    }
}

/// Numbers of samples along each axis, in steps of about a quarter, that are at most `samples` in all.
fn grids(dimension: usize, samples: u64) -> Vec<u32> {
    let next = |n: &u32| Some((n + 1).max(n + n / 4));
    std::iter::successors(Some(2), next).take_while(|n| total(dimension, *n) <= samples).collect()
}

/// `per_axisᴰ`, or the largest number there is.
fn total(dimension: usize, per_axis: u32) -> u64 {
    std::iter::repeat_n(u64::from(per_axis), dimension).fold(1, u64::saturating_mul)
}

/// Measure an integral in all dimensions.
pub fn measure(integral: &Integral, effort: Effort, progress: &dyn Fn(&str)) -> Vec<Convergence> {
    let measure = |dimension| {
        progress(&format!("Integrating '{}' in dimension {dimension}", integral.name));
        Convergence::measure(integral, dimension, effort)
    };
    (1..=MAX_DIMENSION).map(measure).collect()
}

/// Tell of what was measured.
#[must_use]
pub fn findings(integral: &Integral, effort: Effort, all: &[Convergence]) -> Findings {
    let mut text = format!(
        "The error of the integral '{}' over the unit cube of dimension D, from M samples, and its slope\n\
         on a log-log plot. Random: root of the mean square over {} runs.\n\n\
         {:>18}regular, left ends{:>36}random\n\
         D{:>11}{:>12}{:>9}{:>9}   |{:>9}{:>12}{:>12}{:>9}{:>7}\n",
        integral.name, effort.runs, "", "", "M", "error", "slope", "-1/D", "M", "error", "expected", "slope", "-1/2"
    );
    for convergence in all {
        let [regular, random] = convergence.slopes().map(|s| s.map_or("-".into(), |s| format!("{s:.3}")));
        let [m, error] = convergence.regular.last().copied().unwrap_or_default();
        let [random_m, random_error] = convergence.random.last().copied().unwrap_or_default();
        let (d, sigma) = (convergence.dimension, convergence.sigma);
        text += &format!("{d}{m:>11}{error:>12.2e}{regular:>9}{:>9.3}   |", -1.0 / d as f64);
        text += &format!("{random_m:>9}{random_error:>12.2e}{sigma:>12.2e}{random:>9}{:>7}\n", -0.5);
    }
    Findings { text, chart: chart(integral, all) }
}

fn chart(integral: &Integral, all: &[Convergence]) -> Chart {
    let axis = |name| Axis { name, is_logarithmic: true };
    // All eight would hide each other.
    let shown = all.iter().filter(|c| c.dimension.is_power_of_two()).enumerate();
    let lines = shown.flat_map(|(color, c)| {
        [("regular", &c.regular, false), ("random", &c.random, true)].map(|(kind, points, is_dashed)| Line {
            name: format!("{kind} D={}", c.dimension),
            points: points.clone(),
            color,
            is_dashed,
        })
    });
    let title = format!("Regular and random samples of '{}'", integral.name);
    Chart { title, x: axis("samples"), y: axis("error"), lines: lines.collect() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrals::{INTEGRALS, MEAN, PRODUCT};

    const EFFORT: Effort = Effort { samples: 200_000, runs: 32, seed: 0 };

    #[test]
    fn regular_samples_suffer_from_dimension_and_random_ones_do_not() {
        for dimension in 1..=MAX_DIMENSION {
            let law = -1.0 / dimension as f64;
            // Of a sum of coordinates the law is exact.
            let [regular, random] = Convergence::measure(&MEAN, dimension, EFFORT).slopes().map(Option::unwrap);
            assert!((regular - law).abs() < 1e-9, "{dimension}: {regular}");
            assert!((random + 0.5).abs() < 0.06, "{dimension}: {random}");
            // A product comes near it with many samples along each axis, which eight dimensions do not have.
            let convergence = Convergence::measure(&PRODUCT, dimension, EFFORT);
            let [regular, random] = convergence.slopes().map(Option::unwrap);
            assert!(regular <= 0.7 * law && regular >= law - 1e-3, "{dimension}: {regular}");
            assert!((random + 0.5).abs() < 0.06, "{dimension}: {random}");
            let [_, last] = convergence.random.last().unwrap();
            assert!((0.6..1.5).contains(&(last / convergence.sigma)), "{last}");
        }
    }

    #[test]
    fn grids_stay_below_the_limit() {
        assert_eq!(grids(8, 6_561), [2, 3]);
        assert_eq!(grids(1, 15), [2, 3, 4, 5, 6, 7, 8, 10, 12, 15]);
        assert!(grids(3, 7).is_empty() && total(8, u32::MAX) == u64::MAX);
    }

    #[test]
    fn little_effort_is_told_too() {
        for integral in INTEGRALS {
            for samples in [0, 1, 300] {
                let effort = Effort { samples, runs: 1, seed: 1 };
                let all = measure(&integral, effort, &|_| {});
                let text = findings(&integral, effort, &all).text;
                assert!(text.lines().count() == 13 && text.lines().all(|l| l.chars().count() <= 100), "{text}");
                assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
            }
        }
    }
}
