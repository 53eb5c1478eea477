//! Checks the densities of directions, for exercise 6.4.

use std::f64::consts::PI;

use common::{
    Vec3,
    exercise::{Diagnosis, Finding, Verdict, trying},
};
use sampling::{uniform_sphere::sample_uniform_sphere, unit_square::sample_unit_square};

use super::{
    asked_or_found::Answer,
    lamp_exact::Seen,
    lamp_points::density_mistake,
    place::Place,
    places::{places, stream, words},
    words::{about, is_near, triple},
};

/// The density with which asking draws a direction.
pub(super) fn ask_density(place: &Place, direction: Vec3) -> f64 {
    seen(place, direction).map_or(0.0, |seen| seen.density())
}

/// How the lamp is seen in a direction.
fn seen(place: &Place, direction: Vec3) -> Option<Seen> {
    let hit = place.lamp_seen(direction)?;
    Some(Seen::of(place.lamp(), hit.position.as_dvec3(), place.hit().position, place.normal()))
}

/// The density with which a cosine-distributed direction is drawn.
pub(super) fn find_density(place: &Place, direction: Vec3) -> f64 {
    f64::from(place.normal().dot(direction)).max(0.0) / PI
}

/// Accept both densities, or name what is wrong with one.
pub(super) fn densities(answer: Answer) -> Verdict {
    for (i, place) in (0..).zip(places()) {
        let mut random = stream(i);
        for _ in 0..200 {
            one_ask(answer, &place, place.toward_lamp(sample_unit_square(&mut random)))?;
            one_ask(answer, &place, sample_uniform_sphere(sample_unit_square(&mut random)))?;
        }
    }
    let nothing = |place: &Place| (answer.find_density)(place, place.normal()) == 0.0;
    if places().iter().all(nothing) {
        let message = "`ask_density` is right. Now for `find_density`, which returns 0 for every direction.";
        return Err(Diagnosis::new("find-density-not-started", message));
    }
    for (i, place) in (0..).zip(places()) {
        let mut random = stream(i);
        (0..200).try_for_each(|_| one_find(answer, &place, sample_uniform_sphere(sample_unit_square(&mut random))))?;
    }
    Ok(())
}

fn one_ask(answer: Answer, place: &Place, direction: Vec3) -> Verdict {
    let tried = || format!("`ask_density` in the direction {} at {}", triple(direction), words(place));
    let got = f64::from(trying(tried, || (answer.ask_density)(place, direction)));
    let right = ask_density(place, direction);
    if is_near(got, right, 2e-3 * right) {
        return Ok(());
    }
    let (name, advice) = match seen(place, direction) {
        Some(seen) => density_mistake(&seen, got),
        None => (
            "not-seen",
            "In this direction the lamp is not seen: asking never draws it. Where `lamp_seen` gives `None`, the density is 0.",
        ),
    };
    let (got, expected) = (format!("the density {}", about(got)), about(right));
    Err(Finding { tried: tried(), got, expected, advice: advice.into() }.named(name))
}

fn one_find(answer: Answer, place: &Place, direction: Vec3) -> Verdict {
    let tried = || format!("`find_density` in the direction {} at {}", triple(direction), words(place));
    let got = f64::from(trying(tried, || (answer.find_density)(place, direction)));
    let (right, cosine) = (find_density(place, direction), f64::from(place.normal().dot(direction)));
    let is = |other: f64| is_near(got, other, 1e-3 * other.abs() + 1e-6);
    if is(right) {
        return Ok(());
    }
    let (name, advice) = if right == 0.0 {
        ("below-the-surface", "Below the surface no direction is drawn: there the density is 0.")
    } else if is(cosine) {
        (
            "pi-forgotten",
            "π is missing: over the hemisphere the density must integrate to 1, and the cosine integrates to π.",
        )
    } else if is(1.0 / (2.0 * PI)) {
        ("uniform", "This is the density of uniform directions. These are distributed by the cosine: cosθ / π.")
    } else if is(PI / cosine) {
        ("find-density-upside-down", "This is one over the density.")
    } else {
        ("wrong-find-density", "cosθ / π, where θ is the angle to the normal of the surface.")
    };
    let (got, expected) = (format!("the density {}", about(got)), about(right));
    Err(Finding { tried: tried(), got, expected, advice: advice.into() }.named(name))
}
