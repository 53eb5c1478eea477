//! Wrong occlusion queries for a ball.

use common::{Interval, Vec3, exercise::Verdict};
use ray_casting::{
    hit::Hit,
    ray::Ray,
    shape::Shape,
    sphere::{Sphere, TextbookSphere},
};

use crate::{checks::any_hit::check, name};

/// How a ball answers shadow rays.
type Query = fn(&Sphere, &Ray, Interval) -> bool;

struct Ball(Sphere, Query);

impl Shape for Ball {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        self.0.intersect(ray, range)
    }

    fn occluded(&self, ray: &Ray, range: Interval) -> bool {
        self.1(&self.0, ray, range)
    }
}

fn verdict(query: Query) -> Verdict {
    check(move |center, radius| Ball(Sphere { center, radius }, query))
}

fn diagnosis(query: Query) -> &'static str {
    name(verdict(query))
}

fn is_inside(ball: &Sphere, point: Vec3) -> bool {
    point.distance_squared(ball.center) < ball.radius * ball.radius
}

/// Where the ray is nearest to the center.
fn nearest(ball: &Sphere, ray: &Ray) -> f32 {
    (ball.center - ray.origin).dot(ray.direction) / ray.direction.length_squared()
}

/// The right answer, but for what a closure does not ask.
fn by_ends(ball: &Sphere, ray: &Ray, range: Interval) -> bool {
    let [begin, end] = [range.min, range.max].map(|t| is_inside(ball, ray.at(t)));
    let t = nearest(ball, ray);
    begin != end || !begin && range.contains(t) && is_inside(ball, ray.at(t))
}

#[test]
fn right_ones_are_accepted() {
    assert_eq!(verdict(|ball, ray, range| !range.is_empty() && by_ends(ball, ray, range)), Ok(()));
    assert_eq!(verdict(|ball, ray, range| ball.intersect(ray, range).is_some()), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(diagnosis(|_, _, _| false), "not-started");
}

#[test]
fn small_differences_of_great_numbers() {
    assert_eq!(diagnosis(|ball, ray, range| TextbookSphere(*ball).intersect(ray, range).is_some()), "far-ball");
    // The same for both ends outside only.
    let discriminant: Query = |ball, ray, range| {
        let [begin, end] = [range.min, range.max].map(|t| is_inside(ball, ray.at(t)));
        let to_center = ball.center - ray.origin;
        let (a, h) = (ray.direction.length_squared(), to_center.dot(ray.direction));
        let c = to_center.length_squared() - ball.radius * ball.radius;
        !range.is_empty() && (begin != end || !begin && range.contains(h / a) && h * h - a * c > 0.0)
    };
    assert_eq!(diagnosis(discriminant), "far-ball");
}

#[test]
fn only_empty_ranges() {
    // A `!` too many: that is no stub.
    assert_eq!(diagnosis(|ball, ray, range| range.is_empty() && by_ends(ball, ray, range)), "missed");
}

#[test]
fn everything() {
    assert_eq!(diagnosis(|_, _, _| true), "hit-beside");
}

#[test]
fn ranges_that_are_not_asked_for() {
    // The line of the ray.
    assert_eq!(diagnosis(|ball, ray, _| is_inside(ball, ray.at(nearest(ball, ray)))), "beyond-the-light");
    // Any hit in front.
    assert_eq!(diagnosis(|ball, ray, _| ball.intersect(ray, Interval::POSITIVE).is_some()), "beyond-the-light");
    // Any hit before the end.
    let no_begin: Query = |ball, ray, range| ball.intersect(ray, Interval::new(-1e9, range.max)).is_some();
    assert_eq!(diagnosis(no_begin), "ball-behind");
    let from_zero: Query = |ball, ray, range| ball.intersect(ray, Interval::POSITIVE.up_to(range.max)).is_some();
    assert_eq!(diagnosis(from_zero), "range-min-ignored");
    // The way as if it began at the origin.
    let from_origin: Query = |ball, ray, range| {
        let [begin, end] = [0.0, range.max].map(|t| is_inside(ball, ray.at(t)));
        let t = nearest(ball, ray);
        !range.is_empty() && (begin != end || !begin && range.contains(t) && is_inside(ball, ray.at(t)))
    };
    assert_eq!(diagnosis(from_origin), "range-min-ignored");
    // Never anything before the origin.
    let positive: Query = |ball, ray, range| ball.intersect(ray, range.intersection(Interval::POSITIVE)).is_some();
    assert_eq!(diagnosis(positive), "only-positive");
    // An end that comes first.
    assert_eq!(diagnosis(by_ends), "empty-range");
}

#[test]
fn ends_inside_and_outside() {
    // Only when the nearest point lies between.
    let both_outside: Query =
        |ball, ray, range| range.contains(nearest(ball, ray)) && is_inside(ball, ray.at(nearest(ball, ray)));
    assert_eq!(diagnosis(both_outside), "begins-inside");
    // The nearest point of the way: a solid ball.
    let solid: Query = |ball, ray, range| {
        let t = nearest(ball, ray).clamp(range.min, range.max);
        is_inside(ball, ray.at(t))
    };
    assert_eq!(diagnosis(solid), "solid-ball");
    // The first root only.
    let first: Query = |ball, ray, range| range.contains(ball.roots(ray).0[0]);
    assert_eq!(diagnosis(first), "begins-inside");
    // Both roots, as if the way had to go in and come out.
    let both: Query = |ball, ray, range| ball.roots(ray).0.iter().all(|t| range.contains(*t));
    assert_eq!(diagnosis(both), "begins-inside");
    // The middle of the range in place of the nearest point.
    let middle: Query = |ball, ray, range| {
        let [begin, end] = [range.min, range.max].map(|t| is_inside(ball, ray.at(t)));
        begin != end || !begin && is_inside(ball, ray.at((range.min + range.max) / 2.0))
    };
    let message = verdict(middle).unwrap_err();
    assert_eq!(message.name, "missed");
    assert!(message.to_string().contains("at t = 3,"), "{message}");
    // The end is never asked about.
    let no_end: Query = |ball, ray, range| {
        let t = nearest(ball, ray);
        is_inside(ball, ray.at(range.min)) || range.contains(t) && is_inside(ball, ray.at(t))
    };
    assert_eq!(diagnosis(no_end), "ends-inside");
}

#[test]
fn infinity() {
    // Asked the other way round, a NaN counts as inside.
    let nan_inside: Query = |ball, ray, range| {
        let is_outside = |t: f32| ray.at(t).distance_squared(ball.center) >= ball.radius * ball.radius;
        let t = nearest(ball, ray);
        is_outside(range.min) != is_outside(range.max) || is_outside(range.min) && range.contains(t) && !is_outside(t)
    };
    assert_eq!(diagnosis(nan_inside), "infinite-end");
}

#[test]
fn lengths_places_and_sizes() {
    let no_division: Query = |ball, ray, range| {
        let [begin, end] = [range.min, range.max].map(|t| is_inside(ball, ray.at(t)));
        let t = (ball.center - ray.origin).dot(ray.direction);
        begin != end || !begin && range.contains(t) && is_inside(ball, ray.at(t))
    };
    assert_eq!(diagnosis(no_division), "unit-direction");
    let normalized: Query = |ball, ray, range| by_ends(ball, &Ray::new(ray.origin, ray.direction.normalize()), range);
    assert_eq!(diagnosis(normalized), "normalized");
    let at_origin: Query = |ball, ray, range| by_ends(&Sphere { center: Vec3::ZERO, ..*ball }, ray, range);
    assert_eq!(diagnosis(at_origin), "center-ignored");
    let unit: Query = |ball, ray, range| by_ends(&Sphere { radius: 1.0, ..*ball }, ray, range);
    assert_eq!(diagnosis(unit), "wrong-radius");
    let not_squared: Query = |ball, ray, range| by_ends(&Sphere { radius: ball.radius.sqrt(), ..*ball }, ray, range);
    assert_eq!(diagnosis(not_squared), "wrong-radius");
    let shrunk: Query = |ball, ray, range| by_ends(&Sphere { radius: ball.radius - 1e-3, ..*ball }, ray, range);
    assert_eq!(diagnosis(shrunk), "fixed-epsilon");
    let late: Query = |ball, ray, range| by_ends(ball, ray, Interval { min: range.min + 2e-3, ..range });
    assert_eq!(diagnosis(late), "fixed-epsilon");
}
