//! Mistakes planted on purpose: each is a step as others have taken it.

use common::{Rgb, Stream, Vec3, story::Untold};
use ray_casting::hit::Hit;
use sampling::sky_light::Choice;

use super::furnace::walked;
use crate::{
    importance::{Step, step},
    material::Material,
    method::Method,
    path_tracer::PathTracer,
};

/// How a path goes on, with a mistake.
pub type WrongStep = fn(&Method, &Material, &Hit, Vec3, &mut Stream) -> Option<Step>;

/// One path in the furnace with a mistake.
pub fn path(wrong: WrongStep) -> impl Fn(&PathTracer, &mut Stream) -> f64 + Sync {
    move |tracer, random| {
        walked(tracer, random, |material, hit, to_viewer, random, _| {
            wrong(&tracer.method, material, hit, to_viewer, random)
        })
    }
}

/// The right step, then changed where directions are uniform or in proportion to the cosine.
fn changed(
    choice: Choice,
    change: impl Fn(Step, &mut Stream) -> Step,
) -> impl Fn(&Method, &Material, &Hit, Vec3, &mut Stream) -> Option<Step> {
    move |method, material, hit, to_viewer, random| {
        let right = step(method, material, hit, to_viewer, random, &mut Untold)?;
        Some(if method.choice == choice { change(right, random) } else { right })
    }
}

/// Pitfall 13: 'n + a random point in the ball' is not Lambert's distribution, but is weighed as if it were.
pub fn ball_for_cosine(
    method: &Method,
    material: &Material,
    hit: &Hit,
    to_viewer: Vec3,
    random: &mut Stream,
) -> Option<Step> {
    changed(Choice::CosineAndMirror, |right, random| {
        let in_ball = loop {
            let point = Vec3::from_array([(); 3].map(|()| 2.0 * random.uniform() - 1.0));
            if point.length_squared() < 1.0 {
                break point;
            }
        };
        Step { direction: (hit.shading_normal + in_ball).normalize_or(hit.shading_normal), ..right }
    })(method, material, hit, to_viewer, random)
}

/// Pitfall 14: uniform directions without any weight, as if they were in proportion to the cosine.
pub fn no_weight(
    method: &Method,
    material: &Material,
    hit: &Hit,
    to_viewer: Vec3,
    random: &mut Stream,
) -> Option<Step> {
    let scale = if method.roulette { 1.0 } else { material.albedo().x };
    changed(Choice::Uniform, |right, _| Step { weight: Rgb::splat(scale), ..right })(
        method, material, hit, to_viewer, random,
    )
}

/// Pitfall 14 once more: `ρ cosθ` instead of `2ρ cosθ`.
pub fn no_factor_2(
    method: &Method,
    material: &Material,
    hit: &Hit,
    to_viewer: Vec3,
    random: &mut Stream,
) -> Option<Step> {
    changed(Choice::Uniform, |right, _| Step { weight: right.weight / 2.0, ..right })(
        method, material, hit, to_viewer, random,
    )
}

/// A roulette that survives with the weight of the step as probability, or `most` if that is less, and divides by it.
fn roulette_by_weight(right: Step, most: f32, random: &mut Stream) -> Option<Step> {
    let survival = right.weight.max_element().min(most);
    (random.uniform() < survival).then(|| Step { weight: right.weight / survival, ..right })
}

/// Pitfall 18: nobody keeps the probability of a roulette by weight from being greater than 1.
pub fn no_clamp(method: &Method, material: &Material, hit: &Hit, to_viewer: Vec3, random: &mut Stream) -> Option<Step> {
    let without = Method { roulette: false, ..method.clone() };
    let right = step(&without, material, hit, to_viewer, random, &mut Untold)?;
    if method.roulette { roulette_by_weight(right, f32::INFINITY, random) } else { Some(right) }
}

/// The right roulette of the same kind: never more than 1.
pub fn with_clamp(
    method: &Method,
    material: &Material,
    hit: &Hit,
    to_viewer: Vec3,
    random: &mut Stream,
) -> Option<Step> {
    let without = Method { roulette: false, ..method.clone() };
    roulette_by_weight(step(&without, material, hit, to_viewer, random, &mut Untold)?, 1.0, random)
}
