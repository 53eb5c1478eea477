//! Checks samples of a lamp's light, one by one, for exercise 6.4.

use common::{
    Vec2, Vec3,
    exercise::{Diagnosis, Finding, Verdict, trying},
};
use sampling::unit_square::sample_unit_square;

use super::{
    asked_or_found::Answer,
    place::Place,
    place_densities::{ask_density, find_density},
    places::{places, stream, words},
    words::{about, is_near},
};

/// A rival: a wrong result, its name, and what to do.
pub(super) type Rival = (f64, &'static str, &'static str);

/// What is to be known of a direction.
#[derive(Clone, Copy)]
pub(super) struct Known {
    /// cosθ where the lamp is seen, 0 elsewhere and below the surface.
    pub(super) light: f64,
    /// cosθ, of either sign, where the lamp is seen.
    signed: f64,
    /// Whether the lamp is seen.
    is_seen: bool,
    pub(super) ask: f64,
    pub(super) find: f64,
}

impl Known {
    pub(super) fn of(place: &Place, direction: Vec3) -> Self {
        let is_seen = place.lamp_seen(direction).is_some();
        let signed = if is_seen { f64::from(place.normal().dot(direction)) } else { 0.0 };
        let (ask, find) = (ask_density(place, direction), find_density(place, direction));
        Self { light: signed.max(0.0), signed, is_seen, ask, find }
    }

    /// The light with a weight, where there is any.
    pub(super) fn times(&self, weight: f64) -> f64 {
        if self.light > 0.0 { self.light * weight } else { 0.0 }
    }
}

/// Points of the square that are tried at each place.
const COUNT: usize = 300;

pub(super) fn points(number: u64) -> Vec<Vec2> {
    let mut random = stream(number);
    (0..COUNT).map(|_| sample_unit_square(&mut random)).collect()
}

pub(super) fn point(u: Vec2) -> String {
    format!("({}, {})", u.x, u.y)
}

/// Whether a result is another number, but for rounding.
pub(super) fn is(got: f64, other: f64) -> bool {
    is_near(got, other, 3e-3 * other.abs() + 1e-6)
}

/// Compare one result, or give the mistake the name of the first rival that it is.
pub(super) fn compare(
    tried: impl Fn() -> String,
    got: f64,
    right: f64,
    rivals: &[Rival],
    general: (&'static str, &str),
) -> Verdict {
    if is(got, right) {
        return Ok(());
    }
    let rival = rivals.iter().find(|(other, ..)| is(got, *other));
    let (name, advice) = rival.map_or(general, |(_, name, advice)| (*name, *advice));
    Err(Finding { tried: tried(), got: about(got), expected: about(right), advice: advice.into() }.named(name))
}

/// Accept `asked` and `found`, or name what is wrong with one.
pub(super) fn samples(answer: Answer) -> Verdict {
    for (name, not_started, ways) in [
        ("asked", "asked-not-started", answer.asked as fn(&Place, Vec2) -> f32),
        ("found", "found-not-started", answer.found),
    ] {
        let nothing = |place: &Place| points(7).into_iter().all(|u| ways(place, u) == 0.0);
        if places().iter().all(nothing) {
            let message = format!("The densities are right. Now for `{name}`, which returns 0 for every point.");
            return Err(Diagnosis::new(not_started, message));
        }
        for (i, place) in (0..).zip(places()) {
            for u in points(10 + i) {
                let tried = || format!("`{name}` with u = {} at {}", point(u), words(&place));
                let got = f64::from(trying(tried, || ways(&place, u)));
                if name == "asked" { one_asked(tried, &place, u, got)? } else { one_found(tried, &place, u, got)? }
            }
        }
    }
    Ok(())
}

fn one_asked(tried: impl Fn() -> String, place: &Place, u: Vec2, got: f64) -> Verdict {
    let known = Known::of(place, place.toward_lamp(u));
    let Known { light, signed, is_seen, ask: p, .. } = known;
    let horizon = "Below the surface the lamp gives no light: where the cosine is negative, the sample is 0.";
    let right = known.times(1.0 / p);
    if !is_seen {
        let general = ("hidden", "Something stands before the lamp. Where `lamp_seen` gives `None`, the sample is 0.");
        return compare(tried, got, 0.0, &[], general);
    }
    let rivals = [
        (signed / p, "below-the-horizon", horizon),
        (signed.abs() / p, "below-the-horizon", horizon),
        (f64::from(u8::from(light > 0.0)) / p, "cosine-forgotten", "The cosine at the surface is missing: cosθ / p."),
        (light, "density-forgotten", "The density is missing: cosθ / p."),
        (light * p, "density-multiplied", "A sample is divided by its density, not multiplied."),
        (
            known.times(1.0 / known.find),
            "other-density",
            "This is divided by the density of the other way: take `ask_density`.",
        ),
    ];
    compare(
        tried,
        got,
        right,
        &rivals,
        ("wrong-asked", "cosθ / p where the lamp is seen, with the p of `ask_density`."),
    )
}

fn one_found(tried: impl Fn() -> String, place: &Place, u: Vec2, got: f64) -> Verdict {
    let known = Known::of(place, place.cosine_direction(u));
    let Known { light, is_seen, find: p, .. } = known;
    if !is_seen {
        let general = ("light-from-nowhere", "In this direction the lamp is not seen: the sample is 0.");
        return compare(tried, got, 0.0, &[], general);
    }
    let rivals = [
        (light, "density-forgotten", "The density is missing: cosθ / p."),
        (light * p, "density-multiplied", "A sample is divided by its density, not multiplied."),
        (
            1.0,
            "cosine-forgotten",
            "The lamp is found with the radiance 1, but the sample is cosθ / p. What is left of it?",
        ),
        (1.0 / p, "cosine-forgotten", "The cosine at the surface is missing: cosθ / p."),
        (
            known.times(1.0 / known.ask),
            "other-density",
            "This is divided by the density of the other way: take `find_density`.",
        ),
    ];
    compare(tried, got, known.times(1.0 / p), &rivals, ("wrong-found", "cosθ / p where the lamp is seen."))
}
