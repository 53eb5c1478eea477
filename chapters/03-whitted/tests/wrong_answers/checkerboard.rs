//! Wrong checkerboards.

use common::Vec3;
use ray_casting::hit::{Hit, Side};
use shadows::offset::Offset;

use crate::{
    checks::checkerboard::{Answer, check},
    name,
};

fn is_dark(point: Vec3, size: f32) -> bool {
    (point / size).floor().element_sum().rem_euclid(2.0) == 1.0
}

fn is_dark_at(hit: &Hit, size: f32) -> bool {
    is_dark(hit.position - hit.geometric_normal * size * 0.001, size)
}

const RIGHT: Answer = Answer { is_dark, is_dark_at };

/// The diagnosis of such cubes.
fn cubes(is_dark: fn(Vec3, f32) -> bool) -> &'static str {
    name(check(Answer { is_dark, ..RIGHT }))
}

/// The diagnosis of such surfaces.
fn surfaces(is_dark_at: fn(&Hit, f32) -> bool) -> &'static str {
    name(check(Answer { is_dark_at, ..RIGHT }))
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(check(RIGHT), Ok(()));
    // Whole numbers are as good.
    let is_dark: fn(Vec3, f32) -> bool = |p, size| {
        let [i, j, k] = (p / size).floor().to_array().map(|x| x as i32);
        (i + j + k) % 2 != 0
    };
    assert_eq!(check(Answer { is_dark, ..RIGHT }), Ok(()));
    let is_dark: fn(Vec3, f32) -> bool = |p, size| {
        let [i, j, k] = (p / size).floor().to_array().map(|x| x as i64);
        (i ^ j ^ k) & 1 == 1
    };
    assert_eq!(check(Answer { is_dark, ..RIGHT }), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(name(check(Answer { is_dark: |_, _| false, is_dark_at: |_, _| false })), "not-started");
    assert_eq!(surfaces(|_, _| false), "surface-not-started");
}

#[test]
fn wrong_patterns() {
    assert_eq!(cubes(|p, size| !is_dark(p, size)), "colors-swapped");
    assert_eq!(cubes(|p, size| is_dark(p * Vec3::new(1.0, 0.0, 1.0), size)), "direction-forgotten");
    assert_eq!(
        cubes(|p, size| (p / size).floor().to_array().iter().any(|x| x.rem_euclid(2.0) == 1.0)),
        "not-alternating"
    );
    assert_eq!(cubes(|p, size| (p / size).floor().element_product().rem_euclid(2.0) == 1.0), "not-alternating");
    assert_eq!(cubes(|p, size| (p / size).round().element_sum().rem_euclid(2.0) == 1.0), "rounded");
    assert_eq!(cubes(|p, size| (p.element_sum() / size).floor().rem_euclid(2.0) == 1.0), "sum-before-floor");
    assert_eq!(cubes(|_, _| true), "wrong-pattern");
}

#[test]
fn wrong_below_zero() {
    assert_eq!(cubes(|p, size| (p / size).floor().element_sum() % 2.0 == 1.0), "remainder-negative");
    assert_eq!(cubes(|p, size| (p / size).trunc().element_sum().rem_euclid(2.0) == 1.0), "truncated");
    assert_eq!(
        cubes(|p, size| {
            let [i, j, k] = (p / size).to_array().map(|x| i64::from(x as i32));
            (i + j + k) % 2 != 0
        }),
        "truncated"
    );
    assert_eq!(cubes(|p, size| is_dark(p.abs(), size)), "truncated");
    // Everything below zero becomes zero, and zero is light.
    assert_eq!(
        cubes(|p, size| {
            let [i, j, k] = (p / size).to_array().map(|x| u64::from(x as u32));
            (i + j + k) % 2 == 1
        }),
        "remainder-negative"
    );
}

#[test]
fn wrong_sizes() {
    assert_eq!(cubes(|p, _| is_dark(p, 1.0)), "size-ignored");
    assert_eq!(cubes(|p, size| is_dark(p * size, 1.0)), "size-multiplied");
    assert_eq!(cubes(|p, size| is_dark(p / (size * size), 1.0)), "wrong-size");
}

#[test]
fn wrong_far_away() {
    assert_eq!(
        cubes(|p, size| {
            let [i, j, k] = (p / size).floor().to_array().map(|x| x as i8);
            (i ^ j ^ k) & 1 == 1
        }),
        "far-away"
    );
    assert_eq!(
        cubes(|p, size| {
            let [i, j, k] = (p / size).floor().to_array().map(|x| x as i16);
            (i ^ j ^ k) & 1 == 1
        }),
        "far-away"
    );
    assert_eq!(
        cubes(|p, size| is_dark(p.clamp(Vec3::splat(-50.0 * size), Vec3::splat(50.0 * size)), size)),
        "far-away"
    );
}

#[test]
fn wrong_depths() {
    assert_eq!(
        surfaces(|hit, size| is_dark(hit.position - hit.geometric_normal * size * 0.01, size)),
        "too-far-behind"
    );
    assert_eq!(surfaces(|hit, size| is_dark(hit.position - hit.geometric_normal * size * 0.5, size)), "too-far-behind");
    assert_eq!(
        surfaces(|hit, size| is_dark(hit.position - hit.geometric_normal * size * 0.002, size)),
        "too-far-behind"
    );
    assert_eq!(surfaces(|hit, size| is_dark(hit.position - hit.geometric_normal * size * 0.9, size)), "too-far-behind");
    assert_eq!(
        surfaces(|hit, size| is_dark(hit.position - hit.geometric_normal * size * 1e-4, size)),
        "not-far-enough"
    );
    assert_eq!(surfaces(|hit, size| is_dark(hit.position - hit.geometric_normal * size * 0.3, size)), "wrong-depth");
    assert_eq!(
        surfaces(|hit, size| is_dark(hit.position - hit.geometric_normal.signum() * size * 0.001, size)),
        "not-along-the-normal"
    );
}

#[test]
fn wrong_surfaces() {
    assert_eq!(
        surfaces(|hit, size| is_dark(hit.position - hit.geometric_normal * (0.001 / size), size)),
        "divided-by-size"
    );
    assert_eq!(
        surfaces(|hit, size| is_dark(Offset::Following.origin(hit, -hit.geometric_normal), size)),
        "offset-of-a-ray"
    );
    assert_eq!(surfaces(|hit, size| is_dark(hit.position, size)), "on-the-border");
    assert_eq!(
        surfaces(|hit, size| is_dark(hit.position + hit.geometric_normal * size * 0.001, size)),
        "before-the-surface"
    );
    assert_eq!(surfaces(|hit, size| is_dark(hit.position - hit.geometric_normal * 1e-3, size)), "fixed-shift");
    assert_eq!(surfaces(|hit, size| is_dark(hit.position - hit.geometric_normal * 1e-4, size)), "fixed-shift");
    assert_eq!(surfaces(|hit, size| is_dark(hit.position - hit.shading_normal * size * 0.001, size)), "shading-normal");
    assert_eq!(surfaces(|hit, size| is_dark(hit.position - Vec3::Y * size * 0.001, size)), "one-direction");
    assert_eq!(
        surfaces(|hit, size| {
            let outward = if hit.side == Side::Inside { -hit.geometric_normal } else { hit.geometric_normal };
            is_dark(hit.position - outward * size * 0.001, size)
        }),
        "side-twice"
    );
    assert_eq!(surfaces(|hit, size| is_dark(hit.position - hit.geometric_normal * size, size)), "wrong-surface");
}
