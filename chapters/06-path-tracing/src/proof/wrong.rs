//! Mistakes planted on purpose: each must make a cell of the furnace fail, or the furnace proves nothing.

use common::{Rgb, Stream, Vec3, story::Untold};
use ray_casting::hit::Hit;
use sampling::sky_light::Choice;

use super::furnace::{Cell, Glow, cells, is_right, measure, ray};
use crate::{
    importance::{Step, step},
    material::Material,
    method::Method,
    path_tracer::PathTracer,
};

/// How a path goes on, with a mistake.
type WrongStep = fn(&Method, &Material, &Hit, Vec3, &mut Stream) -> Option<Step>;

/// The cells that fail with a mistake.
fn failures(glow: Glow, wrong: WrongStep) -> Vec<Cell> {
    let path = |tracer: &PathTracer, random: &mut Stream| {
        let next = |material: &Material, hit: &Hit, to_viewer: Vec3, random: &mut Stream, _: &mut Untold| {
            wrong(&tracer.method, material, hit, to_viewer, random)
        };
        f64::from(tracer.walk(ray(), random, &mut Untold, next).x)
    };
    cells().filter(|cell| !is_right(&measure(path, *cell, glow), cell.expected(glow))).collect()
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
fn ball_for_cosine(
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
fn no_weight(method: &Method, material: &Material, hit: &Hit, to_viewer: Vec3, random: &mut Stream) -> Option<Step> {
    let scale = if method.roulette { 1.0 } else { material.albedo().x };
    changed(Choice::Uniform, |right, _| Step { weight: Rgb::splat(scale), ..right })(
        method, material, hit, to_viewer, random,
    )
}

/// Pitfall 14 once more: `ρ cosθ` instead of `2ρ cosθ`.
fn no_factor_2(method: &Method, material: &Material, hit: &Hit, to_viewer: Vec3, random: &mut Stream) -> Option<Step> {
    changed(Choice::Uniform, |right, _| Step { weight: right.weight / 2.0, ..right })(
        method, material, hit, to_viewer, random,
    )
}

/// Pitfall 18: the roulette survives with the weight of the step as probability, and divides by it, but nobody keeps it
/// from being greater than 1.
fn no_clamp(method: &Method, material: &Material, hit: &Hit, to_viewer: Vec3, random: &mut Stream) -> Option<Step> {
    let without = Method { roulette: false, ..method.clone() };
    let right = step(&without, material, hit, to_viewer, random, &mut Untold)?;
    if !method.roulette {
        return Some(right);
    }
    let survival = right.weight.max_element();
    (random.uniform() < survival).then(|| Step { weight: right.weight / survival, ..right })
}

/// The right roulette of the same kind: never more than 1.
fn with_clamp(method: &Method, material: &Material, hit: &Hit, to_viewer: Vec3, random: &mut Stream) -> Option<Step> {
    let without = Method { roulette: false, ..method.clone() };
    let right = step(&without, material, hit, to_viewer, random, &mut Untold)?;
    let survival = right.weight.max_element().min(1.0);
    (random.uniform() < survival).then(|| Step { weight: right.weight / survival, ..right })
}

/// All light alike hides where paths go: only the half furnace sees these.
#[test]
fn wrong_directions_are_caught_where_it_matters_where_they_go() {
    let cosine: Vec<_> = cells().filter(|cell| cell.choice == Choice::CosineAndMirror).collect();
    assert_eq!(failures(Glow::Half, ball_for_cosine), cosine);
    assert_eq!(failures(Glow::Whole, ball_for_cosine), []);
    let uniform: Vec<_> = cells().filter(|cell| cell.choice == Choice::Uniform).collect();
    assert_eq!(failures(Glow::Half, no_weight), uniform);
    assert_eq!(failures(Glow::Whole, no_weight), []);
}

#[test]
fn a_missing_factor_is_caught() {
    let uniform: Vec<_> = cells().filter(|cell| cell.choice == Choice::Uniform).collect();
    assert_eq!(failures(Glow::Whole, no_factor_2), uniform);
}

/// Only in one of the eight cells: this is why there are eight. There every bounce keeps ∫ min(1.6 c, 1) dc = 0.6875 of the
/// light instead of 0.8, and so the mean is 3.2 instead of 5.
#[test]
fn a_survival_probability_above_one_is_caught() {
    let caught = Cell { albedo: 0.8, choice: Choice::Uniform, roulette: true };
    assert_eq!(failures(Glow::Whole, no_clamp), [caught]);
    assert_eq!(failures(Glow::Whole, with_clamp), []);
    let wrong = |tracer: &PathTracer, random: &mut Stream| {
        let next = |material: &Material, hit: &Hit, to_viewer: Vec3, random: &mut Stream, _: &mut Untold| {
            no_clamp(&tracer.method, material, hit, to_viewer, random)
        };
        f64::from(tracer.walk(ray(), random, &mut Untold, next).x)
    };
    let estimate = measure(wrong, caught, Glow::Whole);
    assert!(is_right(&estimate, 3.2), "{estimate:?}");
}

/// Pitfall 17: paths cut off after D reflections lose the share ρ^(D + 1) of the light.
#[test]
fn a_cut_off_depth_is_caught() {
    const DEPTH: u32 = 4;
    for cell in cells() {
        let path = |tracer: &PathTracer, random: &mut Stream| {
            let method = Method { bounces: 0..=DEPTH, ..tracer.method.clone() };
            let cut = PathTracer { world: tracer.world.clone(), camera: tracer.camera, method };
            f64::from(cut.trace(ray(), random, &mut Untold).x)
        };
        let estimate = measure(path, cell, Glow::Whole);
        assert!(!is_right(&estimate, cell.expected(Glow::Whole)), "{cell:?}: {estimate:?}");
        let left = 1.0 - [f64::from(cell.albedo); DEPTH as usize + 1].into_iter().product::<f64>();
        assert!(is_right(&estimate, left * cell.expected(Glow::Whole)), "{cell:?}: {estimate:?}");
    }
}
