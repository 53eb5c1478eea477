//! Wrong colored glass.

use common::{Rgb, float};
use ray_casting::hit::{Hit, Side};
use whitted::{branches::Branch, probe::Kind};

use crate::{
    checks::absorption::{Answer, check},
    name,
};

/// One channel after the other.
fn each(color: Rgb, f: impl Fn(f32) -> f32) -> Rgb {
    Rgb::from_array(color.to_array().map(f))
}

const RIGHT: Answer = Answer {
    coefficient: |color| each(color, |x| -float::ln(x)),
    transmittance: |sigma, length| each(sigma, |x| if x == 0.0 { 1.0 } else { float::exp(-x * length) }),
    way: |branch, hit| hit.map_or(f32::INFINITY, |hit| hit.t - branch.range.min),
    medium: |new, side, here, inside| match (new.kind, side) {
        (Kind::Refracted, Side::Outside) => inside,
        (Kind::Refracted, Side::Inside) => Rgb::ZERO,
        _ => here,
    },
};

fn coefficients(coefficient: fn(Rgb) -> Rgb) -> &'static str {
    name(check(Answer { coefficient, ..RIGHT }))
}

fn transmittances(transmittance: fn(Rgb, f32) -> Rgb) -> &'static str {
    name(check(Answer { transmittance, ..RIGHT }))
}

fn ways(way: fn(&Branch, Option<&Hit>) -> f32) -> &'static str {
    name(check(Answer { way, ..RIGHT }))
}

fn media(medium: fn(&Branch, Side, Rgb, Rgb) -> Rgb) -> &'static str {
    name(check(Answer { medium, ..RIGHT }))
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(check(RIGHT), Ok(()));
    // Powers of the color after one unit are as good.
    let transmittance = |sigma, length| each(each(sigma, |x| float::exp(-x)), |left| float::pow(left, length));
    assert_eq!(check(Answer { transmittance, ..RIGHT }), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    let clear = Answer { coefficient: |_| Rgb::ZERO, transmittance: |_, _| Rgb::ONE, ..RIGHT };
    assert_eq!(name(check(clear)), "not-started");
    assert_eq!(coefficients(|_| Rgb::ZERO), "coefficient-not-started");
    assert_eq!(transmittances(|_, _| Rgb::ONE), "transmittance-not-started");
    assert_eq!(ways(|_, _| 0.0), "way-not-started");
    assert_eq!(media(|_, _, _, _| Rgb::ZERO), "never-inside");
}

#[test]
fn wrong_coefficients() {
    assert_eq!(coefficients(|color| each(color, float::ln)), "coefficient-sign");
    assert_eq!(coefficients(|color| Rgb::ONE - color), "linear");
    assert_eq!(coefficients(|color| each(color, |x| float::exp(-x))), "exp-not-ln");
    assert_eq!(coefficients(|color| color.recip()), "reciprocal");
    assert_eq!(coefficients(|color| each(color, |x| -float::ln(x) / std::f32::consts::LN_10)), "wrong-logarithm");
    assert_eq!(coefficients(|color| Rgb::splat(-float::ln(color.x))), "one-channel");
    assert_eq!(coefficients(|color| each(color, |x| -2.0 * float::ln(x))), "wrong-coefficient");
    assert_eq!(coefficients(|color| each(color, |x| -float::ln(x.max(0.01)))), "dark-colors");
    assert_eq!(coefficients(|color| each(color, |x| -float::ln(x.max(1e-6)))), "dark-colors");
    assert_eq!(coefficients(|color| each(color, |x| -float::ln(x + 0.001))), "wrong-coefficient");
}

#[test]
fn wrong_transmittances() {
    assert_eq!(transmittances(|sigma, s| each(sigma, |x| float::exp(x * s))), "light-grows");
    assert_eq!(transmittances(|sigma, s| each(sigma, |x| 1.0 - float::exp(-x * s))), "lost-not-left");
    assert_eq!(transmittances(|sigma, s| each(sigma, |x| (1.0 - x * s).max(0.0))), "linear");
    assert_eq!(transmittances(|sigma, s| each(sigma, |x| 1.0 / (1.0 + x * s))), "not-exponential");
    assert_eq!(transmittances(|sigma, _| each(sigma, |x| float::exp(-x))), "length-ignored");
    assert_eq!(transmittances(|sigma, s| each(sigma, |x| float::exp2(-x * s))), "not-base-e");
    assert_eq!(transmittances(|sigma, s| Rgb::splat(float::exp(-sigma.x * s))), "one-channel");
    assert_eq!(transmittances(|sigma, s| each(sigma, |x| float::exp(-x * s))), "zero-times-infinity");
    assert_eq!(
        transmittances(|sigma, s| if s.is_finite() { each(sigma, |x| float::exp(-x * s)) } else { Rgb::ZERO }),
        "zero-times-infinity"
    );
    assert_eq!(
        transmittances(|sigma, s| if s.is_finite() { each(sigma, |x| float::exp(-x * s)) } else { Rgb::ONE }),
        "infinite-way-ignored"
    );
    assert_eq!(transmittances(|_, s| Rgb::splat(float::exp(-s))), "sigma-ignored");
    assert_eq!(transmittances(|sigma, s| (RIGHT.transmittance)(sigma, s.ceil())), "length-rounded");
    assert_eq!(transmittances(|sigma, s| (RIGHT.transmittance)(sigma, s.min(1000.0))), "long-ways");
    assert_eq!(transmittances(|sigma, s| each(sigma, |x| float::exp(-(x + 0.1) * s))), "wrong-transmittance");
}

#[test]
fn wrong_ways() {
    assert_eq!(ways(|_, hit| hit.map_or(f32::INFINITY, |hit| hit.t)), "way-from-origin");
    assert_eq!(ways(|branch, hit| hit.map_or(0.0, |hit| hit.t - branch.range.min)), "way-not-started");
    assert_eq!(ways(|branch, hit| hit.map_or(1.0, |hit| hit.t - branch.range.min)), "infinite-way");
    assert_eq!(ways(|branch, hit| hit.map_or(f32::INFINITY, |hit| branch.range.min - hit.t)), "negative-way");
    assert_eq!(ways(|_, hit| hit.map_or(f32::INFINITY, |hit| hit.t * hit.t)), "wrong-way");
    assert_eq!(ways(|branch, hit| hit.map_or(branch.range.max, |hit| hit.t) - branch.range.min), "range-end");
}

#[test]
fn wrong_media() {
    assert_eq!(
        media(|new, side, here, inside| {
            let kind = if new.kind == Kind::Refracted { Kind::Reflected } else { Kind::Refracted };
            (RIGHT.medium)(&Branch { kind, ..*new }, side, here, inside)
        }),
        "kinds-swapped"
    );
    assert_eq!(
        media(|new, side, here, inside| {
            let side = if side == Side::Inside { Side::Outside } else { Side::Inside };
            (RIGHT.medium)(new, side, here, inside)
        }),
        "sides-swapped"
    );
    // The other side of the old one, whatever becomes of the ray.
    assert_eq!(media(|_, side, _, inside| if side == Side::Outside { inside } else { Rgb::ZERO }), "reflection-enters");
    assert_eq!(media(|new, _, here, inside| if new.kind == Kind::Refracted { inside } else { here }), "never-leaves");
    assert_eq!(
        media(|new, side, _, inside| match (new.kind, side) {
            (Kind::Refracted, Side::Outside) => inside,
            _ => Rgb::ZERO,
        }),
        "reflection-leaves"
    );
    assert_eq!(
        media(|new, side, _, inside| match (new.kind, side) {
            (Kind::Refracted, Side::Outside) | (Kind::Reflected, Side::Inside) => inside,
            _ => Rgb::ZERO,
        }),
        "reflection-not-here"
    );
}
