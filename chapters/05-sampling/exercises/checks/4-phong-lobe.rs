//! Checks exercise 5.4, a glossy lobe.

use std::f64::consts::TAU;

use common::{
    Stream, Vec2, Vec3,
    exercise::{Diagnosis, Finding, Verdict, trying},
    float,
};
use sampling::{direction_sample::DirectionSample, estimate::Estimate, unit_square::sample_unit_square};

use super::{
    glossy::glossy,
    tally::Tally,
    words::{about, is_near, number, pair, triple},
};

/// What the student writes.
#[derive(Clone, Copy)]
pub(crate) struct Answer {
    /// A direction in the lobe around z, by exponent and point of the square.
    pub(crate) sample_phong_lobe: fn(f32, Vec2) -> Vec3,
    /// Its density, by exponent and cosine.
    pub(crate) phong_lobe_pdf: fn(f32, f32) -> f32,
    /// The same around the mirror direction, by normal, direction to the viewer, exponent and point of the square.
    pub(crate) sample_glossy: fn(Vec3, Vec3, f32, Vec2) -> Option<DirectionSample>,
}

/// Exponents that are tried.
const EXPONENTS: [f32; 6] = [10.0, 0.0, 1.0, 2.5, 100.0, 1000.0];
/// Directions drawn for each of them.
const COUNT: u32 = 20_000;
/// Rows and columns of the χ² test: heights of equal share, and angles.
pub(super) const CELLS: [u8; 2] = [9, 9];

/// Accept a lobe, or name what is wrong with it.
pub(crate) fn check(answer: Answer) -> Verdict {
    let draw = |n: f32, u: Vec2| {
        let tried = || format!("`sample_phong_lobe` with exponent {n} and u = {}", pair(u));
        trying(tried, || (answer.sample_phong_lobe)(n, u))
    };
    let pdf = |n: f32, cosine: f32| {
        let tried = || format!("`phong_lobe_pdf` with exponent {n} and cos_alpha {cosine}");
        f64::from(trying(tried, || (answer.phong_lobe_pdf)(n, cosine)))
    };
    if [[0.2, 0.3], [0.5, 0.6], [0.8, 0.9]].into_iter().all(|u| draw(10.0, Vec2::from_array(u)) == Vec3::Z) {
        return Err(Diagnosis::not_started("All directions are the same: `sample_phong_lobe` returns the z axis."));
    }
    EXPONENTS.into_iter().try_for_each(|n| lobe(n, &|u| draw(n, u)))?;
    if EXPONENTS.into_iter().all(|n| pdf(n, 0.9) == 0.0) {
        let message = "`sample_phong_lobe` is right. Now for `phong_lobe_pdf`, which returns 0 for every direction.";
        return Err(Diagnosis::new("pdf-not-started", message));
    }
    densities(&pdf)?;
    glossy(answer.sample_glossy)
}

/// The share of the lobe's directions whose cosine is smaller.
pub(super) fn share(n: f32, cosine: f64) -> f64 {
    if cosine > 0.0 { float::exp_f64((f64::from(n) + 1.0) * float::ln_f64(cosine)) } else { 0.0 }
}

/// The right density.
pub(super) fn pdf_of(n: f32, cosine: f64) -> f64 {
    let n = f64::from(n);
    if cosine > 0.0 { (n + 1.0) / TAU * float::exp_f64(n * float::ln_f64(cosine)) } else { 0.0 }
}

/// The cell of a direction around z.
pub(super) fn cell(n: f32, direction: Vec3) -> usize {
    let turn = f64::from(float::atan2(direction.y, direction.x)) / TAU;
    let place = |share: f64, cells: u8| {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to the number of cells")]
        let cell = (share.clamp(0.0, 1.0 - 1e-12) * f64::from(cells)) as usize;
        cell
    };
    place(share(n, direction.z.into()), CELLS[0]) * usize::from(CELLS[1]) + place(turn - turn.floor(), CELLS[1])
}

/// Directions of one exponent around z.
fn lobe(n: f32, draw: &dyn Fn(Vec2) -> Vec3) -> Verdict {
    let mut random = Stream::new(56, n.to_bits().into(), 0);
    let (mut mean, mut tally) = (Estimate::default(), Tally::even(usize::from(CELLS[0]) * usize::from(CELLS[1])));
    let last = 1.0 - f32::EPSILON / 2.0;
    let ends = [[0.0, 0.0], [last, 0.0], [0.0, last], [last, last]].map(Vec2::from_array);
    let drawn = (0..COUNT).map(|_| sample_unit_square(&mut random));
    for (i, u) in ends.into_iter().chain(drawn).enumerate() {
        let direction = draw(u);
        let tried = format!("`sample_phong_lobe` with exponent {n} and u = {}", pair(u));
        let wrong = |name, expected: &str, advice: &str| {
            let (got, expected) = (triple(direction), expected.into());
            Err(Finding { tried: tried.clone(), got, expected, advice: advice.into() }.named(name))
        };
        if !is_near(direction.length().into(), 1.0, 1e-4) {
            let advice = "The vector has not the length 1. With the height c, its distance from the axis is √(1 − c²).";
            return wrong("not-a-unit-vector", "a unit vector", advice);
        }
        if direction.z < 0.0 {
            return wrong("behind", "z ≥ 0", "The lobe ends at right angles to its axis: its height goes from 0 to 1.");
        }
        if i >= ends.len() {
            mean.add(direction.z.into());
            tally.add(cell(n, direction));
        }
    }
    if tally.fits() {
        return Ok(());
    }
    let n64 = f64::from(n);
    let is = |expected: f64| (mean.mean() - expected).abs() < mean.three_sigma() * 1.5 + 1e-4;
    let right = (n64 + 1.0) / (n64 + 2.0);
    let (name, advice) = if is(right) {
        (
            "not-uniform-around",
            "The heights are right, but the angles around the axis are not all equally likely. Take 2π u.y.",
        )
    } else if is(n64 / (n64 + 1.0)) {
        ("exponent-one-off", "These are directions of the exponent n − 1: the root is the (n + 1)-th, not the n-th.")
    } else if is((n64 + 2.0) / (n64 + 3.0)) {
        (
            "exponent-one-off",
            "These are directions of the exponent n + 1: the root is the (n + 1)-th, not the (n + 2)-th.",
        )
    } else if is(1.0 / (n64 + 2.0)) {
        ("power-for-root", "The number was raised to the power n + 1, where the root was meant: u.x^(1 / (n + 1)).")
    } else if is(0.5) || is(2.0 / 3.0) {
        ("exponent-ignored", "These are directions of another exponent, whatever n is.")
    } else {
        ("wrong-lobe", "The share of directions with a cosine below c must be c^(n + 1).")
    };
    Err(Finding {
        tried: format!("`sample_phong_lobe` with exponent {n} and {COUNT} uniform points u"),
        got: format!("a mean cosine of {}, and {}", number(mean.mean()), tally.got()),
        expected: format!("a mean cosine of {}, and {}", number(right), tally.wanted()),
        advice: advice.into(),
    }
    .named(name))
}

/// Densities of all exponents.
fn densities(pdf: &dyn Fn(f32, f32) -> f64) -> Verdict {
    let questions = || EXPONENTS.into_iter().flat_map(|n| [0.999_f32, 0.97, 0.8, 0.4].map(|cosine| (n, cosine)));
    let is = |right: &dyn Fn(f64, f64) -> f64| {
        questions().all(|(n, cosine)| {
            let right = right(n.into(), cosine.into());
            (pdf(n, cosine) - right).abs() <= right * 1e-3 + 1e-30
        })
    };
    let power = |n: f64, cosine: f64| float::exp_f64(n * float::ln_f64(cosine));
    let right = |n: f64, cosine: f64| (n + 1.0) / TAU * power(n, cosine);
    let wrong = |n: f32, cosine: f32| {
        !is_near(pdf(n, cosine), pdf_of(n, cosine.into()), pdf_of(n, cosine.into()) * 1e-3 + 1e-30)
    };
    if let Some((n, cosine)) = questions().find(|&(n, cosine)| wrong(n, cosine)) {
        let (name, advice) = if is(&power) || is(&|n, c| power(n, c) * (n + 1.0)) {
            ("not-normalized", "The power alone does not integrate to 1: it must be multiplied by (n + 1) / (2π).")
        } else if is(&|n, c| right(n, c) * (n + 2.0) / (n + 1.0)) {
            (
                "factor-of-the-brdf",
                "(n + 2) / (2π) belongs to a surface that shall send back no more than it gets; a cosine stands \
                                    below that integral. A density has none, and its factor is (n + 1) / (2π).",
            )
        } else if is(&|n, c| right(n, c) * n / (n + 1.0)) {
            ("exponent-one-off", "The factor is (n + 1) / (2π): the integral of cⁿ from 0 to 1 is 1 / (n + 1).")
        } else if is(&|n, c| 2.0 * right(n, c)) || is(&|n, c| right(n, c) / 2.0) {
            ("half-or-twice", "The angle around the axis goes through 2π, neither π nor 4π.")
        } else if is(&|n, c| right(n, c) * c) {
            (
                "cosine-too-many",
                "This has one cosine too many. The density is that of directions, not of the light that they bring.",
            )
        } else {
            ("wrong-pdf", "Work it out for one cosine on paper: (n + 1) / (2π) times the cosine to the power n.")
        };
        let integral: f64 = (0..4000).map(|i| pdf(n, (i as f32 + 0.5) / 4000.0)).sum::<f64>() / 4000.0 * TAU;
        return Err(Finding {
            tried: format!("`phong_lobe_pdf` with exponent {n} and cos_alpha {cosine}"),
            got: format!(
                "{}; over the hemisphere your density integrates to {}",
                about(pdf(n, cosine)),
                about(integral)
            ),
            expected: format!("{}; it must integrate to 1", about(pdf_of(n, cosine.into()))),
            advice: advice.into(),
        }
        .named(name));
    }
    for (n, cosine) in [(2.0, -0.5), (3.0, -0.5), (0.0, -1.0), (10.0, -0.1), (2.5, -0.3)] {
        if pdf(n, cosine) != 0.0 {
            let tried = format!("`phong_lobe_pdf` with exponent {n} and cos_alpha {cosine}");
            let advice = "Behind the lobe no direction is ever drawn, so its density is 0 there. An even power of a negative cosine \
                          is positive.";
            let (got, expected) = (pdf(n, cosine).to_string(), "0".into());
            return Err(Finding { tried, got, expected, advice: advice.into() }.named("behind-not-zero"));
        }
    }
    Ok(())
}
