//! Wrong glass.

use common::{Stream, Vec3};
use ray_casting::{
    hit::{Hit, Side},
    ray::Ray,
};
use shadows::offset::Offset;
use whitted::{
    fresnel::{approximate, at_normal_incidence, exact},
    reflection::reflect,
    refraction::refract,
};

use crate::{
    checks::{glass::check, glass_world::GlassStep},
    name,
};

fn ratio(index: f32, side: Side) -> f32 {
    if side == Side::Outside { index } else { index.recip() }
}

fn cosine(ray: &Ray, hit: &Hit) -> f32 {
    -ray.direction.dot(hit.shading_normal)
}

/// The share of reflected light.
fn share(index: f32, ray: &Ray, hit: &Hit) -> f32 {
    exact(cosine(ray, hit), ratio(index, hit.side), 0.0)
}

/// Glass by the direction behind the surface, if any, and the probability of a reflection.
fn glass(refracted: Option<Vec3>, probability: f32, ray: &Ray, hit: &Hit, random: &mut Stream) -> (Ray, f32) {
    match refracted {
        Some(direction) if random.uniform() >= probability => {
            (Ray::new(Offset::Following.origin(hit, -hit.geometric_normal), direction), 1.0)
        }
        _ => {
            let direction = reflect(ray.direction, hit.shading_normal);
            (Ray::new(Offset::Following.origin(hit, hit.geometric_normal), direction), 1.0)
        }
    }
}

fn right(index: f32, ray: &Ray, hit: &Hit, random: &mut Stream) -> (Ray, f32) {
    let refracted = refract(ray.direction, hit.shading_normal, ratio(index, hit.side));
    glass(refracted, share(index, ray, hit), ray, hit, random)
}

/// Whether a ray that comes out of [`right`] was reflected.
fn is_reflected(next: &Ray, hit: &Hit) -> bool {
    next.direction.dot(hit.shading_normal) > 0.0
}

fn diagnosis(glass_step: GlassStep) -> &'static str {
    name(check(glass_step))
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(check(right), Ok(()));
    // The number may be compared the other way round, and be drawn where there is no choice.
    let other: GlassStep = |index, ray, hit, random| {
        let u = 1.0 - random.uniform();
        let refracted = refract(ray.direction, hit.shading_normal, ratio(index, hit.side));
        match refracted {
            Some(direction) if u > share(index, ray, hit) => {
                (Ray::new(Offset::Bits.origin(hit, -hit.geometric_normal), direction), 1.0)
            }
            _ => {
                let direction = reflect(ray.direction, hit.shading_normal);
                (Ray::new(Offset::Bits.origin(hit, hit.geometric_normal), direction), 1.0)
            }
        }
    };
    assert_eq!(check(other), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(diagnosis(|_, ray, hit, _| (Ray::new(hit.position, ray.direction), 0.0)), "not-started");
}

#[test]
fn wrong_directions() {
    assert_eq!(
        diagnosis(|index, ray, hit, random| {
            let refracted = refract(ray.direction, hit.shading_normal, ratio(index, hit.side).recip());
            glass(refracted, share(index, ray, hit), ray, hit, random)
        }),
        "ratio-upside-down"
    );
    assert_eq!(
        diagnosis(|index, ray, hit, random| {
            let refracted = refract(ray.direction, hit.shading_normal, index);
            glass(refracted, share(index, ray, hit), ray, hit, random)
        }),
        "side-ignored"
    );
    assert_eq!(
        diagnosis(|index, ray, hit, random| glass(Some(ray.direction), share(index, ray, hit), ray, hit, random)),
        "not-bent"
    );
    assert_eq!(
        diagnosis(|index, ray, hit, random| {
            let (next, weight) = right(index, ray, hit, random);
            let turned = if is_reflected(&next, hit) { -next.direction } else { next.direction };
            (Ray { direction: turned, ..next }, weight)
        }),
        "reflected-into-the-surface"
    );
    assert_eq!(diagnosis(|_, ray, hit, _| (Ray::new(hit.position, -ray.direction), 1.0)), "turned-back");
    assert_eq!(diagnosis(|_, ray, hit, _| (Ray::new(hit.position, ray.direction * 2.0), 1.0)), "not-a-unit-vector");
    assert_eq!(diagnosis(|_, _, hit, _| (Ray::new(hit.position, Vec3::NAN), 1.0)), "not-a-number");
    assert_eq!(diagnosis(|_, _, hit, _| (Ray::new(hit.position, hit.shading_normal), 1.0)), "wrong-direction");
}

#[test]
fn total_reflection_is_not_lost() {
    // The path ends, ...
    assert_eq!(
        diagnosis(|index, ray, hit, random| {
            let (next, weight) = right(index, ray, hit, random);
            let is_total = refract(ray.direction, hit.shading_normal, ratio(index, hit.side)).is_none();
            (next, if is_total { 0.0 } else { weight })
        }),
        "total-reflection-lost"
    );
    // ... goes straight on, ...
    assert_eq!(
        diagnosis(|index, ray, hit, random| {
            let refracted = refract(ray.direction, hit.shading_normal, ratio(index, hit.side)).or(Some(ray.direction));
            glass(refracted, share(index, ray, hit).min(0.9), ray, hit, random)
        }),
        "total-reflection-lost"
    );
    // ... or is no number.
    assert_eq!(
        diagnosis(|index, ray, hit, random| {
            let (ratio, normal, cosine) = (ratio(index, hit.side), hit.shading_normal, cosine(ray, hit));
            let behind = (1.0 - (1.0 - cosine * cosine) / (ratio * ratio)).sqrt();
            let refracted = ray.direction / ratio + normal * (cosine / ratio - behind);
            glass(Some(refracted), share(index, ray, hit).min(0.9), ray, hit, random)
        }),
        "total-reflection-lost"
    );
}

/// The diagnosis of right directions with such a probability of reflection. A check takes functions that know nothing else.
macro_rules! shares {
    ($probability:expr) => {
        diagnosis(|index, ray, hit, random| {
            let probability: fn(f32, &Ray, &Hit) -> f32 = $probability;
            let refracted = refract(ray.direction, hit.shading_normal, ratio(index, hit.side));
            glass(refracted, probability(index, ray, hit), ray, hit, random)
        })
    };
}

#[test]
fn wrong_shares() {
    assert_eq!(shares!(|index, ray, hit| 1.0 - share(index, ray, hit)), "chances-swapped");
    assert_eq!(shares!(|_, _, _| 0.0), "never-reflected");
    // With a cosine below 0.
    assert_eq!(shares!(|index, ray, hit| exact(-cosine(ray, hit), ratio(index, hit.side), 0.0)), "never-refracted");
    assert_eq!(shares!(|_, _, _| 0.5), "half-and-half");
    assert_eq!(shares!(|index, ray, hit| exact(cosine(ray, hit), index, 0.0)), "fresnel-of-the-other-side");
    assert_eq!(
        shares!(|index, ray, hit| exact(cosine(ray, hit), ratio(index, hit.side).recip(), 0.0)),
        "fresnel-of-the-other-side"
    );
    assert_eq!(
        shares!(|index, ray, hit| approximate(cosine(ray, hit), at_normal_incidence(ratio(index, hit.side), 0.0))),
        "approximation"
    );
    assert_eq!(shares!(|index, ray, hit| 0.7 * share(index, ray, hit)), "wrong-share");
}

/// The diagnosis of the right ray with such a weight, by index, ray, hit, and whether it was reflected.
macro_rules! weighed {
    ($weight:expr) => {
        diagnosis(|index, ray, hit, random| {
            let (next, _) = right(index, ray, hit, random);
            let weight: fn(f32, &Ray, &Hit, bool) -> f32 = $weight;
            (next, weight(index, ray, hit, is_reflected(&next, hit)))
        })
    };
}

fn probability(index: f32, ray: &Ray, hit: &Hit, reflected: bool) -> f32 {
    let share = share(index, ray, hit);
    if reflected { share } else { 1.0 - share }
}

#[test]
fn wrong_weights() {
    assert_eq!(weighed!(probability), "counted-twice");
    assert_eq!(weighed!(|i, r, h, reflected| 1.0 / probability(i, r, h, reflected)), "share-forgotten");
    assert_eq!(
        weighed!(|i, _, h, reflected| if reflected { 1.0 } else { ratio(i, h.side) * ratio(i, h.side) }),
        "index-squared"
    );
    assert_eq!(
        weighed!(|i, _, h, reflected| if reflected { 1.0 } else { (ratio(i, h.side) * ratio(i, h.side)).recip() }),
        "index-squared"
    );
    assert_eq!(weighed!(|_, ray, hit, _| cosine(ray, hit)), "cosine");
    assert_eq!(weighed!(|_, _, _, reflected| f32::from(u8::from(reflected))), "weight-of-zero");
    assert_eq!(weighed!(|_, _, _, _| 0.9), "wrong-weight");
}

/// The diagnosis of the right directions from such an origin.
macro_rules! from {
    ($origin:expr) => {
        diagnosis(|index, ray, hit, random| {
            let (next, weight) = right(index, ray, hit, random);
            let origin: fn(&Ray, &Hit) -> Vec3 = $origin;
            (Ray { origin: origin(&next, hit), ..next }, weight)
        })
    };
}

#[test]
fn wrong_origins() {
    assert_eq!(from!(|_, hit| Offset::Following.origin(hit, hit.geometric_normal)), "refracted-starts-before");
    assert_eq!(from!(|_, hit| Offset::Following.origin(hit, -hit.geometric_normal)), "reflected-starts-behind");
    assert_eq!(from!(|_, hit| hit.position), "no-offset");
    assert_eq!(from!(|next, hit| hit.position + next.direction * 0.1), "starts-far-away");
}
