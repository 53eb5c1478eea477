//! An estimate: the mean of random samples, and how far from the truth it may be.

use common::Stream;

// ANCHOR: monte_carlo
/// The Monte Carlo estimate `∫ f ≈ (1/M) Σ f(z)/p(z)` from M = `count` samples.
///
/// `sample` draws a z of density p and returns `f(z)/p(z)`.
pub fn monte_carlo(count: u64, random: &mut Stream, mut sample: impl FnMut(&mut Stream) -> f64) -> Estimate {
    let mut estimate = Estimate::default();
    for _ in 0..count {
        estimate.add(sample(random));
    }
    estimate
}
// ANCHOR_END: monte_carlo

// ANCHOR: estimate
/// The mean and the variance of samples, kept up to date with every one.
///
/// Source: Welford, *Note on a Method for Calculating Corrected Sums of Squares and Products*, Technometrics 4(3), 1962.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    count: u64,
    mean: f64,
    /// Σ (x − mean)². A sum of x² would lose it in rounding where the mean is large.
    squares: f64,
}

impl Estimate {
    /// Take one more sample into account. One that is not a number makes the mean not a number, too.
    pub fn add(&mut self, sample: f64) {
        self.count += 1;
        let before = sample - self.mean;
        self.mean += before / self.count as f64;
        self.squares += before * (sample - self.mean);
    }

    /// How many samples there were.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Their mean, which estimates the integral; 0 if there were none.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// The variance D² of a single sample, estimated without bias; infinite for fewer than two samples, which say
    /// nothing about it.
    #[must_use]
    pub fn variance(&self) -> f64 {
        if self.count < 2 { f64::INFINITY } else { self.squares / (self.count - 1) as f64 }
    }

    /// Three standard deviations of the mean, `3σ = 3 D/√M`. In 99.7 % of all runs of many samples the mean is off by
    /// less than this.
    #[must_use]
    pub fn three_sigma(&self) -> f64 {
        three_sigma(self.variance(), self.count)
    }
    // ANCHOR_END: estimate

    /// The estimate from all samples of both.
    ///
    /// Source: Chan, Golub, LeVeque, *Updating Formulae and a Pairwise Algorithm for Computing Sample Variances*, 1979.
    #[must_use]
    pub fn merge(self, other: Self) -> Self {
        let count = self.count + other.count;
        if self.count == 0 || other.count == 0 {
            return if self.count == 0 { other } else { self };
        }
        let share = other.count as f64 / count as f64;
        let apart = other.mean - self.mean;
        let squares = self.squares + other.squares + apart * apart * share * self.count as f64;
        Self { count, mean: self.mean + apart * share, squares }
    }
}

/// Three standard deviations of the mean of `count` samples that have this variance each.
#[must_use]
pub fn three_sigma(variance: f64, count: u64) -> f64 {
    3.0 * (variance / count as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(samples: impl IntoIterator<Item = f64>) -> Estimate {
        let mut estimate = Estimate::default();
        samples.into_iter().for_each(|sample| estimate.add(sample));
        estimate
    }

    #[test]
    fn mean_and_variance_of_a_few_numbers() {
        let estimate = of([2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0]);
        assert_eq!((estimate.count(), estimate.mean()), (8, 5.0));
        assert!((estimate.variance() - 32.0 / 7.0).abs() < 1e-14);
        assert!((estimate.three_sigma() - 3.0 * (4.0_f64 / 7.0).sqrt()).abs() < 1e-14);
        assert_eq!((of([]).mean(), of([3.0]).mean(), of([3.0]).variance()), (0.0, 3.0, f64::INFINITY));
        assert!(of([1.0, f64::NAN]).mean().is_nan());
    }

    /// The textbook formula Σx² − (Σx)²/n fails this: 1e9 squared leaves no digits for the differences.
    #[test]
    fn a_large_mean_hides_no_variance() {
        let samples = || (0..1000).map(|i| 1e9 + f64::from(i % 2));
        assert!((of(samples()).variance() - 0.25 * 1000.0 / 999.0).abs() < 1e-9);
        let (sum, squares) = samples().fold((0.0, 0.0), |(s, q), x| (s + x, q + x * x));
        let textbook: f64 = (squares - sum * sum / 1000.0) / 999.0;
        assert!((textbook - 0.25).abs() > 0.01, "{textbook}");
    }

    #[test]
    fn merged_halves_are_the_whole() {
        let sample = |i: i32| f64::from(i * i % 17);
        let (whole, halves) = (of((0..100).map(sample)), of((0..30).map(sample)).merge(of((30..100).map(sample))));
        assert!((whole.mean() - halves.mean()).abs() < 1e-12 && (whole.variance() - halves.variance()).abs() < 1e-12);
        assert_eq!((whole.merge(of([])), of([]).merge(whole)), (whole, whole));
    }

    #[test]
    fn a_quarter_of_a_circle_by_chance() {
        let inside = |random: &mut Stream| {
            let [x, y] = [(); 2].map(|()| f64::from(random.uniform()));
            f64::from(u8::from(x * x + y * y < 1.0))
        };
        let estimate = monte_carlo(100_000, &mut Stream::new(5, 0, 0), inside);
        let quarter = std::f64::consts::FRAC_PI_4;
        assert!((estimate.mean() - quarter).abs() < estimate.three_sigma());
        assert!((estimate.variance() - quarter * (1.0 - quarter)).abs() < 0.01);
    }
}
