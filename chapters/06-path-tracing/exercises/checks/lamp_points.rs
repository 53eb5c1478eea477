//! Checks points of a lamp and their densities, for exercise 6.2.

use common::{
    Rgb, Stream, Vec2, Vec3,
    exercise::{Finding, Verdict, trying},
};
use sampling::{chi_square, unit_square::sample_unit_square};

use super::{
    lamp::{Lamp, LampSample},
    lamp_exact::Seen,
    words::{about, is_near, triple},
};

type SampleLamp = fn(&Lamp, Vec3, Vec2) -> LampSample;

/// Rows and columns of the χ² test.
const CELLS: u8 = 8;
/// Points drawn for it.
const COUNT: u32 = 16_000;
/// A check asks for χ² a few times. With this it errs less than once in ten million answers.
const RISK: f64 = 1e-8;

/// Lamps, and from where they are seen: from before, from behind, and one that is no rectangle.
pub(super) fn views() -> [(Lamp, Vec3); 4] {
    let table = Lamp::around(Vec3::new(0.0, 3.0, 0.0), [Vec3::X * 1.5, Vec3::Z * 0.5], Rgb::ONE);
    let tilted = Lamp {
        corner: Vec3::new(-1.0, 2.0, 0.5),
        edges: [Vec3::new(1.0, 0.5, 0.0), Vec3::new(0.5, 1.0, 0.75)],
        radiance: Rgb::ONE,
    };
    let from = Vec3::new(0.5, 0.0, 1.5);
    [(table, from), (table, Vec3::new(-2.0, 4.0, 1.0)), (tilted, from), (tilted, Vec3::new(-3.0, 3.0, -2.0))]
}

/// Accept points, or name what is wrong with them.
pub(super) fn points(sample_lamp: SampleLamp) -> Verdict {
    for (lamp, from) in views() {
        let mut random = Stream::new(621, 0, 0);
        let mut counts = [0_u32; (CELLS as usize) * (CELLS as usize)];
        for _ in 0..COUNT {
            let u = sample_unit_square(&mut random);
            let place = one_point(sample_lamp, &lamp, from, u)?;
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "below the number of cells")]
            let [x, y] = place.to_array().map(|x| (x.clamp(0.0, 0.999_999) * f32::from(CELLS)) as usize);
            counts[y * usize::from(CELLS) + x] += 1;
        }
        let expected = f64::from(COUNT) / counts.len() as f64;
        let chi = chi_square::chi_square(&counts, &vec![expected; counts.len()]);
        if chi_square::chance(chi, counts.len() - 1) < RISK {
            let got = format!("χ² = {} over {} cells of the lamp", about(chi), counts.len());
            let advice = "Some parts of the lamp get more points than others of the same size: corner + u.x · edges[0] + u.y · edges[1].";
            let tried = format!("{COUNT} points of {}", words(&lamp, from));
            return Err(
                Finding { tried, got, expected: "χ² near 63".into(), advice: advice.into() }.named("not-uniform")
            );
        }
    }
    in_the_plane(sample_lamp)
}

fn words(lamp: &Lamp, from: Vec3) -> String {
    let [a, b] = lamp.edges.map(triple);
    format!("a lamp with the corner {} and the edges {a} and {b}, seen from {}", triple(lamp.corner), triple(from))
}

/// Where on the lamp a sample lies, if all about it is right.
fn one_point(sample_lamp: SampleLamp, lamp: &Lamp, from: Vec3, u: Vec2) -> Result<Vec2, common::exercise::Diagnosis> {
    let tried = || format!("`sample_lamp` with u = ({}, {}) and {}", u.x, u.y, words(lamp, from));
    let sample = trying(tried, || sample_lamp(lamp, from, u));
    let LampSample { direction, distance, density } = sample;
    let wrong = |name, got: String, expected: String, advice: &str| {
        Err(Finding { tried: tried(), got, expected, advice: advice.into() }.named(name))
    };
    let direction_told = || format!("the direction {}", triple(direction));
    if !is_near(direction.length().into(), 1.0, 1e-3) {
        let advice = "Divide the way to the point by its length.";
        return wrong("not-a-unit-vector", direction_told(), "a unit vector".into(), advice);
    }
    let there = from + direction * distance;
    let is_on = |point: Vec3| {
        let place = lamp.quad().place(point);
        let is_inside = place.cmpge(Vec2::splat(-1e-3)).all() && place.cmple(Vec2::splat(1.001)).all();
        is_inside && (lamp.at(place) - point).length() < 2e-3
    };
    if !is_on(there) {
        let (name, advice) = if is_on(from - direction * distance) {
            ("points-away", "The direction points away from the lamp: it is the point of the lamp minus `from`.")
        } else if is_on(from + direction * distance.sqrt()) {
            ("distance-squared", "This is the distance squared. `distance` is the distance itself.")
        } else {
            ("not-on-the-lamp", "There is no lamp. Its points are corner + u.x · edges[0] + u.y · edges[1].")
        };
        let got = format!("{} and the distance {distance}, which is the point {}", direction_told(), triple(there));
        return wrong(name, got, "a point of the lamp".into(), advice);
    }
    let seen = Seen::of(lamp, there.as_dvec3(), from, Vec3::Y);
    if !is_near(density.into(), seen.density(), 2e-3 * seen.density()) {
        let (name, advice) = density_mistake(&seen, density.into());
        let expected = format!(
            "{}, for d = {}, A = {} and cosθ' = {}",
            about(seen.density()),
            about(seen.distance2.sqrt()),
            about(seen.area),
            about(seen.cosine_there)
        );
        return wrong(name, format!("the density {}", about(density.into())), expected, advice);
    }
    Ok(lamp.quad().place(there))
}

/// Why a density is wrong.
pub(super) fn density_mistake(seen: &Seen, density: f64) -> (&'static str, &'static str) {
    let Seen { cosine_there: cosine, distance2, area, .. } = *seen;
    let (right, distance) = (seen.density(), distance2.sqrt());
    let is = |other: f64| is_near(density, other, 2e-3 * other.abs());
    let rivals = [
        (
            1.0 / area,
            "area-not-solid-angle",
            "This is 1 / A, the density per area. Per steradian it is d² / (A cosθ').",
        ),
        (
            distance2 / area,
            "cosine-at-the-lamp-forgotten",
            "The cosine at the lamp is missing: a lamp that is seen from the side covers less.",
        ),
        (
            right / distance2,
            "distance-forgotten",
            "The distance is missing: from far away a lamp covers few directions, and each is likelier.",
        ),
        (right / distance, "distance-not-squared", "The distance counts squared."),
        (1.0 / right, "upside-down", "This is the solid angle of the lamp, the density upside down."),
        (distance2 * cosine / area, "cosine-on-the-wrong-side", "The cosine at the lamp divides: p = d² / (A cosθ')."),
        (
            distance2 * area / cosine,
            "area-on-the-wrong-side",
            "The area divides: a large lamp has many points, and each is less likely.",
        ),
        (
            distance2 / cosine,
            "area-forgotten",
            "The area of the lamp is missing: each of its points has the density 1 / A.",
        ),
        (
            2.0 * right,
            "half-the-area",
            "This takes half the area. The length of the cross product is that of the whole lamp.",
        ),
        (right / std::f64::consts::PI, "pi-too-many", "No π belongs here: p = d² / (A cosθ')."),
        (right * std::f64::consts::PI, "pi-too-many", "No π belongs here: p = d² / (A cosθ')."),
        (-right, "one-sided", "The lamp glows on both sides: take the absolute value of the cosine."),
        (
            0.0,
            "one-sided",
            "This is 0, but the lamp is seen. It glows on both sides: take the absolute value of the cosine.",
        ),
    ];
    let rival = rivals.into_iter().find(|(other, ..)| is(*other));
    rival.map_or(("wrong-density", "p = d² / (A cosθ'), where θ' is the angle at the lamp."), |(_, name, advice)| {
        (name, advice)
    })
}

/// From a point in the plane of the lamp there is nothing to be seen.
fn in_the_plane(sample_lamp: SampleLamp) -> Verdict {
    let lamp = Lamp::around(Vec3::Y, [Vec3::X, Vec3::Z], Rgb::ONE);
    for from in [Vec3::new(4.0, 1.0, 0.0), Vec3::Y] {
        let u = Vec2::splat(0.5);
        let tried = format!("`sample_lamp` with u = ({}, {}) and {}", u.x, u.y, words(&lamp, from));
        let LampSample { direction, distance, density } = trying(|| tried.clone(), || sample_lamp(&lamp, from, u));
        if density != 0.0 || !direction.is_finite() || !distance.is_finite() {
            let got = format!("the direction {}, the distance {distance}, the density {density}", triple(direction));
            let expected = "the density 0, and numbers".into();
            let advice = "From a point in its own plane a flat lamp covers nothing. Ask whether the cosine is above 0 before you divide \
                          by it, and let `normalize_or_zero` take care of a way of no length.";
            return Err(Finding { tried, got, expected, advice: advice.into() }.named("divided-by-zero"));
        }
    }
    Ok(())
}
