//! Wrong glossy lobes.

use common::{Basis, Vec2, Vec3, float};
use sampling::direction_sample::{Density, DirectionSample};
use whitted::reflection::reflect;

use crate::{
    checks::phong_lobe::{Answer, check},
    name,
};

/// A unit vector of this height.
fn around(height: f32, turn: f32) -> Vec3 {
    let radius = (1.0 - height * height).max(0.0).sqrt();
    let angle = std::f32::consts::TAU * turn;
    Vec3::new(radius * float::cos(angle), radius * float::sin(angle), height)
}

fn lobe(exponent: f32, u: Vec2) -> Vec3 {
    around(float::pow(u.x, (exponent + 1.0).recip()), u.y)
}

fn pdf(exponent: f32, cos_alpha: f32) -> f32 {
    let power = float::pow(cos_alpha.max(0.0), exponent);
    if cos_alpha > 0.0 { (exponent + 1.0) * power / std::f32::consts::TAU } else { 0.0 }
}

/// The lobe around an axis.
fn along(axis: Vec3, normal: Vec3, exponent: f32, u: Vec2) -> Option<DirectionSample> {
    let direction = Basis::around(axis).to_world(lobe(exponent, u));
    let density = Density::SolidAngle(pdf(exponent, direction.dot(axis)));
    (direction.dot(normal) > 0.0).then_some(DirectionSample { direction, density })
}

fn glossy(normal: Vec3, to_viewer: Vec3, exponent: f32, u: Vec2) -> Option<DirectionSample> {
    along(reflect(-to_viewer, normal), normal, exponent, u)
}

const RIGHT: Answer = Answer { sample_phong_lobe: lobe, phong_lobe_pdf: pdf, sample_glossy: glossy };

/// The diagnosis of such a lobe.
fn lobes(sample_phong_lobe: fn(f32, Vec2) -> Vec3) -> &'static str {
    name(check(Answer { sample_phong_lobe, ..RIGHT }))
}

/// The diagnosis of such a density.
fn pdfs(phong_lobe_pdf: fn(f32, f32) -> f32) -> &'static str {
    name(check(Answer { phong_lobe_pdf, ..RIGHT }))
}

/// The diagnosis of such directions.
fn glossies(sample_glossy: fn(Vec3, Vec3, f32, Vec2) -> Option<DirectionSample>) -> &'static str {
    name(check(Answer { sample_glossy, ..RIGHT }))
}

/// The right sample with another density.
fn with(
    density: impl Fn(&DirectionSample) -> Density,
    [normal, to_viewer]: [Vec3; 2],
    exponent: f32,
    u: Vec2,
) -> Option<DirectionSample> {
    glossy(normal, to_viewer, exponent, u).map(|sample| DirectionSample { density: density(&sample), ..sample })
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(check(RIGHT), Ok(()));
    // The numbers of u may serve in either order, and either way round.
    let other: fn(f32, Vec2) -> Vec3 = |exponent, u| lobe(exponent, Vec2::new(1.0 - u.y, u.x));
    let other_glossy: fn(Vec3, Vec3, f32, Vec2) -> Option<DirectionSample> =
        |normal, to_viewer, exponent, u| glossy(normal, to_viewer, exponent, Vec2::new(1.0 - u.y, u.x));
    assert_eq!(check(Answer { sample_phong_lobe: other, sample_glossy: other_glossy, ..RIGHT }), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    let nothing =
        Answer { sample_phong_lobe: |_, _| Vec3::Z, phong_lobe_pdf: |_, _| 0.0, sample_glossy: |_, _, _, _| None };
    assert_eq!(name(check(nothing)), "not-started");
    assert_eq!(name(check(Answer { sample_phong_lobe: lobe, ..nothing })), "pdf-not-started");
    assert_eq!(glossies(|_, _, _, _| None), "glossy-not-started");
}

#[test]
fn wrong_lobes() {
    assert_eq!(lobes(|n, u| around(float::pow(u.x, 1.0 / n.max(1e-3)), u.y)), "exponent-one-off");
    assert_eq!(lobes(|n, u| lobe(n + 1.0, u)), "exponent-one-off");
    assert_eq!(lobes(|n, u| around(float::pow(u.x, n + 1.0), u.y)), "power-for-root");
    assert_eq!(lobes(|_, u| lobe(0.0, u)), "exponent-ignored");
    assert_eq!(lobes(|_, u| lobe(1.0, u)), "exponent-ignored");
    assert_eq!(lobes(|n, u| lobe(n, u * Vec2::new(1.0, 0.5))), "not-uniform-around");
    assert_eq!(lobes(|n, u| lobe(n, Vec2::splat(u.x))), "not-uniform-around");
    assert_eq!(lobes(|n, u| around(1.0 - float::pow(u.x, 1.0 / (n + 1.0)), u.y)), "power-for-root");
    assert_eq!(lobes(|n, u| lobe(n, u) * Vec3::new(2.0, 1.0, 1.0)), "not-a-unit-vector");
    assert_eq!(lobes(|_, _| Vec3::NAN), "not-a-unit-vector");
    assert_eq!(lobes(|n, u| -lobe(n, u)), "behind");
    assert_eq!(lobes(|n, u| lobe(2.0 * n + 3.0, u)), "wrong-lobe");
}

#[test]
fn wrong_densities() {
    assert_eq!(pdfs(|n, c| float::pow(c.max(0.0), n)), "not-normalized");
    assert_eq!(pdfs(|n, c| (n + 1.0) * float::pow(c.max(0.0), n)), "not-normalized");
    assert_eq!(pdfs(|n, c| pdf(n, c) * (n + 2.0) / (n + 1.0)), "factor-of-the-brdf");
    assert_eq!(pdfs(|n, c| pdf(n, c) * n / (n + 1.0)), "exponent-one-off");
    assert_eq!(pdfs(|n, c| 2.0 * pdf(n, c)), "half-or-twice");
    assert_eq!(pdfs(|n, c| pdf(n, c) / 2.0), "half-or-twice");
    assert_eq!(pdfs(|n, c| pdf(n, c) * c), "cosine-too-many");
    assert_eq!(pdfs(|n, c| pdf(n + 1.0, c)), "wrong-pdf");
    assert_eq!(pdfs(|_, _| f32::NAN), "wrong-pdf");
    assert_eq!(pdfs(|n, c| (n + 1.0) / std::f32::consts::TAU * float::pow(c, n)), "behind-not-zero");
}

#[test]
fn wrong_directions() {
    assert_eq!(glossies(|normal, _, n, u| along(normal, normal, n, u)), "around-the-normal");
    assert_eq!(glossies(|normal, to_viewer, n, u| along(to_viewer, normal, n, u)), "toward-the-viewer");
    assert_eq!(
        glossies(|normal, to_viewer, n, u| along(reflect(to_viewer, normal), -normal, n, u)),
        "below-the-horizon"
    );
    assert_eq!(
        glossies(|normal, to_viewer, n, u| along(reflect(-to_viewer, normal), Vec3::ZERO, n, u).or_else(|| {
            let axis = reflect(-to_viewer, normal);
            along(axis, axis, n, u)
        })),
        "below-the-horizon"
    );
    // Drawn again, and turned up.
    assert_eq!(
        glossies(|normal, to_viewer, n, u| {
            let other = |i: f32| (u + Vec2::new(0.618_034, 0.754_878) * i).fract();
            (0..50_u8).find_map(|i| glossy(normal, to_viewer, n, other(i.into())))
        }),
        "never-dropped"
    );
    assert_eq!(
        glossies(|normal, to_viewer, n, u| {
            let axis = reflect(-to_viewer, normal);
            let sample = along(axis, axis, n, u)?;
            let up = normal * (sample.direction.dot(normal).abs() - sample.direction.dot(normal));
            Some(DirectionSample { direction: sample.direction + up, ..sample })
        }),
        "never-dropped"
    );
    assert_eq!(
        glossies(|normal, to_viewer, n, u| glossy(normal, to_viewer, n, u).filter(|_| u.y > 0.1)),
        "wrong-directions"
    );
    assert_eq!(glossies(|normal, to_viewer, n, u| glossy(normal, to_viewer, n * 1.5, u)), "wrong-directions");
    assert_eq!(
        glossies(|normal, to_viewer, n, u| {
            let sample = glossy(normal, to_viewer, n, u)?;
            Some(DirectionSample { direction: sample.direction * 2.0, ..sample })
        }),
        "glossy-not-a-unit-vector"
    );
}

#[test]
fn wrong_densities_of_directions() {
    assert_eq!(glossies(|normal, v, n, u| with(|_| Density::Discrete(1.0), [normal, v], n, u)), "discrete");
    assert_eq!(
        glossies(|normal, v, n, u| with(|s| Density::SolidAngle(pdf(n, s.direction.dot(normal))), [normal, v], n, u)),
        "angle-to-the-normal"
    );
    assert_eq!(
        glossies(|normal, v, n, u| with(|s| s.density.with_probability(s.direction.dot(normal)), [normal, v], n, u)),
        "cosine-in-the-density"
    );
    assert_eq!(glossies(|normal, v, n, u| with(|_| Density::SolidAngle(1.0), [normal, v], n, u)), "wrong-density");
}
