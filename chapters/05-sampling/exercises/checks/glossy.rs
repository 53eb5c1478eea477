//! Checks the lobe around the mirror direction, for exercise 5.4.

use common::{
    Basis, Stream, Vec2, Vec3,
    exercise::{Diagnosis, Finding, Verdict, trying},
};
use sampling::{
    direction_sample::{Density, DirectionSample},
    unit_square::sample_unit_square,
};

use super::{
    phong_lobe::{cell, pdf_of},
    tally::Tally,
    view::View,
    words::{about, is_near, number, pair, triple},
};

type Draw = fn(Vec3, Vec3, f32, Vec2) -> Option<DirectionSample>;

/// Directions drawn for each view.
const COUNT: u32 = 20_000;

/// Accept directions around the mirror direction, or name what is wrong with them.
pub(super) fn glossy(draw: Draw) -> Verdict {
    let tilted = Vec3::new(0.3, 0.8, -0.5);
    let views = [
        View::at(Vec3::Y, 30.0, 100.0),
        View::at(Vec3::Z, 0.0, 10.0),
        View::at(-Vec3::Z, 70.0, 20.0),
        View::at(tilted, 85.0, 5.0),
        View::at(tilted, 60.0, 1000.0),
        View::at(Vec3::X, 45.0, 1.0),
    ];
    let us = [[0.9, 0.2], [0.6, 0.7], [0.95, 0.5]].map(Vec2::from_array);
    if us.iter().all(|u| draw(Vec3::Y, Vec3::Y, 10.0, *u).is_none()) {
        let message = "The lobe is right. Now for `sample_glossy`, which returns `None` whatever it is asked. If you have written \
                       it, your lobe points into the surface: `reflect` wants the direction in which light travels, -to_viewer.";
        return Err(Diagnosis::new("glossy-not-started", message));
    }
    views.iter().try_for_each(|view| seen(view, draw))
}

/// Directions of one view.
fn seen(view: &View, draw: Draw) -> Verdict {
    let mut random = Stream::new(57, view.exponent.to_bits().into(), 0);
    let shares = view.shares();
    let below = shares.last().copied().unwrap_or_default();
    let (mut tally, mut mean, mut dropped) = (Tally::new(shares), Vec3::ZERO, 0);
    let (mirrored, basis) = (view.mirrored(), Basis::around(view.mirrored()));
    let mut densities = Ok(());
    for _ in 0..COUNT {
        let u = sample_unit_square(&mut random);
        let tried = || format!("{} and u = {}", view.words(), pair(u));
        let Some(sample) = trying(tried, || draw(view.normal, view.to_viewer, view.exponent, u)) else {
            dropped += 1;
            tally.add(usize::MAX);
            continue;
        };
        let wrong = |name, got: String, expected: String, advice: &str| {
            Err(Finding { tried: tried(), got, expected, advice: advice.into() }.named(name))
        };
        let direction = sample.direction;
        if !is_near(direction.length().into(), 1.0, 1e-4) {
            let advice = "A vector of the lobe is turned, not stretched: `Basis::around(axis).to_world(local)` keeps its length.";
            return wrong("glossy-not-a-unit-vector", triple(direction), "a unit vector".into(), advice);
        }
        if direction.dot(view.normal) < -1e-6 {
            let advice = "This direction points into the surface. Compare it with the normal, and return `None` if the cosine is not \
                          above 0.";
            return wrong("below-the-horizon", format!("the direction {}", triple(direction)), "`None`".into(), advice);
        }
        mean += direction / COUNT as f32;
        tally.add(cell(view.exponent, basis.to_local(direction)));
        densities = densities.and_then(|()| density(view, &sample, &wrong));
    }
    // First the directions: a wrong one has a wrong density, too.
    let toward = mean.normalize_or_zero();
    let told = |got: String, expected: String, name, advice: &str| {
        let tried = format!("{} and {COUNT} uniform points u", view.words());
        Err(Finding { tried, got, expected, advice: advice.into() }.named(name))
    };
    let lost = f64::from(dropped) / f64::from(COUNT);
    if (lost - below).abs() > 0.03 && below > 0.05 && lost < 0.005 {
        let advice = "Nothing is dropped: was the direction drawn again or turned up? Then directions above the surface are likelier \
                      than your density says.";
        let got = "no direction that is `None`".into();
        return told(got, format!("`None` for the share {} of all u", about(below)), "never-dropped", advice);
    }
    if !tally.fits() || (below == 0.0 && dropped > 0) {
        let got = format!("directions around {}, {} dropped, and {}", triple(toward), about(lost), tally.got());
        let axes = [mirrored, view.normal, view.to_viewer];
        // Straight on, all three are the same; then the first one counts.
        let closer = |best: Vec3, axis: Vec3| if toward.dot(axis) > toward.dot(best) + 0.01 { axis } else { best };
        let nearest = axes.into_iter().fold(mirrored, closer);
        let (name, advice) = if nearest == view.normal && nearest != mirrored {
            ("around-the-normal", "The lobe lies around the normal. Its axis is the mirror direction.")
        } else if nearest == view.to_viewer && nearest != mirrored {
            (
                "toward-the-viewer",
                "The lobe points back to the viewer: `reflect` wants a direction toward the surface, `-to_viewer`.",
            )
        } else {
            (
                "wrong-directions",
                "Draw around z, turn z to the mirror direction, and drop what points into the surface, nothing else.",
            )
        };
        return told(
            got,
            format!("directions around {}, {} dropped, and {}", triple(mirrored), about(below), tally.wanted()),
            name,
            advice,
        );
    }
    densities
}

/// The density of one direction.
fn density(
    view: &View,
    sample: &DirectionSample,
    wrong: &dyn Fn(&'static str, String, String, &str) -> Verdict,
) -> Verdict {
    let to_mirrored = f64::from(sample.direction.dot(view.mirrored()));
    let to_normal = f64::from(sample.direction.dot(view.normal));
    let right = pdf_of(view.exponent, to_mirrored);
    // The cosine is rounded to an f32, and the power makes that error as many times as large.
    let slack = 2e-3 + f64::from(view.exponent) * 1e-6 / to_mirrored.max(1e-3);
    let is = |pdf: f64, other: f64| (pdf - other).abs() <= other * slack + 1e-9;
    match sample.density {
        Density::SolidAngle(pdf) if is(pdf.into(), right) => Ok(()),
        Density::SolidAngle(pdf) => {
            let (name, advice) = if is(pdf.into(), pdf_of(view.exponent, to_normal)) {
                (
                    "angle-to-the-normal",
                    "This is the density for the angle to the normal. Take the angle to the mirror direction.",
                )
            } else if is(pdf.into(), right * to_normal) {
                (
                    "cosine-in-the-density",
                    "The cosine to the normal belongs to the light that arrives, not to the density.",
                )
            } else {
                (
                    "wrong-density",
                    "The density is `phong_lobe_pdf` of the angle between this direction and the mirror direction.",
                )
            };
            let expected = format!("{}, for cos α = {}", about(right), number(to_mirrored));
            wrong(name, format!("a density of {}", about(pdf.into())), expected, advice)
        }
        Density::Discrete(p) => {
            let advice = "A lobe has infinitely many directions: its likelihood is a density per steradian, `Density::SolidAngle`.";
            wrong(
                "discrete",
                format!("Density::Discrete({p})"),
                format!("Density::SolidAngle({})", about(right)),
                advice,
            )
        }
    }
}
