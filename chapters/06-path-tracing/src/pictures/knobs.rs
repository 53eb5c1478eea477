//! The knobs that several pictures share: each turns one idea of the chapter on and off.

use common::{
    knob::{Knob, Step},
    picture::Settings,
};
use sampling::sky_light::Choice;
use whitted::material::Fresnel;

use crate::method::Method;

/// Which directions are followed.
pub(super) const SAMPLING: Knob =
    Knob::choice("sampling", "which directions are followed", &["uniform", "cosine-and-mirror"], 1);
/// Whether abstract lights are asked.
pub(super) const DIRECT: Knob = Knob::switch("direct", "ask abstract lights at every hit", true);
/// Whether chance may end a path.
pub(super) const ROULETTE: Knob = roulette(true);
/// How long paths may be.
pub(super) const BOUNCES: Knob = bounces(1000.0);

/// The knob of the roulette, with a default of its own.
pub(super) const fn roulette(default: bool) -> Knob {
    Knob::switch("roulette", "let chance end a path", default)
}

/// The knob of the bounces, with a default of its own.
pub(super) const fn bounces(default: f32) -> Knob {
    Knob::number("bounces", "greatest number of bounces", [0.0, 1000.0], default, "", Step::Whole)
}

/// All of them.
pub(super) const METHOD: [Knob; 4] = [SAMPLING, DIRECT, ROULETTE, BOUNCES];

/// What the user has chosen; the knobs that a picture may have with a default of its own are given.
pub(super) fn method(settings: &Settings, [roulette, bounces]: [&Knob; 2]) -> Method {
    let values = &settings.values;
    // The knob's range is far below the greatest u32.
    let bounces = u32::try_from(values.index(bounces)).unwrap_or(Method::MOST_BOUNCES);
    Method {
        choice: if values.index(&SAMPLING) == 0 { Choice::Uniform } else { Choice::CosineAndMirror },
        direct: values.is_on(&DIRECT),
        roulette: values.is_on(roulette),
        fresnel: Fresnel::Exact,
        bounces: 0..=bounces,
    }
}
