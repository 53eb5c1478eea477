//! Checks exercise 6.4, asked or found.

use common::{
    Vec2, Vec3,
    exercise::{Diagnosis, Verdict},
};

use super::{
    effort::efforts, place::Place, place_densities::densities, place_pairs::both, place_samples::samples,
    places::places,
};

/// What the student writes.
#[derive(Clone, Copy)]
pub(crate) struct Answer {
    /// The density with which asking draws a direction.
    pub(crate) ask_density: fn(&Place, Vec3) -> f32,
    /// The density with which a cosine-distributed direction is drawn.
    pub(crate) find_density: fn(&Place, Vec3) -> f32,
    /// One sample that asks.
    pub(crate) asked: fn(&Place, Vec2) -> f32,
    /// One sample that waits.
    pub(crate) found: fn(&Place, Vec2) -> f32,
    /// Both, each with its weight.
    pub(crate) combined: fn(&Place, Vec2, Vec2) -> f32,
}

/// Accept samples, or name what is wrong with them.
pub(crate) fn check(answer: Answer) -> Verdict {
    let places = places();
    let toward = |place: &Place| place.toward_lamp(Vec2::splat(0.5));
    if places.iter().all(|place| (answer.ask_density)(place, toward(place)) == 0.0) {
        return Err(Diagnosis::not_started("`ask_density` returns 0, whatever it is asked."));
    }
    densities(answer)?;
    samples(answer)?;
    both(answer)?;
    efforts(answer)
}
