//! How often an estimate is off by more than 3σ.

use common::{Stream, parallel};

use super::Findings;
use crate::{
    chart::{Axis, Chart, Line},
    estimate::three_sigma,
    integrals::Integral,
};

/// The share of runs outside 3σ where means follow the normal distribution: 1 − erf(3/√2).
pub const NORMAL_SHARE: f64 = 0.002_699_796;

/// Numbers of samples of a run.
pub const COUNTS: [u64; 6] = [4, 10, 32, 100, 320, 1000];

/// How many runs of `count` samples each were off by more than 3σ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outside {
    /// Samples of each run.
    pub count: u64,
    /// How many runs there were.
    pub runs: usize,
    /// How many of them were outside 3σ, where σ follows from the function's own variance.
    pub by_known: usize,
    /// How many of them were outside 3σ, where σ is estimated from the same samples.
    pub by_estimated: usize,
}

// ANCHOR: measure
impl Outside {
    /// Estimate `integral` in `dimension` again and again.
    #[must_use]
    pub fn measure(integral: &Integral, dimension: usize, count: u64, runs: usize, seed: u64) -> Self {
        let (value, variance) = ((integral.value)(dimension), (integral.variance)(dimension));
        // Some runs at a time.
        const CHUNK: usize = 256;
        let chunks = parallel::map(runs.div_ceil(CHUNK), |chunk| {
            let (mut by_known, mut by_estimated) = (0, 0);
            for run in chunk * CHUNK..runs.min((chunk + 1) * CHUNK) {
                let estimate = integral.random(dimension, count, &mut Stream::new(seed, run as u64, count));
                let error = (estimate.mean() - value).abs();
                by_known += usize::from(error > three_sigma(variance, count));
                by_estimated += usize::from(error > estimate.three_sigma());
            }
            [by_known, by_estimated]
        });
        let [by_known, by_estimated] = [0, 1].map(|i| chunks.iter().map(|chunk| chunk[i]).sum());
        Self { count, runs, by_known, by_estimated }
    }

    /// The shares of runs outside, by the known and by the estimated σ.
    #[must_use]
    pub fn shares(&self) -> [f64; 2] {
        [self.by_known, self.by_estimated].map(|outside| outside as f64 / self.runs.max(1) as f64)
    }
}
// ANCHOR_END: measure

/// Measure an integral with all numbers of samples.
pub fn measure(integral: &Integral, runs: usize, seed: u64, progress: &dyn Fn(&str)) -> Vec<Outside> {
    let measure = |count| {
        progress(&format!("Estimating '{}' from {count} samples, {runs} times", integral.name));
        Outside::measure(integral, 1, count, runs, seed)
    };
    COUNTS.into_iter().map(measure).collect()
}

/// Tell of what was measured.
#[must_use]
pub fn findings(integral: &Integral, all: &[Outside]) -> Findings {
    let runs = all.first().map_or(0, |outside| outside.runs);
    let chance = 3.0 * (NORMAL_SHARE / runs.max(1) as f64).sqrt();
    let mut text = format!(
        "The share of {runs} runs in which the estimate of the integral '{}' in one dimension\n\
         is off by more than 3σ: with the function's own σ, and with the σ estimated from the same samples.\n\n\
         {:>8}{:>12}{:>14}\n",
        integral.name, "samples", "known σ", "estimated σ"
    );
    for outside in all {
        let [known, estimated] = outside.shares().map(|share| format!("{:.3} %", 100.0 * share));
        text += &format!("{:>8}{known:>12}{estimated:>14}\n", outside.count);
    }
    text += &format!(
        "\nThe normal distribution has {:.3} %; chance alone moves a share by up to {:.3} % (3σ).\n",
        100.0 * NORMAL_SHARE,
        100.0 * chance
    );
    let line = |name: &str, i: usize| Line {
        name: name.into(),
        points: all.iter().map(|outside| [outside.count as f64, outside.shares()[i]]).collect(),
        color: i,
        is_dashed: false,
    };
    let normal = all.iter().map(|outside| [outside.count as f64, NORMAL_SHARE]).collect();
    let normal = Line { name: "normal distribution".into(), points: normal, color: 2, is_dashed: true };
    let axis = |name| Axis { name, is_logarithmic: true };
    let chart = Chart {
        title: format!("Runs outside 3σ, integral '{}'", integral.name),
        x: axis("samples"),
        y: axis("share"),
        lines: vec![line("known σ", 0), line("estimated σ", 1), normal],
    };
    Findings { text, chart }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrals::{INTEGRALS, PRODUCT, STEP};

    #[test]
    fn three_of_a_thousand_are_outside() {
        const RUNS: usize = 20_000;
        let chance = 4.0 * (NORMAL_SHARE / RUNS as f64).sqrt();
        for integral in INTEGRALS {
            for dimension in [1, 4] {
                let [known, estimated] = Outside::measure(&integral, dimension, 1000, RUNS, 3).shares();
                assert!((known - NORMAL_SHARE).abs() < chance, "{} {dimension}: {known}", integral.name);
                assert!((estimated - NORMAL_SHARE).abs() < chance + 5e-4, "{} {dimension}: {estimated}", integral.name);
            }
        }
    }

    /// Few samples estimate their own σ badly: all four on the same side of the step say that there is no error.
    #[test]
    fn an_estimated_sigma_deceives_where_samples_are_few() {
        let [known, estimated] = Outside::measure(&PRODUCT, 1, 4, 10_000, 3).shares();
        assert!(known < NORMAL_SHARE && estimated > 0.02, "{known} {estimated}");
        let [known, estimated] = Outside::measure(&STEP, 1, 4, 10_000, 3).shares();
        let [below, above] = [0.5_f64.sqrt(), 1.0 - 0.5_f64.sqrt()];
        let share = [below, above].map(|p| p * p * p * p).iter().sum::<f64>();
        assert!((estimated - share).abs() < 0.02 && known < 0.03, "{known} {estimated}");
    }

    #[test]
    fn a_few_runs_are_told_too() {
        let all = measure(&PRODUCT, 10, 0, &|_| {});
        let text = findings(&PRODUCT, &all).text;
        assert!(text.lines().all(|line| line.chars().count() <= 100) && !text.contains("NaN"), "{text}");
    }
}
