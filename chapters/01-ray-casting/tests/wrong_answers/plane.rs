//! Wrong planes.

use common::{Interval, Vec3};
use ray_casting::{
    hit::{Hit, Side},
    ray::Ray,
};

use crate::{Answer, checks::plane::check, name};

/// The diagnosis of a plane whose `intersect` is this function of point, normal, ray and range.
fn diagnosis(intersect: fn(Vec3, Vec3, &Ray, Interval) -> Option<Hit>) -> &'static str {
    name(check(|point, normal| Answer(move |ray: &Ray, range| intersect(point, normal, ray, range))))
}

/// The right ray parameter.
fn t(point: Vec3, normal: Vec3, ray: &Ray) -> f32 {
    (point - ray.origin).dot(normal) / ray.direction.dot(normal)
}

fn hit(ray: &Ray, range: Interval, t: f32, outward: Vec3) -> Option<Hit> {
    range.contains(t).then(|| Hit::new(ray, t, outward))
}

#[test]
fn the_right_one_is_accepted() {
    let plane =
        |point, normal| Answer(move |ray: &Ray, range: Interval| hit(ray, range, t(point, normal, ray), normal));
    assert_eq!(check(plane), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(diagnosis(|_, _, _, _| None), "not-started");
}

#[test]
fn points_subtracted_the_wrong_way_round() {
    assert_eq!(diagnosis(|p, n, ray, range| hit(ray, range, -t(p, n, ray), n)), "wrong-sign");
}

#[test]
fn no_range() {
    assert_eq!(diagnosis(|p, n, ray, _| Some(Hit::new(ray, t(p, n, ray), n))), "hits-behind");
    // Only what lies behind the origin is sorted out, not what lies beyond the end.
    assert_eq!(diagnosis(|p, n, ray, _| hit(ray, Interval::POSITIVE, t(p, n, ray), n)), "range-not-open");
    // Zero instead of the range's own beginning.
    assert_eq!(
        diagnosis(|p, n, ray, range| hit(ray, range.intersection(Interval::POSITIVE), t(p, n, ray), n)),
        "only-positive"
    );
}

#[test]
fn ends_of_the_range_included() {
    assert_eq!(
        diagnosis(|p, n, ray, range| {
            let t = t(p, n, ray);
            (range.min <= t && t <= range.max).then(|| Hit::new(ray, t, n))
        }),
        "range-not-open"
    );
}

#[test]
fn point_left_out() {
    assert_eq!(diagnosis(|_, n, ray, range| hit(ray, range, t(Vec3::ZERO, n, ray), n)), "point-ignored");
}

#[test]
fn hit_from_the_front_only() {
    assert_eq!(
        diagnosis(|p, n, ray, range| if ray.direction.dot(n) < 0.0 { hit(ray, range, t(p, n, ray), n) } else { None }),
        "one-sided"
    );
}

#[test]
fn parallel_rays_hit_at_once() {
    assert_eq!(
        diagnosis(|p, n, ray, range| {
            let t = if ray.direction.dot(n) == 0.0 { 1.0 } else { t(p, n, ray) };
            hit(ray, range, t, n)
        }),
        "parallel"
    );
}

#[test]
fn a_fixed_limit_for_parallel() {
    assert_eq!(
        diagnosis(|p, n, ray, range| {
            if ray.direction.dot(n).abs() < 1e-4 { None } else { hit(ray, range, t(p, n, ray), n) }
        }),
        "fixed-epsilon"
    );
}

#[test]
fn direction_made_a_unit_vector() {
    assert_eq!(
        diagnosis(|p, n, ray, range| {
            let unit = Ray::new(ray.origin, ray.direction.normalize());
            hit(&unit, range, t(p, n, &unit), n)
        }),
        "unit-direction"
    );
}

#[test]
fn normal_turned_too_early() {
    assert_eq!(
        diagnosis(|p, n, ray, range| hit(ray, range, t(p, n, ray), if ray.direction.dot(n) > 0.0 { -n } else { n })),
        "wrong-side"
    );
}

#[test]
fn hit_made_by_hand() {
    let by_hand = |p: Vec3, n: Vec3, ray: &Ray, range: Interval, normal: Vec3| {
        let hit = hit(ray, range, t(p, n, ray), n)?;
        Some(Hit { geometric_normal: normal, shading_normal: normal, ..hit })
    };
    let with = |normal: fn(Vec3) -> Vec3| {
        name(check(|p, n| Answer(move |ray: &Ray, range: Interval| by_hand(p, n, ray, range, normal(n)))))
    };
    assert_eq!(with(|n| n.normalize()), "normal-not-turned");
    assert_eq!(with(|n| 2.0 * n), "normal-not-unit");
    assert_eq!(
        diagnosis(|p, n, ray, range| Some(Hit { side: Side::Outside, ..hit(ray, range, t(p, n, ray), n)? })),
        "wrong-side"
    );
    assert_eq!(
        diagnosis(|p, n, ray, range| Some(Hit { position: p, ..hit(ray, range, t(p, n, ray), n)? })),
        "wrong-position"
    );
}
