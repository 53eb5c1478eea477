//! A white matte surface under a sky of radiance 1 on all sides: every estimator has the mean 1, but not the same
//! variance.

use std::f32::consts::FRAC_1_PI;

use common::{Stream, Vec3, parallel};

use super::Findings;
use crate::{
    chart::{Axis, Chart, Line},
    direction_sampling::DirectionSampling,
    estimate::Estimate,
    unit_square::sample_unit_square,
};

// ANCHOR: estimator
/// One sample of the radiance that a white surface with this normal reflects: `f · L · cosθ / p`, where the albedo is
/// ρ = 1, so `f = ρ/π`, and L = 1.
pub fn sample(way: DirectionSampling, normal: Vec3, random: &mut Stream) -> f64 {
    let sample = way.sample(normal, sample_unit_square(random));
    let cos_theta = normal.dot(sample.direction).max(0.0);
    f64::from(FRAC_1_PI * cos_theta * sample.density.weight())
}
// ANCHOR_END: estimator

/// The variance of a sample, in closed form: the mean of its square, less 1.
#[must_use]
pub fn variance(way: DirectionSampling) -> f64 {
    match way {
        // (4 cosθ)² has the mean 16/3 above the horizon, and half of all samples are there.
        DirectionSampling::UniformSphere => 5.0 / 3.0,
        // (2 cosθ)² has the mean 4/3.
        DirectionSampling::UniformHemisphere => 1.0 / 3.0,
        // Every sample is 1.
        DirectionSampling::CosineHemisphere => 0.0,
    }
}

/// What was measured of one way to choose directions.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// The way.
    pub way: DirectionSampling,
    /// All samples.
    pub estimate: Estimate,
    /// `[count, mean]` on the way there.
    pub means: Vec<[f64; 2]>,
}

/// Measure all ways with this many samples each.
#[must_use]
pub fn measure(samples: u64, seed: u64) -> Vec<Measured> {
    parallel::map(DirectionSampling::ALL.len(), |i| {
        let way = DirectionSampling::ALL[i];
        let mut random = Stream::new(seed, way as u64, 0);
        let (mut estimate, mut means) = (Estimate::default(), Vec::new());
        let mut next = 1;
        for count in 1..=samples {
            estimate.add(sample(way, Vec3::Z, &mut random));
            if count == next || count == samples {
                means.push([count as f64, estimate.mean()]);
                next = (count + 1).max(count + count / 16);
            }
        }
        Measured { way, estimate, means }
    })
}

/// Tell of what was measured.
#[must_use]
pub fn findings(all: &[Measured]) -> Findings {
    let count = all.first().map_or(0, |measured| measured.estimate.count());
    let mut text = format!(
        "The radiance of a white matte surface under a sky of radiance 1, from {count} directions.\n\
         It is 1. All ways agree in the mean; they differ in the variance of a sample.\n\n\
         {:20}{:>10}{:>10}{:>12}{:>14}\n",
        "directions", "mean", "3σ", "variance", "closed form"
    );
    for Measured { way, estimate, .. } in all {
        text += &format!(
            "{:20}{:>10.5}{:>10.5}{:>12.5}{:>14.5}\n",
            way.name(),
            estimate.mean(),
            estimate.three_sigma(),
            estimate.variance(),
            variance(*way)
        );
    }
    let line = |(color, measured): (usize, &Measured)| Line {
        name: measured.way.name().into(),
        points: measured.means.clone(),
        color,
        is_dashed: false,
    };
    let chart = Chart {
        title: "A white surface under a sky of radiance 1".into(),
        x: Axis { name: "samples", is_logarithmic: true },
        y: Axis { name: "mean", is_logarithmic: false },
        lines: all.iter().enumerate().map(line).collect(),
    };
    Findings { text, chart }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_ways_agree_in_the_mean_and_have_their_variance() {
        for Measured { way, estimate, means } in measure(200_000, 1) {
            // A cosine sample may be dropped at the horizon, where the density is 0, but none was.
            let allowed = estimate.three_sigma() * 4.0 / 3.0 + 1e-7;
            assert!((estimate.mean() - 1.0).abs() <= allowed, "{way:?}: {estimate:?}");
            assert!((estimate.variance() - variance(way)).abs() < 0.02, "{way:?}: {estimate:?}");
            assert_eq!(means.last(), Some(&[200_000.0, estimate.mean()]));
            if way == DirectionSampling::CosineHemisphere {
                assert!(estimate.variance() < 1e-12);
            }
        }
    }

    #[test]
    fn the_frame_makes_no_difference() {
        let normal = Vec3::new(0.6, 0.0, -0.8);
        for way in DirectionSampling::ALL {
            let estimate =
                crate::estimate::monte_carlo(50_000, &mut Stream::new(2, 0, 0), |random| sample(way, normal, random));
            assert!((estimate.mean() - 1.0).abs() <= estimate.three_sigma() * 4.0 / 3.0 + 1e-5, "{way:?}");
        }
    }

    #[test]
    fn few_samples_are_told_too() {
        let text = findings(&measure(2, 0)).text;
        assert!(text.lines().count() == 7 && text.lines().all(|line| line.chars().count() <= 100), "{text}");
    }
}
