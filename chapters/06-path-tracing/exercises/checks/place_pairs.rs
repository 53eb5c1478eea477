//! Checks pairs of samples, each with its weight, for exercise 6.4.

use common::{
    Vec2,
    exercise::{Diagnosis, Verdict, trying},
};

use super::{
    asked_or_found::Answer,
    place::Place,
    place_samples::{Known, compare, is, point, points},
    places::{places, words},
};

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
