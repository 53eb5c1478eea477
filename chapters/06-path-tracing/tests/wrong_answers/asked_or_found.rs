//! Wrong ways to a lamp, and wrong combinations of them.

use std::f32::consts::PI;

use common::{Vec2, Vec3};

use crate::{
    checks::{
        asked_or_found::{Answer, check},
        place::Place,
    },
    name,
};

fn ask_density(place: &Place, direction: Vec3) -> f32 {
    let per_area = place.lamp_area().recip();
    place.lamp_seen(direction).map_or(0.0, |hit| per_area * hit.t * hit.t / hit.geometric_normal.dot(direction).abs())
}

fn find_density(place: &Place, direction: Vec3) -> f32 {
    cosine(place, direction).max(0.0) / PI
}

fn cosine(place: &Place, direction: Vec3) -> f32 {
    place.normal().dot(direction)
}

/// What arrives from a direction: the cosine, or 0.
fn light(place: &Place, direction: Vec3) -> f32 {
    place.lamp_seen(direction).map_or(0.0, |_| cosine(place, direction).max(0.0))
}

fn over(light: f32, density: f32) -> f32 {
    if light > 0.0 { light / density } else { 0.0 }
}

fn asked(place: &Place, u: Vec2) -> f32 {
    let direction = place.toward_lamp(u);
    over(light(place, direction), ask_density(place, direction))
}

fn found(place: &Place, u: Vec2) -> f32 {
    let direction = place.cosine_direction(u);
    over(light(place, direction), find_density(place, direction))
}

/// Both samples, with weights made of the two densities of their own directions.
fn weighed(place: &Place, [u, v]: [Vec2; 2], weights: impl Fn([f32; 2]) -> [f32; 2]) -> f32 {
    let of = |direction| weights([ask_density(place, direction), find_density(place, direction)]);
    let both = [asked(place, u), found(place, v)];
    let weights = [of(place.toward_lamp(u))[0], of(place.cosine_direction(v))[1]];
    let times = |i: usize| if both[i] > 0.0 { both[i] * weights[i] } else { 0.0 };
    times(0) + times(1)
}

fn combined(place: &Place, u: Vec2, v: Vec2) -> f32 {
    weighed(place, [u, v], |[ask, find]| [ask / (ask + find), find / (ask + find)])
}

const RIGHT: Answer = Answer { ask_density, find_density, asked, found, combined };

/// The diagnosis of an answer in which one function is another.
macro_rules! with {
    ($name:ident: $function:expr) => {
        name(check(Answer { $name: $function, ..RIGHT }))
    };
}

/// The diagnosis of such a density of asking, by distance, area and cosine at the lamp.
macro_rules! density {
    ($density:expr) => {
        with!(ask_density: |place, direction| {
            let density: fn(f32, f32, f32) -> f32 = $density;
            let of = |hit: ray_casting::hit::Hit| density(hit.t, place.lamp_area(), hit.geometric_normal.dot(direction));
            place.lamp_seen(direction).map_or(0.0, of)
        })
    };
}

/// The diagnosis of such weights, by the densities of asking and finding.
macro_rules! weights {
    ($weights:expr) => {
        with!(combined: |place, u, v| {
            let weights: fn([f32; 2]) -> [f32; 2] = $weights;
            weighed(place, [u, v], weights)
        })
    };
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(check(RIGHT), Ok(()));
    let power: fn(&Place, Vec2, Vec2) -> f32 =
        |place, u, v| weighed(place, [u, v], |[a, f]| [a * a / (a * a + f * f), f * f / (a * a + f * f)]);
    assert_eq!(check(Answer { combined: power, ..RIGHT }), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    let nothing = Answer {
        ask_density: |_, _| 0.0,
        find_density: |_, _| 0.0,
        asked: |_, _| 0.0,
        found: |_, _| 0.0,
        combined: |_, _, _| 0.0,
    };
    assert_eq!(name(check(nothing)), "not-started");
    assert_eq!(name(check(Answer { ask_density, ..nothing })), "find-density-not-started");
    assert_eq!(name(check(Answer { ask_density, find_density, ..nothing })), "asked-not-started");
    assert_eq!(name(check(Answer { ask_density, find_density, asked, ..nothing })), "found-not-started");
    assert_eq!(with!(combined: |_, _, _| 0.0), "combined-not-started");
}

#[test]
fn wrong_densities() {
    assert_eq!(density!(|_, area, _| 1.0 / area), "area-not-solid-angle");
    assert_eq!(density!(|d, area, _| d * d / area), "cosine-at-the-lamp-forgotten");
    assert_eq!(density!(|_, area, cosine| 1.0 / (area * cosine.abs())), "distance-forgotten");
    assert_eq!(density!(|d, area, cosine| d * d / (area * cosine)), "one-sided");
    assert_eq!(density!(|_, _, _| f32::NAN), "wrong-density");
    assert_eq!(with!(ask_density: |place, d| ask_density(place, d).max(0.1)), "not-seen");
    assert_eq!(with!(find_density: |place, d| cosine(place, d) / PI), "below-the-surface");
    assert_eq!(with!(find_density: |place, d| cosine(place, d).abs() / PI), "below-the-surface");
    assert_eq!(with!(find_density: |place, d| cosine(place, d).max(0.0)), "pi-forgotten");
    assert_eq!(with!(find_density: |place, d| if cosine(place, d) > 0.0 { 0.5 / PI } else { 0.0 }), "uniform");
    assert_eq!(
        with!(find_density: |place, d| if cosine(place, d) > 0.0 { PI / cosine(place, d) } else { 0.0 }),
        "find-density-upside-down"
    );
    assert_eq!(with!(find_density: |place, d| find_density(place, d) * 2.0), "wrong-find-density");
}

#[test]
fn wrong_ways() {
    assert_eq!(
        with!(asked: |place, u| {
            let d = place.toward_lamp(u);
            if place.lamp_seen(d).is_some() { cosine(place, d) / ask_density(place, d) } else { 0.0 }
        }),
        "below-the-horizon"
    );
    // Asked without a shadow ray.
    assert_eq!(
        with!(asked: |place, u| {
            let d = place.toward_lamp(u);
            let p = if place.lamp_seen(d).is_some() { ask_density(place, d) } else { 1.0 };
            cosine(place, d).max(0.0) / p
        }),
        "hidden"
    );
    let once: fn(&Place, Vec2) -> f32 = |place, u| light(place, place.toward_lamp(u));
    assert_eq!(with!(asked: once), "density-forgotten");
    assert_eq!(
        with!(asked: |place, u| {
            let d = place.toward_lamp(u);
            light(place, d) * ask_density(place, d)
        }),
        "density-multiplied"
    );
    assert_eq!(
        with!(asked: |place, u| {
            let d = place.toward_lamp(u);
            over(light(place, d).signum() * light(place, d).min(1.0), find_density(place, d))
        }),
        "other-density"
    );
    assert_eq!(
        with!(asked: |place, u| {
            let d = place.toward_lamp(u);
            if light(place, d) > 0.0 { 1.0 / ask_density(place, d) } else { 0.0 }
        }),
        "cosine-forgotten"
    );
    assert_eq!(with!(asked: |place, u| asked(place, u) * 0.9), "wrong-asked");
    assert_eq!(with!(asked: |_, _| f32::NAN), "wrong-asked");
    assert_eq!(with!(found: |place, u| light(place, place.cosine_direction(u))), "density-forgotten");
    assert_eq!(with!(found: |place, u| f32::from(u8::from(found(place, u) > 0.0))), "cosine-forgotten");
    assert_eq!(with!(found: |_, _| PI), "light-from-nowhere");
    assert_eq!(with!(found: |place, u| found(place, u) * 0.9), "wrong-found");
    assert_eq!(
        with!(found: |place, u| {
            let d = place.cosine_direction(u);
            over(light(place, d), ask_density(place, d))
        }),
        "other-density"
    );
}

#[test]
fn wrong_combinations() {
    // Pitfall 23: light that counts twice.
    assert_eq!(weights!(|_| [1.0, 1.0]), "counted-twice");
    assert_eq!(weights!(|_| [0.5, 0.5]), "plain-average");
    assert_eq!(weights!(|[a, f]| [f / (a + f), a / (a + f)]), "weights-swapped");
    assert_eq!(weights!(|[a, f]| [a / (a + f) / 2.0, f / (a + f) / 2.0]), "halved");
    assert_eq!(weights!(|_| [1.0, 0.0]), "one-way-only");
    assert_eq!(weights!(|[a, f]| [a / (a + f), 0.0]), "one-way-only");
    assert_eq!(weights!(|[a, f]| [0.0, f / (a + f)]), "one-way-only");
    assert_eq!(
        with!(combined: |place, u, v| {
            let (a, f) = (ask_density(place, place.toward_lamp(u)), find_density(place, place.cosine_direction(v)));
            let both = [asked(place, u), found(place, v)];
            both[0] * (a / (a + f)) + both[1] * (f / (a + f))
        }),
        "density-of-the-other-direction"
    );
    assert_eq!(
        with!(combined: |place, u, v| {
            let weight = |d| [ask_density(place, d), find_density(place, d)];
            let [[a, f], [b, g]] = [weight(place.toward_lamp(u)), weight(place.cosine_direction(v))];
            // 0 / 0 where the lamp is below the horizon and hidden.
            asked(place, u) * (a / (a + f)) + found(place, v) * (g / (b + g)) + 0.0 / (a + f)
        }),
        "not-a-number"
    );
    assert_eq!(weights!(|[a, f]| [(a / (a + f)).sqrt(), (f / (a + f)).sqrt()]), "wrong-combination");
}

/// Right at first, and wrong or noisy when they are asked more often.
#[test]
fn ways_that_change() {
    use std::sync::atomic::{AtomicU64, Ordering};
    static CALLS: AtomicU64 = AtomicU64::new(0);
    // The check of single pairs asks less often than this.
    let tired: fn(&Place, Vec2, Vec2) -> f32 = |place, u, v| {
        let calls = CALLS.fetch_add(1, Ordering::Relaxed);
        combined(place, u, v) * if calls > 10_000 { 0.9 } else { 1.0 }
    };
    assert_eq!(with!(combined: tired), "wrong-mean");
    // Right on average, but noisier and noisier.
    static MORE: AtomicU64 = AtomicU64::new(0);
    let noisy: fn(&Place, Vec2, Vec2) -> f32 = |place, u, v| {
        let calls = MORE.fetch_add(1, Ordering::Relaxed);
        if calls > 10_000 { weighed(place, [u, v], |_| [0.5, 0.5]) } else { combined(place, u, v) }
    };
    assert_eq!(with!(combined: noisy), "too-noisy");
}
