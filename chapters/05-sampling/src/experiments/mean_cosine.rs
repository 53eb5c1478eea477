//! The mean of cosθ, three lines of test that tell ways to choose a direction apart.

use std::f64::consts::{PI, SQRT_2};

use common::{Stream, Vec3, float, parallel};

use super::Findings;
use crate::{
    chart::{Axis, Chart, Line},
    cosine_hemisphere::sample_cosine_hemisphere,
    estimate::Estimate,
    uniform_hemisphere::{sample_uniform_hemisphere, sample_uniform_hemisphere_by_rejection},
    uniform_sphere::{point_in_ball, point_in_cube, sample_uniform_sphere_by_rejection},
    unit_square::sample_unit_square,
};

// ANCHOR: schemes
/// A way to choose a direction on the upper side of a surface, by intention uniform or in proportion to cosθ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    /// Uniform, in closed form.
    Uniform,
    /// Uniform, by rejection in a cube.
    UniformByRejection,
    /// Meant to be uniform, without the rejection: wrong.
    Cube,
    /// In proportion to cosθ: a point in the disc, lifted up.
    LiftedDisc,
    /// In proportion to cosθ: the normal and a random unit vector, added.
    NormalPlusUnitVector,
    /// Meant to be in proportion to cosθ: the normal and a random point in the unit ball, added. It is wrong, its
    /// density is (2/π) cos³θ.
    NormalPlusBall,
}

impl Scheme {
    /// A direction around the normal (0, 0, 1).
    pub fn direction(self, random: &mut Stream) -> Vec3 {
        match self {
            Self::Uniform => sample_uniform_hemisphere(sample_unit_square(random)),
            Self::UniformByRejection => sample_uniform_hemisphere_by_rejection(Vec3::Z, random),
            Self::Cube => {
                let direction = point_in_cube(random).normalize_or(Vec3::Z);
                direction.with_z(direction.z.abs())
            }
            Self::LiftedDisc => sample_cosine_hemisphere(sample_unit_square(random)),
            Self::NormalPlusUnitVector => (Vec3::Z + sample_uniform_sphere_by_rejection(random)).normalize_or(Vec3::Z),
            Self::NormalPlusBall => (Vec3::Z + point_in_ball(random)).normalize_or(Vec3::Z),
        }
    }

    /// The mean of cosθ in closed form.
    #[must_use]
    pub fn mean_cosine(self) -> f64 {
        match self {
            Self::Uniform | Self::UniformByRejection => 1.0 / 2.0,
            // ∫∫ √(1 + x² + y²) − √(x² + y²) over the unit square.
            Self::Cube => {
                let ln = |x: f64| float::ln_f64(x);
                let root3 = 3.0_f64.sqrt();
                root3 / 3.0 + ln(2.0 + root3) * 2.0 / 3.0 - PI / 18.0 - (SQRT_2 + ln(1.0 + SQRT_2)) / 3.0
            }
            Self::LiftedDisc | Self::NormalPlusUnitVector => 2.0 / 3.0,
            Self::NormalPlusBall => 4.0 / 5.0,
        }
    }
    // ANCHOR_END: schemes

    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Uniform,
        Self::UniformByRejection,
        Self::Cube,
        Self::LiftedDisc,
        Self::NormalPlusUnitVector,
        Self::NormalPlusBall,
    ];

    /// What to call it.
    #[must_use]
    pub fn name(self) -> &'static str {
        [
            "uniform",
            "uniform by rejection",
            "cube without rejection",
            "disc lifted",
            "normal + unit vector",
            "normal + point in ball",
        ][self as usize]
    }

    /// What it is meant to be, and whether it is.
    #[must_use]
    pub fn verdict(self) -> &'static str {
        match self {
            Self::Uniform | Self::UniformByRejection => "uniform",
            Self::LiftedDisc | Self::NormalPlusUnitVector => "cosine",
            Self::Cube => "wrong: not uniform",
            Self::NormalPlusBall => "wrong: cosine cubed",
        }
    }
}

/// Cells of the histogram.
const BINS: usize = 25;

/// What was measured of one scheme.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// The scheme.
    pub scheme: Scheme,
    /// The mean of cosθ.
    pub cosine: Estimate,
    /// The density of cosθ in cells of equal size from 0 to 1.
    pub density: Vec<f64>,
}

/// Measure all schemes with this many samples each.
#[must_use]
pub fn measure(samples: u64, seed: u64) -> Vec<Measured> {
    parallel::map(Scheme::ALL.len(), |i| {
        let scheme = Scheme::ALL[i];
        let mut random = Stream::new(seed, i as u64, 0);
        let (mut cosine, mut counts) = (Estimate::default(), [0_u64; BINS]);
        for _ in 0..samples {
            let cos_theta = f64::from(scheme.direction(&mut random).z);
            cosine.add(cos_theta);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 1")]
            let bin = (cos_theta * BINS as f64) as usize;
            counts[bin.min(BINS - 1)] += 1;
        }
        let density = counts.map(|count| (count * BINS as u64) as f64 / samples.max(1) as f64).into();
        Measured { scheme, cosine, density }
    })
}

/// Tell of what was measured.
#[must_use]
pub fn findings(all: &[Measured]) -> Findings {
    let count = all.first().map_or(0, |measured| measured.cosine.count());
    let mut text = format!(
        "The mean of the cosine to the normal, over {count} directions of each scheme.\n\n\
         {:24}{:>10}{:>10}{:>14}   {}\n",
        "scheme", "mean", "3σ", "closed form", "what it is"
    );
    for Measured { scheme, cosine, .. } in all {
        text += &format!(
            "{:24}{:>10.5}{:>10.5}{:>14.5}   {}\n",
            scheme.name(),
            cosine.mean(),
            cosine.three_sigma(),
            scheme.mean_cosine(),
            scheme.verdict()
        );
    }
    let line = |(color, measured): (usize, &Measured)| {
        let points = measured.density.iter().enumerate().map(|(i, density)| [(i as f64 + 0.5) / BINS as f64, *density]);
        Line { name: measured.scheme.name().into(), points: points.collect(), color, is_dashed: false }
    };
    let axis = |name| Axis { name, is_logarithmic: false };
    let lines = all.iter().enumerate().map(line).collect();
    Findings {
        text,
        chart: Chart { title: "Density of the cosine".into(), x: axis("cosine"), y: axis("density"), lines },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mean_cosines_are_those_of_the_closed_forms() {
        for Measured { scheme, cosine, density } in measure(300_000, 2) {
            let off = (cosine.mean() - scheme.mean_cosine()).abs();
            assert!(off < cosine.three_sigma() * 4.0 / 3.0, "{scheme:?}: {cosine:?}");
            let whole: f64 = density.iter().sum::<f64>() / BINS as f64;
            assert!((whole - 1.0).abs() < 1e-9, "{whole}");
        }
        // By quadrature of the integral that the closed form comes from.
        assert!((Scheme::Cube.mean_cosine() - 0.515_593).abs() < 1e-6);
    }

    /// The test of the mean tells right and wrong apart.
    #[test]
    fn wrong_schemes_are_far_outside_three_sigma() {
        let measured = measure(300_000, 3);
        for (wrong, claimed) in [(Scheme::Cube, 0.5), (Scheme::NormalPlusBall, 2.0 / 3.0)] {
            let cosine = measured[wrong as usize].cosine;
            assert!((cosine.mean() - claimed).abs() > 5.0 * cosine.three_sigma(), "{wrong:?}");
        }
    }

    /// A corner of the cube is √3 away and a face 1, and a cone holds points in proportion to the cube of that.
    #[test]
    fn the_corners_of_a_cube_are_crowded() {
        let near = |axis: Vec3| {
            let mut random = Stream::new(4, 0, 0);
            (0..2_000_000).filter(|_| Scheme::Cube.direction(&mut random).dot(axis) > 0.9995).count() as f64
        };
        let ratio = near(Vec3::ONE.normalize()) / near(Vec3::Z);
        assert!((ratio - 27.0_f64.sqrt()).abs() < 0.6, "{ratio}");
    }

    #[test]
    fn few_samples_are_told_too() {
        let text = findings(&measure(2, 0)).text;
        assert!(text.lines().count() == 9 && text.lines().all(|line| line.chars().count() <= 100), "{text}");
    }
}
