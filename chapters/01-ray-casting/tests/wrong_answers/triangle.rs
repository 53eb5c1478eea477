//! Wrong triangles, all of one recipe with one ingredient changed.

use common::{Interval, Vec3, exercise::Verdict};
use ray_casting::{
    ray::Ray,
    triangle::{Triangle, TriangleHit},
};

use crate::{checks::triangle::check, name};

/// How a triangle is met. The default is right.
#[derive(Clone, Copy)]
struct Recipe {
    /// What is done to the direction first.
    direction: fn(Vec3) -> Vec3,
    /// Whether the determinant is accepted.
    is_sound: fn(f32) -> bool,
    /// Whether u and v are accepted.
    is_inside: fn(f32, f32) -> bool,
    /// The weights by u and v.
    weights: fn(f32, f32) -> [f32; 3],
    /// Whether t is accepted.
    is_in: fn(Interval, f32) -> bool,
}

const RIGHT: Recipe = Recipe {
    direction: |d| d,
    is_sound: |determinant| determinant != 0.0,
    is_inside: |u, v| u >= 0.0 && v >= 0.0 && u + v <= 1.0,
    weights: |u, v| [1.0 - u - v, u, v],
    is_in: |range, t| range.contains(t),
};

impl Recipe {
    fn intersect(&self, triangle: &Triangle, ray: &Ray, range: Interval) -> Option<TriangleHit> {
        let [r1, r2, r3] = triangle.corners;
        let (e1, e2, d) = (r2 - r1, r3 - r1, (self.direction)(ray.direction));
        let p = d.cross(e2);
        let determinant = p.dot(e1);
        let f = ray.origin - r1;
        let q = f.cross(e1);
        let [u, v, t] = [p.dot(f), q.dot(d), q.dot(e2)].map(|x| x / determinant);
        let is_hit = (self.is_sound)(determinant) && (self.is_inside)(u, v) && (self.is_in)(range, t);
        is_hit.then(|| TriangleHit { t, weights: (self.weights)(u, v) })
    }

    fn check(self) -> Verdict {
        check(|triangle, ray, range| self.intersect(triangle, ray, range))
    }

    fn diagnosis(self) -> &'static str {
        name(self.check())
    }
}

#[test]
fn right_ones_are_accepted() {
    assert_eq!(RIGHT.check(), Ok(()));
    // The chapter's own ways are right answers too, as far as they give weights.
    let watertight = |triangle: &Triangle, ray: &Ray, range| {
        triangle.hit_by_barycentric(&ray_casting::triangle_barycentric::Shear::along(ray), range)
    };
    assert_eq!(check(watertight), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(Recipe { is_sound: |_| false, ..RIGHT }.diagnosis(), "not-started");
}

#[test]
fn wrong_determinants() {
    // The published program has this as a choice, for meshes that are closed.
    assert_eq!(Recipe { is_sound: |determinant| determinant > 0.0, ..RIGHT }.diagnosis(), "one-sided");
    assert_eq!(Recipe { is_sound: |determinant| determinant < 0.0, ..RIGHT }.diagnosis(), "one-sided");
    assert_eq!(Recipe { is_sound: |determinant| determinant.abs() > 1e-6, ..RIGHT }.diagnosis(), "fixed-epsilon");
}

#[test]
fn edges_left_out() {
    for is_inside in [
        (|_, v| v >= 0.0) as fn(f32, f32) -> bool,
        |u, _| u >= 0.0,
        |u, v| u >= 0.0 && v >= 0.0,
        |u, v| (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v),
    ] {
        assert_eq!(Recipe { is_inside, ..RIGHT }.diagnosis(), "edge-forgotten");
    }
}

#[test]
fn wrong_weights() {
    assert_eq!(Recipe { weights: |u, v| [u, v, 1.0 - u - v], ..RIGHT }.diagnosis(), "weights-order");
    assert_eq!(Recipe { weights: |u, v| [1.0 - u - v, v, u], ..RIGHT }.diagnosis(), "weights-order");
    assert_eq!(Recipe { weights: |u, v| [1.0, u, v], ..RIGHT }.diagnosis(), "weights-sum");
    assert_eq!(Recipe { weights: |_, _| [1.0 / 3.0; 3], ..RIGHT }.diagnosis(), "wrong-weights");
}

#[test]
fn wrong_ranges() {
    assert_eq!(Recipe { is_in: |_, _| true, ..RIGHT }.diagnosis(), "ignores-range");
    assert_eq!(Recipe { is_in: |range, t| range.min <= t && t <= range.max, ..RIGHT }.diagnosis(), "ignores-range");
    assert_eq!(Recipe { direction: |d| d.normalize(), ..RIGHT }.diagnosis(), "unit-direction");
}

#[test]
fn parallel_rays() {
    // Without asking for the determinant, infinite numbers and NaN must not be taken for a hit.
    let careless = Recipe { is_sound: |_| true, is_inside: |u, v| !(u < 0.0 || v < 0.0 || u + v > 1.0), ..RIGHT };
    let loose = Recipe { is_in: |range, t| !(t <= range.min || t >= range.max), ..careless };
    assert_eq!(loose.diagnosis(), "ignores-range");
}
