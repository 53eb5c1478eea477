//! Wrong dispersion, all of one recipe with one ingredient changed.

use common::{Interval, Rgb, Vec3, exercise::Verdict};
use ray_casting::{
    hit::{Hit, Side},
    ray::Ray,
};
use shadows::offset::Offset;
use whitted::{
    branches::Branch,
    fresnel::{approximate, at_normal_incidence, exact},
    material::{Fresnel, Material},
    probe::Kind,
    reflection::reflect,
    refraction::refract,
};

use crate::{
    checks::dispersion::{Answer, check},
    name,
};

type Branches = [Option<Branch>; 4];

/// How rays are sent on, as the right answer does it, with one thing to change.
struct Recipe {
    normal: fn(&Hit) -> Vec3,
    relative: fn(Rgb, Side) -> Rgb,
    reflectance: fn(f32, Rgb) -> Rgb,
    refracted: fn(Vec3, Vec3, f32) -> Option<Vec3>,
    /// Shares of the three refracted rays by F.
    shares: fn(Rgb) -> [Rgb; 3],
    change: fn(&Hit, Branch) -> Branch,
}

const RIGHT: Recipe = Recipe {
    normal: |hit| hit.shading_normal,
    relative: |n, side| if side == Side::Inside { n.recip() } else { n },
    reflectance: |cosine, n| Rgb::from_array(n.to_array().map(|n| exact(cosine, n, 0.0))),
    refracted: refract,
    shares: |f| [Rgb::X, Rgb::Y, Rgb::Z].map(|channel| channel * (Rgb::ONE - f)),
    change: |_, branch| branch,
};

fn by(recipe: &Recipe, ray: &Ray, hit: &Hit, index: Rgb) -> Branches {
    let normal = (recipe.normal)(hit);
    let index = (recipe.relative)(index, hit.side);
    let f = (recipe.reflectance)(-ray.direction.dot(normal), index);
    let branch = |kind, side: f32, direction, share| {
        let ray = Ray::new(Offset::Following.origin(hit, side * hit.geometric_normal), direction);
        (recipe.change)(hit, Branch { kind, ray, range: Interval::POSITIVE, share })
    };
    let [r, g, b] = [0, 1, 2].map(|c| {
        let direction = (recipe.refracted)(ray.direction, normal, index[c])?;
        Some(branch(Kind::Refracted, -1.0, direction, (recipe.shares)(f)[c]))
    });
    [Some(branch(Kind::Reflected, 1.0, reflect(ray.direction, normal), f)), r, g, b]
}

const fn cauchy(a: f32, b: f32, nanometers: f32) -> f32 {
    a + b * 1e6 / (nanometers * nanometers)
}

fn indices(cauchy: fn(f32, f32, f32) -> f32) -> &'static str {
    name(check(Answer { cauchy, branches: |ray, hit, n| by(&RIGHT, ray, hit, n) }))
}

fn verdict(branches: fn(&Ray, &Hit, Rgb) -> Branches) -> Verdict {
    check(Answer { cauchy, branches })
}

/// The diagnosis of the recipe with one thing changed.
macro_rules! diagnosis {
    ($($field:ident: $value:expr),+) => {
        name(verdict(|ray, hit, n| by(&Recipe { $($field: $value,)+ ..RIGHT }, ray, hit, n)))
    };
}

#[test]
fn the_right_one_is_accepted_in_any_order() {
    assert_eq!(verdict(|ray, hit, n| by(&RIGHT, ray, hit, n)), Ok(()));
    assert_eq!(
        verdict(|ray, hit, n| {
            let mut branches = by(&RIGHT, ray, hit, n);
            branches.reverse();
            branches
        }),
        Ok(())
    );
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(name(check(Answer { cauchy: |_, _, _| 1.0, branches: |_, _, _| [None; 4] })), "not-started");
    assert_eq!(name(verdict(|_, _, _| [None; 4])), "branches-not-started");
    assert_eq!(indices(|_, _, _| 1.0), "cauchy-not-started");
}

#[test]
fn wrong_indices() {
    assert_eq!(indices(|a, b, nm| a + b / (nm * nm)), "nanometers");
    assert_eq!(indices(|a, b, nm| a + b / (nm * nm / 1000.0)), "nanometers");
    assert_eq!(indices(|a, b, nm| a + b * 1e3 / nm), "not-squared");
    assert_eq!(indices(|a, b, nm| a + b * nm * nm * 1e-6), "multiplied");
    assert_eq!(indices(|a, b, nm| a - b * 1e6 / (nm * nm)), "minus");
    assert_eq!(indices(|a, b, nm| cauchy(b, a, nm)), "swapped");
    assert_eq!(indices(|a, _, _| a), "nanometers");
    assert_eq!(indices(|_, b, nm| b * 1e6 / (nm * nm)), "a-missing");
    assert_eq!(indices(|a, b, nm| a + b / (nm * 1e-6 * nm * 1e-6)), "wrong-unit");
    assert_eq!(indices(|_, _, _| f32::NAN), "not-a-number");
}

#[test]
fn wrong_normals() {
    assert_eq!(diagnosis!(normal: |hit| hit.geometric_normal), "geometric-normal");
    // One of the three that need it.
    assert_eq!(
        name(verdict(|ray, hit, n| {
            let [reflected, ..] = by(&RIGHT, ray, hit, n);
            let [_, r, g, b] = by(&Recipe { normal: |hit| hit.geometric_normal, ..RIGHT }, ray, hit, n);
            [reflected, r, g, b]
        })),
        "geometric-normal"
    );
    assert_eq!(
        name(verdict(|ray, hit, n| {
            let right = by(&RIGHT, ray, hit, n);
            let flat = by(&Recipe { normal: |hit| hit.geometric_normal, ..RIGHT }, ray, hit, n);
            [0, 1, 2, 3].map(|i| right[i].map(|b| Branch { share: flat[i].map_or(b.share, |f| f.share), ..b }))
        })),
        "geometric-normal"
    );
    assert_eq!(
        diagnosis!(change: |hit, b| {
            let side = if b.kind == Kind::Reflected { 1.0 } else { -1.0 };
            Branch { ray: Ray::new(Offset::Following.origin(hit, side * hit.shading_normal), b.ray.direction), ..b }
        }),
        "offset-by-shading-normal"
    );
    // Turned once more, though it faces the ray already.
    assert_eq!(
        diagnosis!(normal: |hit| if hit.side == Side::Inside { -hit.shading_normal } else { hit.shading_normal }),
        "nothing-refracted"
    );
    assert_eq!(diagnosis!(reflectance: |cosine, n| (RIGHT.reflectance)(-cosine, n)), "nothing-refracted");
}

#[test]
fn wrong_kinds() {
    assert_eq!(diagnosis!(change: |_, b| Branch { kind: Kind::Reflected, ..b }), "wrong-kind");
    assert_eq!(diagnosis!(change: |_, b| Branch { kind: Kind::Refracted, ..b }), "wrong-kind");
    assert_eq!(diagnosis!(change: |_, b| Branch { kind: Kind::Camera, ..b }), "wrong-kind");
}

#[test]
fn not_split() {
    // What the chapter's own function does: all channels by the index of red.
    let chapters_own = |ray: &Ray, hit: &Hit, index: Rgb| {
        let material = Material { index, ..Material::glass(1.5) };
        let [a, b] = whitted::branches::branches(ray, hit, &material, Fresnel::Exact, Offset::Following);
        [a, b, None, None]
    };
    assert_eq!(name(check(Answer { cauchy, branches: chapters_own })), "not-split");
    assert_eq!(diagnosis!(shares: |f| [Rgb::ONE - f; 3]), "channels-not-parted");
    assert_eq!(diagnosis!(shares: |f| [(Rgb::ONE - f) / 3.0; 3]), "channels-not-parted");
    assert_eq!(diagnosis!(relative: |n, side| (RIGHT.relative)(Rgb::splat(n.y), side)), "wrong-channel");
}

#[test]
fn wrong_sides() {
    assert_eq!(diagnosis!(relative: |n, _| n), "index-from-inside");
    assert_eq!(diagnosis!(relative: |n, _| n.recip()), "index-reversed");
    assert_eq!(diagnosis!(relative: |n, side| if side == Side::Outside { n.recip() } else { n }), "index-reversed");
    assert_eq!(
        diagnosis!(change: |hit, b| Branch {
            ray: Ray::new(Offset::Following.origin(hit, hit.geometric_normal), b.ray.direction),
            ..b
        }),
        "starts-on-the-wrong-side"
    );
    assert_eq!(
        diagnosis!(change: |hit, b| Branch { ray: Ray::new(hit.position, b.ray.direction), ..b }),
        "wrong-offset"
    );
    assert_eq!(
        diagnosis!(change: |hit, b| {
            let side = if b.kind == Kind::Reflected { 1.0 } else { -1.0 };
            Branch { ray: Ray::new(Offset::Bits.origin(hit, side * hit.geometric_normal), b.ray.direction), ..b }
        }),
        "offset-by-bits"
    );
    assert_eq!(diagnosis!(change: |hit, b| Branch { range: Interval::new(hit.t, f32::INFINITY), ..b }), "wrong-range");
}

#[test]
fn wrong_total_reflection() {
    // A direction along the surface, or straight on.
    assert_eq!(
        diagnosis!(refracted: |d, n, eta| refract(d, n, eta).or(Some(d)),
                          reflectance: |cosine, n| (RIGHT.reflectance)(cosine, n).min(Rgb::splat(0.9))),
        "invented-direction"
    );
    // The same with a share of zero.
    assert_eq!(diagnosis!(refracted: |d, n, eta| refract(d, n, eta).or(Some(d))), "invented-direction");
    assert_eq!(
        name(verdict(|ray, hit, n| {
            let branches = by(&RIGHT, ray, hit, n);
            let is_total = branches.iter().flatten().count() < 4;
            if is_total { [branches[0].map(|b| Branch { share: Rgb::ONE, ..b }), None, None, None] } else { branches }
        })),
        "all-or-nothing"
    );
    assert_eq!(
        diagnosis!(reflectance: |cosine, n| {
            let f = (RIGHT.reflectance)(cosine, n);
            Rgb::from_array(f.to_array().map(|f| if f >= 1.0 { 0.04 } else { f }))
        }),
        "total-reflection-dimmed"
    );
}

/// The right rays, but for the reflected share.
fn changed(ray: &Ray, hit: &Hit, n: Rgb, change: fn(Rgb) -> Rgb) -> Branches {
    by(&RIGHT, ray, hit, n)
        .map(|b| b.map(|b| if b.kind == Kind::Reflected { Branch { share: change(b.share), ..b } } else { b }))
}

#[test]
fn wrong_shares() {
    assert_eq!(diagnosis!(reflectance: |cosine, n| Rgb::splat(exact(cosine, n.y, 0.0))), "one-reflectance");
    assert_eq!(
        diagnosis!(reflectance: |cosine, n| Rgb::from_array(
            n.to_array().map(|n| approximate(cosine, at_normal_incidence(n, 0.0)))
        )),
        "approximated"
    );
    assert_eq!(
        name(verdict(|ray, hit, n| by(&RIGHT, ray, hit, n).map(|b| b.map(|b| match b.kind {
            Kind::Reflected => Branch { share: Rgb::ONE, ..b },
            _ => b,
        })))),
        "shares-missing"
    );
    assert_eq!(diagnosis!(shares: |_| [Rgb::X, Rgb::Y, Rgb::Z]), "energy");
    assert_eq!(
        name(verdict(|ray, hit, n| changed(ray, hit, n, |f| Rgb::splat(f.element_sum() / 3.0)))),
        "mean-reflectance"
    );
    assert_eq!(name(verdict(|ray, hit, n| changed(ray, hit, n, |f| f * 0.5))), "share-divided");
    assert_eq!(name(verdict(|ray, hit, n| changed(ray, hit, n, |f| f.with_y(0.0)))), "channel-missing");
    assert_eq!(name(verdict(|ray, hit, n| changed(ray, hit, n, |f| f * f32::NAN))), "not-a-number");
    assert_eq!(
        name(verdict(|ray, hit, n| by(&RIGHT, ray, hit, n).map(|b| b.filter(|b| b.kind != Kind::Reflected)))),
        "no-reflection"
    );
}
