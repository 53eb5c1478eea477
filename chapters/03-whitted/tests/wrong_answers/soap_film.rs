//! Wrong soap films.

use std::f32::consts::PI;

use common::{Interval, Rgb, Vec3, float};
use ray_casting::{hit::Hit, ray::Ray};
use shadows::offset::Offset;
use whitted::{branches::Branch, probe::Kind, reflection::reflect, refraction::refract};

use crate::{
    checks::soap_film::{Answer, check},
    name,
};

fn inside(cosine: f32, n: f32) -> f32 {
    (1.0 - (1.0 - cosine * cosine) / (n * n)).sqrt()
}

fn phase(cosine: f32, n: f32, d: f32, lambda: f32) -> f32 {
    4.0 * PI * n * d * inside(cosine, n) / lambda
}

fn airy(r: f32, phase: f32) -> f32 {
    let (r2, cos) = (r * r, float::cos(phase));
    2.0 * r2 * (1.0 - cos) / (1.0 + r2 * r2 - 2.0 * r2 * cos)
}

fn amplitudes(c: f32, n: f32) -> [f32; 2] {
    let i = inside(c, n);
    [(c - n * i) / (c + n * i), (n * c - i) / (n * c + i)]
}

fn mean(c: f32, n: f32, one: impl Fn(f32) -> f32) -> f32 {
    amplitudes(c, n).map(one).iter().sum::<f32>() / 2.0
}

fn reflectance(c: f32, n: f32, d: f32, lambda: f32) -> f32 {
    mean(c, n, |r| airy(r, phase(c, n, d, lambda)))
}

fn branches(ray: &Ray, hit: &Hit, color: Rgb) -> [Option<Branch>; 2] {
    let origin = Offset::Following.origin(hit, hit.geometric_normal);
    let mirrored = Ray::new(origin, reflect(ray.direction, hit.shading_normal));
    let range = Interval::new(hit.t, f32::INFINITY);
    [
        Some(Branch { kind: Kind::Reflected, ray: mirrored, range: Interval::POSITIVE, share: color }),
        Some(Branch { kind: Kind::Refracted, ray: *ray, range, share: Rgb::ONE - color }),
    ]
}

const RIGHT: Answer = Answer { reflectance, branches };

fn films(reflectance: fn(f32, f32, f32, f32) -> f32) -> &'static str {
    name(check(Answer { reflectance, ..RIGHT }))
}

fn rays(branches: fn(&Ray, &Hit, Rgb) -> [Option<Branch>; 2]) -> &'static str {
    name(check(Answer { branches, ..RIGHT }))
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(check(RIGHT), Ok(()));
    // A new ray behind the film is as good.
    let behind = |ray: &Ray, hit: &Hit, color| {
        let [reflected, straight] = branches(ray, hit, color);
        let ray = Ray::new(Offset::Following.origin(hit, -hit.geometric_normal), ray.direction);
        [straight.map(|b| Branch { ray, range: Interval::POSITIVE, ..b }), reflected]
    };
    assert_eq!(check(Answer { branches: behind, ..RIGHT }), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(films(|_, _, _, _| 0.0), "not-started");
    assert_eq!(rays(|_, _, _| [None; 2]), "branches-not-started");
}

#[test]
fn wrong_phases() {
    assert_eq!(films(|c, n, d, l| reflectance(c, n, d / 2.0, l)), "one-way");
    assert_eq!(films(|c, n, d, l| reflectance(c, n, d / n, l)), "index-forgotten");
    assert_eq!(films(|c, n, d, l| reflectance(c, n, d / inside(c, n), l)), "cosine-forgotten");
    assert_eq!(films(|c, n, d, l| reflectance(c, n, d / inside(c, n) * c, l)), "cosine-outside");
    assert_eq!(films(|c, n, d, l| reflectance(c, n, d / inside(c, n) / inside(c, n), l)), "cosine-divides");
    // Phase turned by half a wave.
    assert_eq!(films(|c, n, d, l| mean(c, n, |r| airy(r, phase(c, n, d, l) + PI))), "flip-forgotten");
}

#[test]
fn wrong_sums() {
    assert_eq!(films(|c, n, d, l| mean(c, n, |r| 2.0 * r * r * (1.0 - float::cos(phase(c, n, d, l))))), "two-waves");
    assert_eq!(films(|c, n, _, _| mean(c, n, |r| r * r)), "no-interference");
    assert_eq!(films(|c, n, _, _| mean(c, n, |r| 2.0 * r * r / (1.0 + r * r))), "no-interference");
    assert_eq!(films(|c, n, d, l| airy(amplitudes(c, n)[0], phase(c, n, d, l))), "one-polarization");
    assert_eq!(films(|c, n, d, l| airy(amplitudes(c, n)[1], phase(c, n, d, l))), "one-polarization");
    assert_eq!(films(|c, n, d, l| airy(mean(c, n, |r| r * r).sqrt(), phase(c, n, d, l))), "mean-too-early");
    assert_eq!(films(|c, n, d, l| 2.0 * reflectance(c, n, d, l)), "sum-not-mean");
    assert_eq!(films(|c, n, d, l| mean(c, n, |r| airy(r, phase(c, n, d, l)).sqrt())), "not-squared");
    assert_eq!(films(|c, n, d, l| 1.0 - reflectance(c, n, d, l)), "transmitted");
    assert_eq!(films(|c, n, d, l| 0.5 * reflectance(c, n, d, l)), "wrong-reflectance");
    assert_eq!(films(|_, _, _, _| f32::NAN), "not-a-number");
}

/// Airy's formula with these signs, by `r` above and below.
fn quotient([above, below]: [f32; 2], [r_above, r_below]: [f32; 2], phase: f32) -> f32 {
    let cos = float::cos(phase);
    2.0 * r_above * (1.0 + above * cos) / (1.0 + r_below * r_below + 2.0 * below * r_below * cos)
}

#[test]
fn wrong_formulas() {
    // At the first question this comes as near to the front alone as 0.046764 to 0.046781.
    assert_eq!(
        films(|c, n, d, l| mean(c, n, |r| quotient([1.0, -1.0], [r * r; 2], phase(c, n, d, l)))),
        "numerator-sign"
    );
    assert_eq!(
        films(|c, n, d, l| mean(c, n, |r| quotient([-1.0, 1.0], [r * r; 2], phase(c, n, d, l)))),
        "denominator-sign"
    );
    assert_eq!(
        films(|c, n, d, l| mean(c, n, |r| quotient([-1.0, -1.0], [r; 2], phase(c, n, d, l)))),
        "amplitude-for-its-square"
    );
    assert_eq!(
        films(|c, n, d, l| mean(c, n, |r| quotient([-1.0, -1.0], [r, r * r], phase(c, n, d, l)))),
        "amplitude-for-its-square"
    );
    assert_eq!(films(|c, n, d, l| mean(c, n, |r| airy(r, phase(c, n, d, l).to_degrees()))), "degrees");
    assert_eq!(films(|c, n, d, l| mean(c, n, |r| airy(r, phase(c, n, d, l).to_radians()))), "degrees");
    assert_eq!(
        films(|c, n, d, l| {
            let i = (1.0 - (1.0 - c * c) * n * n).sqrt();
            let phase = 4.0 * PI * n * d * i / l;
            (airy((c - n * i) / (c + n * i), phase) + airy((n * c - i) / (n * c + i), phase)) / 2.0
        }),
        "snell-reversed"
    );
}

/// The right rays, but mirrored at this normal, and started along that one.
fn mirrored(ray: &Ray, hit: &Hit, color: Rgb, [normal, start]: [Vec3; 2]) -> [Option<Branch>; 2] {
    let ray_before = Ray::new(Offset::Following.origin(hit, start), reflect(ray.direction, normal));
    branches(ray, hit, color)
        .map(|b| b.map(|b| if b.kind == Kind::Reflected { Branch { ray: ray_before, ..b } } else { b }))
}

#[test]
fn wrong_rays() {
    assert_eq!(
        rays(|ray, hit, color| branches(ray, hit, color).map(|b| b.map(|b| Branch { kind: Kind::Reflected, ..b }))),
        "wrong-kind"
    );
    assert_eq!(
        rays(|ray, hit, color| branches(ray, hit, color).map(|b| b.map(|b| {
            let kind = if b.kind == Kind::Reflected { Kind::Refracted } else { Kind::Reflected };
            Branch { kind, ..b }
        }))),
        "wrong-kind"
    );
    assert_eq!(rays(|ray, hit, color| mirrored(ray, hit, color, [hit.geometric_normal; 2])), "geometric-normal");
    assert_eq!(rays(|ray, hit, color| mirrored(ray, hit, color, [hit.shading_normal; 2])), "offset-by-shading-normal");
    assert_eq!(rays(|ray, hit, color| [branches(ray, hit, color)[0], None]), "ray-missing");
    assert_eq!(rays(|ray, hit, color| branches(ray, hit, Rgb::ONE - color)), "shares-swapped");
    assert_eq!(
        rays(|ray, hit, color| branches(ray, hit, color).map(|b| b.map(|b| Branch { share: color, ..b }))),
        "wrong-share"
    );
    assert_eq!(
        rays(|ray, hit, color| branches(ray, hit, color).map(|b| b.map(|b| Branch { range: Interval::POSITIVE, ..b }))),
        "hits-again"
    );
    assert_eq!(
        rays(|ray, hit, color| branches(ray, hit, color).map(|b| b.map(|b| match b.kind {
            Kind::Refracted => {
                let direction = refract(ray.direction, hit.shading_normal, 1.33).unwrap();
                Branch { ray: Ray::new(ray.origin, direction), ..b }
            }
            _ => b,
        }))),
        "bent"
    );
    assert_eq!(
        rays(|ray, hit, color| branches(ray, hit, color).map(|b| b.map(|b| match b.kind {
            Kind::Reflected => Branch { ray: Ray::new(hit.position, b.ray.direction), ..b },
            _ => b,
        }))),
        "wrong-start"
    );
}
