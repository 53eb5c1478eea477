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
type Rival = (f64, &'static str, &'static str);

/// What is to be known of a direction.
#[derive(Clone, Copy)]
struct Known {
    /// cosθ where the lamp is seen, 0 elsewhere and below the surface.
    light: f64,
    /// cosθ, of either sign, where the lamp is seen.
    signed: f64,
    /// Whether the lamp is seen.
    is_seen: bool,
    ask: f64,
    find: f64,
}

impl Known {
    fn of(place: &Place, direction: Vec3) -> Self {
        let is_seen = place.lamp_seen(direction).is_some();
        let signed = if is_seen { f64::from(place.normal().dot(direction)) } else { 0.0 };
        let (ask, find) = (ask_density(place, direction), find_density(place, direction));
        Self { light: signed.max(0.0), signed, is_seen, ask, find }
    }

    /// The light with a weight, where there is any.
    fn times(&self, weight: f64) -> f64 {
        if self.light > 0.0 { self.light * weight } else { 0.0 }
    }
}

/// Points of the square that are tried at each place.
const COUNT: usize = 300;

fn points(number: u64) -> Vec<Vec2> {
    let mut random = stream(number);
    (0..COUNT).map(|_| sample_unit_square(&mut random)).collect()
}

fn point(u: Vec2) -> String {
    format!("({}, {})", u.x, u.y)
}

/// Whether a result is another number, but for rounding.
fn is(got: f64, other: f64) -> bool {
    is_near(got, other, 3e-3 * other.abs() + 1e-6)
}

/// Compare one result, or give the mistake the name of the first rival that it is.
fn compare(
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

/// Accept `combined`, or name what is wrong with it.
pub(super) fn both(answer: Answer) -> Verdict {
    let pairs = |number| points(number).into_iter().zip(points(number + 100));
    let nothing = |place: &Place| pairs(20).all(|(u, v)| (answer.combined)(place, u, v) == 0.0);
    if places().iter().all(nothing) {
        let message = "Both ways are right. Now for `combined`, which returns 0 for all points.";
        return Err(Diagnosis::new("combined-not-started", message));
    }
    // Pairs in which both ways see the lamp, and light, tell the most: they come first.
    let is_telling = |place: &Place, [u, v]: [Vec2; 2]| {
        [place.toward_lamp(u), place.cosine_direction(v)]
            .iter()
            .all(|direction| Known::of(place, *direction).light > 0.0)
    };
    for telling in [true, false] {
        for (i, place) in (0..).zip(places()) {
            for (u, v) in pairs(30 + i).filter(|(u, v)| is_telling(&place, [*u, *v]) == telling) {
                one_pair(answer, &place, [u, v])?;
            }
        }
    }
    Ok(())
}

fn one_pair(answer: Answer, place: &Place, [u, v]: [Vec2; 2]) -> Verdict {
    let tried = || format!("`combined` with u_ask = {} and u_find = {} at {}", point(u), point(v), words(place));
    let got = f64::from(trying(tried, || (answer.combined)(place, u, v)));
    let [a, b] = [place.toward_lamp(u), place.cosine_direction(v)].map(|direction| Known::of(place, direction));
    let sum = |weight: &dyn Fn(&Known) -> [f64; 2]| a.times(weight(&a)[0] / a.ask) + b.times(weight(&b)[1] / b.find);
    let balance = |k: &Known| [k.ask, k.find].map(|p| p / (k.ask + k.find));
    let power = |k: &Known| [k.ask, k.find].map(|p| p * p / (k.ask * k.ask + k.find * k.find));
    if is(got, sum(&power)) {
        return Ok(());
    }
    let right = sum(&balance);
    // Weights made of the densities with which the two directions were drawn.
    let mixed = a.times(1.0 / (a.ask + b.find)) + b.times(1.0 / (a.ask + b.find));
    let rivals = [
        (
            sum(&|_| [1.0, 1.0]),
            "counted-twice",
            "Both samples count in full, so the light counts twice. Each needs its weight.",
        ),
        (
            sum(&|_| [0.5, 0.5]),
            "plain-average",
            "This is the plain average. It is right on average, but has the noise of the worse way: the weights must depend on the \
             densities.",
        ),
        (
            sum(&|k| [balance(k)[1], balance(k)[0]]),
            "weights-swapped",
            "The weights are swapped: a sample counts much where its own way is the likelier one.",
        ),
        (right / 2.0, "halved", "This is half of it. The weights add up to 1 already, so the two samples are added."),
        (
            mixed,
            "density-of-the-other-direction",
            "The two samples have different directions. For the weight of a sample take both densities of its own direction.",
        ),
        (sum(&|_| [1.0, 0.0]), "one-way-only", "Only the asked sample counts. Add the found one, with its weight."),
        (sum(&|_| [0.0, 1.0]), "one-way-only", "Only the found sample counts. Add the asked one, with its weight."),
        (sum(&|k| [balance(k)[0], 0.0]), "one-way-only", "The found sample is missing. Add it, with its weight."),
        (sum(&|k| [0.0, balance(k)[1]]), "one-way-only", "The asked sample is missing. Add it, with its weight."),
    ];
    let general = "The asked sample times p_ask / (p_ask + p_find), both for the direction of that sample, and the found sample times \
                   p_find / (p_ask + p_find), both for its own direction.";
    let advice = if got.is_nan() {
        "This is no number. Was 0 divided by 0, where neither way draws a direction?"
    } else {
        general
    };
    let name = if got.is_nan() { "not-a-number" } else { "wrong-combination" };
    compare(tried, got, right, &rivals, (name, advice))
}
