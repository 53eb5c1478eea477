//! Wrong cylinders, all of one recipe with one ingredient changed.

use common::{Interval, Vec3};
use ray_casting::{hit::Hit, quadratic, ray::Ray};

use crate::{Answer, checks::cylinder::check, name, nearest};

/// Chooses one of several hits, each a ray parameter and an outward normal.
type Choose = fn(&Ray, Interval, Vec<(f32, Vec3)>) -> Option<Hit>;

/// How a cylinder is met. The default is right.
#[derive(Clone, Copy)]
struct Recipe {
    /// Whether the ray is moved by the base.
    is_moved: bool,
    /// Which roots of the tube are tried.
    roots: [bool; 2],
    /// Whether the tube ends.
    is_tube_cut: bool,
    /// Which caps there are: bottom and top.
    caps: [bool; 2],
    /// Whether a point of a cap's plane belongs to the cap.
    is_in_cap: fn(Vec3, f32) -> bool,
    /// The bottom cap's outward normal.
    bottom_normal: Vec3,
    /// The tube's outward normal at a point.
    tube_normal: fn(Vec3) -> Vec3,
    /// Which of the hits is chosen.
    choose: Choose,
}

const RIGHT: Recipe = Recipe {
    is_moved: true,
    roots: [true, true],
    is_tube_cut: true,
    caps: [true, true],
    is_in_cap: |r, radius| r.with_y(0.0).length() <= radius,
    bottom_normal: Vec3::NEG_Y,
    tube_normal: |r| r.with_y(0.0),
    choose: |ray, range, hits| nearest(ray, range, hits),
};

impl Recipe {
    fn intersect(&self, base: Vec3, radius: f32, height: f32, ray: &Ray, range: Interval) -> Option<Hit> {
        let local = Ray::new(if self.is_moved { ray.origin - base } else { ray.origin }, ray.direction);
        let (s, d) = (local.origin.with_y(0.0), local.direction.with_y(0.0));
        let (a, h, c) = (d.dot(d), s.dot(d), s.dot(s) - radius * radius);
        let mut hits = Vec::new();
        for (t, is_tried) in quadratic::solve(a, h, c, h * h - a * c).0.into_iter().zip(self.roots) {
            let r = local.at(t);
            if is_tried && (!self.is_tube_cut || (0.0..=height).contains(&r.y)) {
                hits.push((t, (self.tube_normal)(r)));
            }
        }
        for ((y, outward), is_there) in [(0.0, self.bottom_normal), (height, Vec3::Y)].into_iter().zip(self.caps) {
            let t = (y - local.origin.y) / local.direction.y;
            if is_there && (self.is_in_cap)(local.at(t), radius) {
                hits.push((t, outward));
            }
        }
        (self.choose)(ray, range, hits)
    }

    fn diagnosis(self) -> &'static str {
        name(self.check())
    }

    fn check(self) -> common::exercise::Verdict {
        check(|base, radius, height| Answer(move |ray: &Ray, range| self.intersect(base, radius, height, ray, range)))
    }
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(RIGHT.check(), Ok(()));
}

#[test]
fn parts_left_out() {
    assert_eq!(Recipe { caps: [false, false], roots: [false, false], ..RIGHT }.diagnosis(), "not-started");
    assert_eq!(Recipe { roots: [false, false], ..RIGHT }.diagnosis(), "no-tube");
    assert_eq!(Recipe { caps: [false, false], ..RIGHT }.diagnosis(), "no-top-cap");
    assert_eq!(Recipe { caps: [false, true], ..RIGHT }.diagnosis(), "no-bottom-cap");
}

#[test]
fn parts_too_large() {
    assert_eq!(Recipe { is_tube_cut: false, ..RIGHT }.diagnosis(), "endless-tube");
    assert_eq!(Recipe { is_in_cap: |_, _| true, ..RIGHT }.diagnosis(), "cap-too-wide");
    let square: fn(Vec3, f32) -> bool = |r, radius| r.x.abs() <= radius && r.z.abs() <= radius;
    assert_eq!(Recipe { is_in_cap: square, ..RIGHT }.diagnosis(), "cap-too-wide");
}

#[test]
fn only_one_root() {
    assert_eq!(Recipe { roots: [true, false], ..RIGHT }.diagnosis(), "no-hit-from-inside");
    assert_eq!(Recipe { roots: [false, true], ..RIGHT }.diagnosis(), "not-nearest");
}

#[test]
fn the_nearer_root_is_cut_away_and_the_farther_forgotten() {
    // The first root in the range is chosen, and only then cut.
    let choose = |base: Vec3, radius: f32, height: f32, ray: &Ray, range: Interval| {
        let local = Ray::new(ray.origin - base, ray.direction);
        let (s, d) = (local.origin.with_y(0.0), local.direction.with_y(0.0));
        let (a, h, c) = (d.dot(d), s.dot(d), s.dot(s) - radius * radius);
        let wide = Interval::new(f32::NEG_INFINITY, range.max);
        let first = quadratic::solve(a, h, c, h * h - a * c).first_in(if range.min > 0.5 { wide } else { range });
        let tube = first.map(|t| (t, local.at(t))).filter(|(_, r)| (0.0..=height).contains(&r.y));
        let caps = [(0.0, -Vec3::Y), (height, Vec3::Y)].map(|(y, n)| ((y - local.origin.y) / local.direction.y, n));
        let caps = caps.into_iter().filter(|(t, _)| local.at(*t).with_y(0.0).length() <= radius);
        nearest(ray, range, tube.map(|(t, r)| (t, r.with_y(0.0))).into_iter().chain(caps))
    };
    let verdict =
        check(|base, radius, height| Answer(move |ray: &Ray, range| choose(base, radius, height, ray, range)));
    assert_eq!(name(verdict), "far-root-forgotten");
}

#[test]
fn the_first_part_wins_instead_of_the_nearest() {
    let first: Choose =
        |ray, range, hits| hits.into_iter().find(|(t, _)| range.contains(*t)).map(|(t, n)| Hit::new(ray, t, n));
    assert_eq!(Recipe { choose: first, ..RIGHT }.diagnosis(), "not-nearest");
}

#[test]
fn wrong_normals() {
    assert_eq!(Recipe { bottom_normal: Vec3::Y, ..RIGHT }.diagnosis(), "wrong-side");
    assert_eq!(Recipe { tube_normal: |r| -r.with_y(0.0), ..RIGHT }.diagnosis(), "wrong-side");
    // From the middle of the base, as if it were a sphere.
    assert_eq!(Recipe { tube_normal: |r| r, ..RIGHT }.diagnosis(), "wrong-normal");
}

#[test]
fn base_or_range_left_out() {
    assert_eq!(Recipe { is_moved: false, ..RIGHT }.diagnosis(), "base-ignored");
    let ignoring: Choose = |ray, _, hits| nearest(ray, Interval::POSITIVE, hits);
    assert_eq!(Recipe { choose: ignoring, ..RIGHT }.diagnosis(), "far-root-forgotten");
}
