//! Wrong tori, all of one recipe with one ingredient changed.
//!
//! The roots are found by walking along the ray, which is slow, but another way than the solution's.

use common::{Interval, Vec3, exercise::Verdict};
use ray_casting::{hit::Hit, ray::Ray};

use crate::{Answer, checks::torus::check, name};

/// How a torus is met. The default is right.
#[derive(Clone, Copy)]
struct Recipe {
    /// Whether the ray is moved by the center.
    is_moved: bool,
    /// Whether t counts lengths of the direction, rather than scene units.
    is_scaled: bool,
    /// Which of the roots in the range is the answer.
    choose: fn(Vec<f32>, Interval) -> Option<f32>,
    /// The outward normal by point and major radius.
    normal: fn(Vec3, f32) -> Vec3,
    /// Negative inside, by point and both radii.
    value: fn(Vec3, f32, f32) -> f32,
}

const RIGHT: Recipe = Recipe {
    is_moved: true,
    is_scaled: true,
    choose: |roots, range| roots.into_iter().find(|t| range.contains(*t)),
    normal: |p, major| p - p.with_y(0.0).normalize() * major,
    value: |p, major, minor| {
        let across = p.with_y(0.0).length() - major;
        across * across + p.y * p.y - minor * minor
    },
};

impl Recipe {
    fn intersect(&self, center: Vec3, major: f32, minor: f32, ray: &Ray, range: Interval) -> Option<Hit> {
        let origin = if self.is_moved { ray.origin - center } else { ray.origin };
        let length = ray.direction.length();
        let d = ray.direction / length;
        let shift = -origin.dot(d);
        let s = origin + d * shift;
        let bound = 1.01 * (major + minor);
        let half = (bound * bound - s.dot(s)).sqrt();
        if half.is_nan() {
            return None;
        }
        let roots = roots_between(-half, half, |u| (self.value)(s + d * u, major, minor));
        let to_t = |u: f32| (u + shift) / if self.is_scaled { length } else { 1.0 };
        let roots = roots.into_iter().map(to_t).collect();
        let t = (self.choose)(roots, range)?;
        let p = origin + d * t * if self.is_scaled { length } else { 1.0 };
        Some(Hit::new(ray, t, (self.normal)(p, major)))
    }

    fn check(self) -> Verdict {
        check(|center, major, minor| Answer(move |ray: &Ray, range| self.intersect(center, major, minor, ray, range)))
    }

    fn diagnosis(self) -> &'static str {
        name(self.check())
    }
}

/// The places at which a function changes its sign, looked for in 600 steps.
fn roots_between(from: f32, to: f32, value: impl Fn(f32) -> f32) -> Vec<f32> {
    let at = |step: u16| from + (to - from) * f32::from(step) / 600.0;
    let mut roots = Vec::new();
    for step in 0..600 {
        let (mut low, mut high) = (at(step), at(step + 1));
        let is_negative = value(low) < 0.0;
        if is_negative != (value(high) < 0.0) {
            for _ in 0..24 {
                let middle = (low + high) / 2.0;
                if (value(middle) < 0.0) == is_negative { low = middle } else { high = middle }
            }
            roots.push(low);
        }
    }
    roots
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(RIGHT.check(), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(Recipe { choose: |_, _| None, ..RIGHT }.diagnosis(), "not-started");
}

#[test]
fn wrong_roots() {
    let choose = |choose| Recipe { choose, ..RIGHT }.diagnosis();
    assert_eq!(choose(|roots, range| roots.into_iter().rev().find(|t| range.contains(*t))), "not-nearest");
    // Whether the first root lies in the range decides.
    assert_eq!(choose(|roots, range| roots.first().copied().filter(|t| range.contains(*t))), "root-lost");
    // A fourth-degree equation with only two roots looked for.
    assert_eq!(choose(|roots, range| roots.into_iter().take(2).find(|t| range.contains(*t))), "root-lost");
    assert_eq!(choose(|roots, _| roots.into_iter().find(|t| *t > 0.0)), "root-lost");
    assert_eq!(choose(|roots, range| roots.into_iter().find(|t| *t > 0.0 && range.contains(*t))), "only-positive");
}

#[test]
fn wrong_surfaces() {
    assert_eq!(Recipe { normal: |p, _| p, ..RIGHT }.diagnosis(), "wrong-normal");
    assert_eq!(Recipe { normal: |p, major| p.with_y(0.0).normalize() * major - p, ..RIGHT }.diagnosis(), "wrong-side");
    assert_eq!(Recipe { normal: |p, major| p - p.normalize() * major, ..RIGHT }.diagnosis(), "wrong-normal");
    // The ball around the torus.
    let ball: fn(Vec3, f32, f32) -> f32 = |p, major, minor| p.length() - major - minor;
    assert_eq!(Recipe { value: ball, ..RIGHT }.diagnosis(), "wrong-first-hit");
    // The convex hull of the ring's middle: no hole.
    let disc: fn(Vec3, f32, f32) -> f32 = |p, major, minor| {
        let across = (p.with_y(0.0).length() - major).max(0.0);
        across * across + p.y * p.y - minor * minor
    };
    assert_eq!(Recipe { value: disc, ..RIGHT }.diagnosis(), "hole-filled");
    // Standing instead of lying.
    let standing: fn(Vec3, f32, f32) -> f32 = |p, major, minor| {
        let across = p.with_z(0.0).length() - major;
        across * across + p.z * p.z - minor * minor
    };
    assert_eq!(Recipe { value: standing, ..RIGHT }.diagnosis(), "wrong-first-hit");
}

#[test]
fn wrong_places() {
    assert_eq!(Recipe { is_moved: false, ..RIGHT }.diagnosis(), "center-ignored");
    assert_eq!(Recipe { is_scaled: false, ..RIGHT }.diagnosis(), "unit-direction");
}

#[test]
fn the_origin_left_where_it_is() {
    // The quartic as it follows from the definition, in f32, and the ray as it comes. Near the torus this is good enough;
    // from far away the coefficients cancel.
    let naive = |center: Vec3, major: f32, minor: f32, ray: &Ray, range: Interval| {
        let (o, d) = (ray.origin - center, ray.direction);
        let (dd, od, k) = (d.dot(d), o.dot(d), o.dot(o) + major * major - minor * minor);
        let (o2, d2, four) = (o.with_y(0.0), d.with_y(0.0), 4.0 * major * major);
        let coefficients = [
            dd * dd,
            4.0 * dd * od,
            2.0 * dd * k + 4.0 * od * od - four * d2.dot(d2),
            4.0 * od * k - 2.0 * four * o2.dot(d2),
            k * k - four * o2.dot(o2),
        ];
        let (nearest, reach) = (-od / dd, 1.01 * (major + minor) / dd.sqrt());
        let value = |t: f32| coefficients.into_iter().fold(0.0, |sum, c| sum * t + c);
        let t = roots_between(nearest - reach, nearest + reach, value).into_iter().find(|t| range.contains(*t))?;
        Some(Hit::new(ray, t, (RIGHT.normal)(ray.at(t) - center, major)))
    };
    let verdict = check(|center, major, minor| Answer(move |ray: &Ray, range| naive(center, major, minor, ray, range)));
    assert_eq!(name(verdict), "far-away");
}
