//! Wrong bounding spheres.

use common::{Interval, Vec3, exercise::Verdict};
use ray_casting::{aabb::Aabb, ray::Ray};

use crate::{
    checks::bounding_sphere::{Ball, check},
    name,
};

type Around = fn(&[Vec3]) -> Ball;
type MayHit = fn(&Ball, &Ray, Interval) -> bool;

fn farthest(points: &[Vec3], center: Vec3) -> f32 {
    points.iter().map(|point| point.distance(center)).fold(0.0, f32::max)
}

fn the_box(points: &[Vec3]) -> Aabb {
    Aabb::around(points).expect("points")
}

const AROUND: Around = |points| {
    let center = the_box(points).center();
    Ball { center, radius: farthest(points, center) * 1.001 }
};

fn nearest(ball: &Ball, ray: &Ray) -> f32 {
    (ball.center - ray.origin).dot(ray.direction) / ray.direction.length_squared()
}

fn is_inside(ball: &Ball, point: Vec3) -> bool {
    point.distance_squared(ball.center) <= ball.radius * ball.radius
}

const MAY_HIT: MayHit = |ball, ray, range| is_inside(ball, ray.at(nearest(ball, ray).clamp(range.min, range.max)));

fn by_around(around: Around) -> &'static str {
    name(check(around, MAY_HIT))
}

fn by_query(may_hit: MayHit) -> &'static str {
    name(check(AROUND, may_hit))
}

#[test]
fn right_ones_are_accepted() {
    let verdict: Verdict = check(AROUND, MAY_HIT);
    assert_eq!(verdict, Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(name(check(|_| Ball { center: Vec3::ZERO, radius: 0.0 }, |_, _, _| true)), "not-started");
    // One of the two functions is there: that is a start.
    assert_eq!(by_query(|_, _, _| true), "hit-beside");
    assert_eq!(by_around(|_| Ball { center: Vec3::ZERO, radius: 0.0 }), "point-outside");
}

#[test]
fn wrong_balls() {
    assert_eq!(by_around(|_| Ball { center: Vec3::ZERO, radius: f32::INFINITY }), "not-a-number");
    let by_longest_side: Around = |points| {
        let Aabb { min, max } = the_box(points);
        Ball { center: (min + max) / 2.0, radius: (max - min).max_element() / 2.0 * 1.001 }
    };
    assert_eq!(by_around(by_longest_side), "point-outside");
    let around_the_box: Around =
        |points| Ball { center: the_box(points).center(), radius: the_box(points).diagonal() / 2.0 * 1.001 };
    assert_eq!(by_around(around_the_box), "around-the-box");
    let around_mean: Around = |points| {
        let center = points.iter().sum::<Vec3>() / points.len() as f32;
        Ball { center, radius: farthest(points, center) * 1.001 }
    };
    assert_eq!(by_around(around_mean), "mean-center");
    let no_room: Around = |points| {
        let center = the_box(points).center();
        Ball { center, radius: farthest(points, center) }
    };
    assert_eq!(by_around(no_room), "no-room");
    assert_eq!(by_around(|points| Ball { radius: AROUND(points).radius * 2.0, ..AROUND(points) }), "too-large");
    let from_first: Around = |points| Ball { center: points[0], radius: farthest(points, points[0]) * 1.001 };
    assert_eq!(by_around(from_first), "too-large");
}

#[test]
fn wrong_queries() {
    assert_eq!(by_query(|_, _, _| false), "missed");
    assert_eq!(by_query(|ball, ray, _| is_inside(ball, ray.at(nearest(ball, ray)))), "beyond-the-end");
    let in_front: MayHit = |ball, ray, range| {
        let t = nearest(ball, ray);
        range.contains(t) && is_inside(ball, ray.at(t))
    };
    assert_eq!(by_query(in_front), "hollow-ball");
    let ends_or_between: MayHit = |ball, ray, range| {
        let t = nearest(ball, ray);
        let [begin, end] = [range.min, range.max].map(|t| is_inside(ball, ray.at(t)));
        begin != end || !begin && range.contains(t) && is_inside(ball, ray.at(t))
    };
    assert_eq!(by_query(ends_or_between), "hollow-ball");
    let positive: MayHit = |ball, ray, range| {
        let t = nearest(ball, ray).clamp(range.min.max(0.0), range.max);
        is_inside(ball, ray.at(t))
    };
    assert_eq!(by_query(positive), "only-positive");
    let up_to_the_end: MayHit = |ball, ray, range| is_inside(ball, ray.at(nearest(ball, ray).min(range.max)));
    assert_eq!(by_query(up_to_the_end), "before-the-begin");
    let from_the_begin: MayHit = |ball, ray, range| is_inside(ball, ray.at(nearest(ball, ray).max(range.min)));
    assert_eq!(by_query(from_the_begin), "beyond-the-end");
}

#[test]
fn lengths_places_and_sizes() {
    let no_division: MayHit = |ball, ray, range| {
        let t = (ball.center - ray.origin).dot(ray.direction);
        is_inside(ball, ray.at(t.clamp(range.min, range.max)))
    };
    assert_eq!(by_query(no_division), "unit-direction");
    let normalized: MayHit = |ball, ray, range| MAY_HIT(ball, &Ray::new(ray.origin, ray.direction.normalize()), range);
    assert_eq!(by_query(normalized), "unit-direction");
    assert_eq!(
        by_query(|ball, ray, range| MAY_HIT(&Ball { center: Vec3::ZERO, ..*ball }, ray, range)),
        "center-or-radius"
    );
    let not_squared: MayHit = |ball, ray, range| MAY_HIT(&Ball { radius: ball.radius.sqrt(), ..*ball }, ray, range);
    assert_eq!(by_query(not_squared), "center-or-radius");
    // The discriminant of chapter 1's quadratic formula.
    let discriminant: MayHit = |ball, ray, range| {
        let to_center = ball.center - ray.origin;
        let (a, h) = (ray.direction.length_squared(), to_center.dot(ray.direction));
        let c = to_center.length_squared() - ball.radius * ball.radius;
        let root = (h * h - a * c).sqrt();
        let [enter, leave] = [(h - root) / a, (h + root) / a];
        h * h - a * c >= 0.0 && enter < range.max && leave > range.min
    };
    assert_eq!(by_query(discriminant), "far-ball");
}
