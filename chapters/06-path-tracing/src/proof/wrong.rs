//! Each mistake that is planted on purpose must make a cell of the furnace fail, or the furnace proves nothing.

use common::Stream;
use sampling::sky_light::Choice;

use crate::{
    experiments::{
        furnace::{Cell, Glow, cells, measure, traced},
        is_right,
        mistakes::{WrongStep, ball_for_cosine, no_clamp, no_factor_2, no_weight, path, with_clamp},
    },
    method::Method,
    path_tracer::PathTracer,
};

/// The cells that fail with a mistake.
fn failures(glow: Glow, wrong: WrongStep) -> Vec<Cell> {
    cells().filter(|cell| !is_right(&measure(*cell, glow, path(wrong)).unwrap(), cell.expected(glow))).collect()
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
    let estimate = measure(caught, Glow::Whole, path(no_clamp)).unwrap();
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
            traced(&cut, random)
        };
        let estimate = measure(cell, Glow::Whole, path).unwrap();
        assert!(!is_right(&estimate, cell.expected(Glow::Whole)), "{cell:?}: {estimate:?}");
        let left = 1.0 - [f64::from(cell.albedo); DEPTH as usize + 1].into_iter().product::<f64>();
        assert!(is_right(&estimate, left * cell.expected(Glow::Whole)), "{cell:?}: {estimate:?}");
    }
}
