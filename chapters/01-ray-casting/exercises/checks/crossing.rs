//! What is right: where the line of a ray crosses a surface, computed in f64.

use common::Interval;
use glam::DVec3;
use ray_casting::{
    hit::{Hit, Side},
    ray::Ray,
};

/// One place where the line of a ray crosses a surface, before or behind its origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossing {
    /// Ray parameter.
    pub(crate) t: f64,
    /// Outward unit normal.
    pub(crate) outward: DVec3,
    /// Which part of the surface it is.
    pub(crate) part: &'static str,
}

impl Crossing {
    /// Cosine of the angle between the ray and the normal; positive where the ray leaves.
    pub(crate) fn cosine(&self, ray: &Ray) -> f64 {
        self.outward.dot(ray.direction.as_dvec3().normalize())
    }

    /// The side that the ray meets.
    pub(crate) fn side(&self, ray: &Ray) -> Side {
        if self.cosine(ray) > 0.0 { Side::Inside } else { Side::Outside }
    }

    /// The normal that faces the ray.
    pub(crate) fn normal(&self, ray: &Ray) -> DVec3 {
        if self.cosine(ray) > 0.0 { -self.outward } else { self.outward }
    }
}

/// A surface whose crossings are known.
pub(crate) trait Reference {
    /// All crossings in ascending order; `None` if a rounding error could change their number, so that the ray is no
    /// fair question.
    fn crossings(&self, ray: &Ray) -> Option<Vec<Crossing>>;

    /// Its name with its numbers.
    fn words(&self) -> String;

    /// What the outward normal does, to complete a sentence.
    fn outward_normal(&self) -> &'static str;
}

/// A line through f64 space, with the parameter of the ray.
pub(crate) fn line(ray: &Ray) -> (DVec3, DVec3) {
    (ray.origin.as_dvec3(), ray.direction.as_dvec3())
}

/// Ranges worth asking for: all before the origin, all on both sides of it, what lies behind each crossing, and what
/// lies before the first. No crossing lies near an end.
pub(crate) fn ranges(crossings: &[Crossing]) -> Vec<Interval> {
    const FAR: f32 = 1e5;
    let mut ranges = vec![Interval::POSITIVE, Interval::new(-FAR, FAR)];
    for (i, crossing) in crossings.iter().enumerate() {
        let next = crossings.get(i + 1).map_or(crossing.t + 2.0, |next| next.t);
        #[expect(clippy::cast_possible_truncation, reason = "any number between two crossings will do")]
        let between = ((crossing.t + next) / 2.0) as f32;
        ranges.push(Interval::new(between, FAR));
        ranges.push(Interval::new(-FAR, between));
    }
    if let Some(first) = crossings.iter().find(|c| c.t > 0.0) {
        #[expect(clippy::cast_possible_truncation, reason = "any number before the crossing will do")]
        ranges.push(Interval::new(0.0, (first.t * 0.9) as f32));
    }
    let is_clear = |end: f32| crossings.iter().all(|c| (c.t - f64::from(end)).abs() > 1e-3 * (1.0 + c.t.abs()));
    ranges.retain(|range| is_clear(range.min) && is_clear(range.max) && !range.is_empty());
    ranges
}

/// The first crossing in an open range: what an answer should find.
pub(crate) fn first_in(crossings: &[Crossing], range: Interval) -> Option<Crossing> {
    let (min, max) = (f64::from(range.min), f64::from(range.max));
    crossings.iter().copied().find(|c| min < c.t && c.t < max)
}

/// Whether the answer is this crossing, as far as `t` goes, within `slack` scene units.
pub(crate) fn is_at(hit: &Hit, crossing: &Crossing, ray: &Ray, slack: f64) -> bool {
    let length = ray.direction.as_dvec3().length();
    (f64::from(hit.t) - crossing.t).abs() * length <= slack
}
