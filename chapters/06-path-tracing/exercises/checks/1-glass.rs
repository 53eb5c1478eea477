//! Checks exercise 6.1, glass.

use common::{
    Stream, Vec3,
    exercise::{Diagnosis, Finding, Verdict, trying},
};
use ray_casting::{hit::Side, ray::Ray};

use super::{
    glass_case::Case,
    glass_furnace::furnaces,
    glass_mistakes::{direction_mistake, share_mistake, weight_mistake},
    glass_world::GlassStep,
    words::{about, is_near, triple},
};

/// What is asked: index, side and angle in degrees. What tells the most mistakes apart comes first.
const CASES: [(f32, Side, f32); 13] = [
    (1.5, Side::Outside, 30.0),
    (1.5, Side::Outside, 65.0),
    (1.5, Side::Inside, 35.0),
    (1.5, Side::Inside, 50.0),
    (1.5, Side::Outside, 0.0),
    (1.5, Side::Inside, 0.0),
    (0.75, Side::Outside, 40.0),
    (0.75, Side::Outside, 60.0),
    (0.75, Side::Inside, 70.0),
    (2.4, Side::Outside, 60.0),
    (2.4, Side::Inside, 20.0),
    (1.33, Side::Outside, 88.0),
    (1.0, Side::Outside, 45.0),
];
/// How often each of them is asked.
const COUNT: u32 = 20_000;

/// Accept glass, or name what is wrong with it.
pub(crate) fn check(glass_step: GlassStep) -> Verdict {
    let cases = CASES.map(|(index, side, degrees)| Case::at(index, side, degrees));
    let weights = cases.iter().map(|case| ask(glass_step, case, &mut Stream::new(611, 0, 0)).1);
    if weights.into_iter().all(|weight| weight == 0.0) {
        return Err(Diagnosis::not_started("Your glass is black: all weights are 0."));
    }
    cases.iter().try_for_each(|case| one_case(glass_step, case))?;
    furnaces(glass_step)
}

fn ask(glass_step: GlassStep, case: &Case, random: &mut Stream) -> (Ray, f32) {
    trying(|| case.words(), || glass_step(case.index, &case.ray, &case.hit, random))
}

/// Which way a path went.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    Reflected,
    Refracted,
}

/// Ask one question many times: first where paths go, then how often, then with which weight.
fn one_case(glass_step: GlassStep, case: &Case) -> Verdict {
    let mut random = Stream::new(612, case.index.to_bits().into(), case.ray.direction.x.to_bits().into());
    let (mut count, mut weights) = (0, Ok(()));
    for _ in 0..COUNT {
        let (next, weight) = ask(glass_step, case, &mut random);
        let way = way(case, next.direction, weight)?;
        origin(case, &next, way)?;
        count += u32::from(way == Way::Reflected);
        weights = weights.and_then(|()| right_weight(case, way, weight));
    }
    // A wrong weight may be there to make up for a wrong share, so the share comes first.
    let (share, right) = (f64::from(count) / f64::from(COUNT), case.reflectance());
    if !is_share(share, right) {
        let (name, advice) = share_mistake(case, share);
        let tried = format!("{}, {COUNT} times", case.words());
        let (got, expected) = (format!("reflected with a share of {}", about(share)), about(right));
        return Err(Finding { tried, got, expected, advice: advice.into() }.named(name));
    }
    weights
}

/// Whether a share of all draws may come from this probability: within five standard deviations.
pub(super) fn is_share(share: f64, probability: f64) -> bool {
    let sigma = (probability * (1.0 - probability) / f64::from(COUNT)).max(0.0).sqrt();
    is_near(share, probability, 5.0 * sigma + 1e-5)
}

/// The way that a path went, if it is one of the two.
fn way(case: &Case, direction: Vec3, weight: f32) -> Result<Way, Diagnosis> {
    let is = |other: Vec3| (direction - other).length() < 1e-3;
    match case.refracted() {
        Some(refracted) if is(refracted) => return Ok(Way::Refracted),
        // Head-on glass of any index would do, so both are asked for.
        _ if is(case.reflected()) && !(case.refracted().is_none() && weight == 0.0) => return Ok(Way::Reflected),
        _ => {}
    }
    let (name, advice) = direction_mistake(case, direction);
    let (reflected, refracted) = (triple(case.reflected()), case.refracted().map(triple));
    let expected = match refracted {
        Some(refracted) => format!("the direction {reflected} or the direction {refracted}"),
        None => format!("the direction {reflected}, weight 1"),
    };
    let got = format!("the direction {}, weight {weight}", triple(direction));
    Err(Finding { tried: case.words(), got, expected, advice: advice.into() }.named(name))
}

/// Whether the new ray starts on the side into which it goes.
fn origin(case: &Case, next: &Ray, way: Way) -> Verdict {
    let away = next.origin - case.hit.position;
    let side = away.dot(case.hit.geometric_normal) * if way == Way::Reflected { 1.0 } else { -1.0 };
    let is_far = !is_near(away.length().into(), 0.0, 1e-3);
    let (name, advice) = match way {
        _ if is_far => ("starts-far-away", "The new ray starts where the old one ended, but for a tiny offset."),
        _ if side > 0.0 => return Ok(()),
        _ if side == 0.0 => (
            "no-offset",
            "The new ray starts on the surface itself, and by rounding it may hit it again at once: use `Offset::Following.origin`.",
        ),
        Way::Reflected => (
            "reflected-starts-behind",
            "The reflected ray starts on the side from which the ray came, to which the normal points.",
        ),
        Way::Refracted => (
            "refracted-starts-before",
            "The refracted ray goes on behind the surface, so it must start there. From before the surface it would hit it again.",
        ),
    };
    let got = format!("the {way:?} ray starts at {}", triple(next.origin)).to_lowercase();
    let expected = format!("a start near {}, on the side into which the ray goes", triple(case.hit.position));
    Err(Finding { tried: case.words(), got, expected, advice: advice.into() }.named(name))
}

/// Whether the weight is 1.
fn right_weight(case: &Case, way: Way, weight: f32) -> Verdict {
    if is_near(weight.into(), 1.0, 1e-4) {
        return Ok(());
    }
    let (name, advice) = weight_mistake(case, way, weight.into());
    let got = format!("the weight {} for the {way:?} ray", about(weight.into())).to_lowercase();
    Err(Finding { tried: case.words(), got, expected: "the weight 1".into(), advice: advice.into() }.named(name))
}
