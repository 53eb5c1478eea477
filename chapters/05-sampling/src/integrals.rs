//! Integrals whose value is known, over unit cubes of any dimension: what methods are measured with.

use common::Stream;

use crate::estimate::{Estimate, monte_carlo};

/// The greatest dimension.
pub const MAX_DIMENSION: usize = 8;

// ANCHOR: integral
/// The integral of a function over the unit cube `[0, 1)ᴰ` of any dimension D from 1 to [`MAX_DIMENSION`].
#[derive(Clone, Copy, Debug)]
pub struct Integral {
    /// What to call it.
    pub name: &'static str,
    /// The function. Its argument has D coordinates.
    pub function: fn(&[f64]) -> f64,
    /// The value of the integral, given D.
    pub value: fn(usize) -> f64,
    /// The variance of the function at a uniformly random point, given D.
    pub variance: fn(usize) -> f64,
}

/// The integrals, from harmless to unpleasant. No variance grows with the dimension.
pub const INTEGRALS: [Integral; 3] = [MEAN, PRODUCT, STEP];

/// The names of [`INTEGRALS`].
pub const NAMES: [&str; 3] = [MEAN.name, PRODUCT.name, STEP.name];

/// The mean of the coordinates.
pub const MEAN: Integral = Integral {
    name: "mean",
    function: |x| x.iter().sum::<f64>() / x.len() as f64,
    value: |_| 0.5,
    variance: |dimension| 1.0 / (12.0 * dimension as f64),
};

/// The product of `1 + (x − ½)/√D` over the coordinates x.
pub const PRODUCT: Integral = Integral {
    name: "product",
    function: |x| {
        let scale = 1.0 / (x.len() as f64).sqrt();
        x.iter().map(|x| 1.0 + (x - 0.5) * scale).product()
    },
    value: |_| 1.0,
    // The square of a factor has the mean 1 + 1/(12 D).
    variance: |dimension| {
        let square = 1.0 + 1.0 / (12.0 * dimension as f64);
        std::iter::repeat_n(square, dimension).product::<f64>() - 1.0
    },
};

/// 1 where the first coordinate is below √½, and 0 elsewhere: an edge, like that of a shadow.
pub const STEP: Integral = Integral {
    name: "step",
    function: |x| if x.first().is_some_and(|x| *x < EDGE) { 1.0 } else { 0.0 },
    value: |_| EDGE,
    variance: |_| EDGE * (1.0 - EDGE),
};

/// Where [`STEP`] steps: an irrational number, so that no grid has a point there.
const EDGE: f64 = std::f64::consts::FRAC_1_SQRT_2;
// ANCHOR_END: integral

/// Where in its cell a regular sample lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Placement {
    /// At the end where all coordinates are least.
    LeftEnds,
    /// In the middle.
    Midpoints,
}

impl Integral {
    // ANCHOR: regular
    /// The mean of the function over a regular grid: `per_axis` samples along each axis, `per_axisᴰ` in all.
    #[must_use]
    pub fn regular(&self, dimension: usize, per_axis: u32, placement: Placement) -> f64 {
        let (dimension, per_axis) = (dimension.clamp(1, MAX_DIMENSION), per_axis.max(1));
        let shift = if placement == Placement::Midpoints { 0.5 } else { 0.0 };
        let coordinate = |cell: u32| (f64::from(cell) + shift) / f64::from(per_axis);
        let mut cell = [0; MAX_DIMENSION];
        let mut point = [coordinate(0); MAX_DIMENSION];
        let (mut sum, mut count) = (0.0, 0.0);
        loop {
            sum += (self.function)(&point[..dimension]);
            count += 1.0;
            // Step to the next cell, like the digits of a number.
            let Some(axis) = (0..dimension).find(|&axis| cell[axis] + 1 < per_axis) else { return sum / count };
            cell[..axis].fill(0);
            point[..axis].fill(coordinate(0));
            cell[axis] += 1;
            point[axis] = coordinate(cell[axis]);
        }
    }
    // ANCHOR_END: regular

    // ANCHOR: random
    /// The Monte Carlo estimate from `count` points that are uniform over the cube.
    pub fn random(&self, dimension: usize, count: u64, random: &mut Stream) -> Estimate {
        monte_carlo(count, random, |random| self.sample(dimension, random))
    }

    /// The function at a point that is uniform over the cube, whose density is 1.
    pub fn sample(&self, dimension: usize, random: &mut Stream) -> f64 {
        let mut point = [0.0; MAX_DIMENSION];
        let point = &mut point[..dimension.clamp(1, MAX_DIMENSION)];
        point.fill_with(|| f64::from(random.uniform()));
        (self.function)(point)
    }
    // ANCHOR_END: random
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Value and variance by a grid of midpoints, which is nearly exact where a function is smooth.
    #[test]
    fn values_and_variances_are_right() {
        for integral in [MEAN, PRODUCT] {
            for (dimension, per_axis) in [(1, 4000), (2, 400), (3, 80), (4, 30)] {
                let value = (integral.value)(dimension);
                let mean = integral.regular(dimension, per_axis, Placement::Midpoints);
                assert!((mean - value).abs() < 1e-10, "{} {dimension}", integral.name);
            }
        }
        for integral in INTEGRALS {
            for dimension in 1..=MAX_DIMENSION {
                let estimate = integral.random(dimension, 200_000, &mut Stream::new(1, dimension as u64, 0));
                let (value, variance) = ((integral.value)(dimension), (integral.variance)(dimension));
                let name = integral.name;
                assert!((estimate.mean() - value).abs() < estimate.three_sigma() * 4.0 / 3.0, "{name} {dimension}");
                assert!((estimate.variance() / variance - 1.0).abs() < 0.02, "{name} {dimension}");
            }
        }
    }

    /// The error of left ends is Δf/(2M) in one dimension, exactly so for a straight line.
    #[test]
    fn left_ends_of_a_straight_line() {
        for count in [1, 10, 1000] {
            let error = 0.5 - MEAN.regular(1, count, Placement::LeftEnds);
            assert!((error - 1.0 / (2.0 * f64::from(count))).abs() < 1e-12);
            // In more dimensions only the samples along one axis count.
            let error = 0.5 - MEAN.regular(2, count, Placement::LeftEnds);
            assert!((error - 1.0 / (2.0 * f64::from(count))).abs() < 1e-12);
        }
    }

    #[test]
    fn a_step_is_off_by_half_a_cell_at_most() {
        for count in 1..300 {
            let error = STEP.regular(1, count, Placement::Midpoints) - EDGE;
            assert!(error.abs() <= 0.5 / f64::from(count));
        }
    }

    #[test]
    fn senseless_dimensions_and_counts_do_no_harm() {
        for integral in INTEGRALS {
            assert!(integral.regular(0, 0, Placement::LeftEnds).is_finite());
            assert!(integral.regular(99, 1, Placement::LeftEnds).is_finite());
            assert!(integral.sample(99, &mut Stream::new(0, 0, 0)).is_finite());
        }
    }
}
