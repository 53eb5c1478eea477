//! Compares what a shape answers with what is right, and names the likely mistake.

use common::{
    Interval,
    exercise::{Diagnosis, Finding, Verdict},
};
use ray_casting::{hit::Hit, ray::Ray, shape::Shape};

use super::{
    crossing::{Crossing, Reference, first_in, is_at, ranges},
    words,
};

/// A question put to a shape.
struct Question<'a> {
    /// The shape with its numbers.
    target: &'a str,
    /// The ray.
    ray: &'a Ray,
    /// The ray parameters that count.
    range: Interval,
}

impl Question<'_> {
    /// The question in words.
    fn words(&self) -> String {
        let Self { target, ray, range } = self;
        format!("{}, {}, at {target}", words::ray(ray), words::range(*range))
    }

    /// A named mistake.
    fn mistake(&self, name: &'static str, got: String, expected: String, advice: &str) -> Diagnosis {
        Finding { tried: self.words(), got, expected, advice: advice.into() }.named(name)
    }
}

/// How far an answer may be off, in scene units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slack {
    /// Along the ray.
    pub(crate) t: f64,
    /// Across the unit normal.
    pub(crate) normal: f64,
}

/// A surface under test: the student's, what it should be, and how far they may differ.
pub(crate) struct Trial<S, R> {
    /// The answer.
    pub(crate) shape: S,
    /// What is right.
    pub(crate) ideal: R,
    /// How much the answer may be off.
    pub(crate) slack: Slack,
}

impl<S: Shape, R: Reference> Trial<S, R> {
    /// Ask about one ray and one range.
    pub(crate) fn ask(&self, ray: &Ray, range: Interval) -> Verdict {
        let crossings = self.ideal.crossings(ray).unwrap_or_default();
        let question = Question { target: &self.ideal.words(), ray, range };
        judge(&question, &crossings, self.shape.intersect(ray, range), self.slack)
    }

    /// Ask for one particular mistake: whatever is wrong with the answer, this is its name and where to look.
    pub(crate) fn probe(&self, ray: &Ray, range: Interval, name: &'static str, advice: &str) -> Verdict {
        self.ask(ray, range).map_err(|_| {
            let crossings = self.ideal.crossings(ray).unwrap_or_default();
            let got = words::answer(self.shape.intersect(ray, range));
            let expected = words::crossing(first_in(&crossings, range), ray);
            Question { target: &self.ideal.words(), ray, range }.mistake(name, got, expected, advice)
        })
    }

    /// Ask about one ray with all ranges that are worth it. A ray that is no fair question is passed over.
    pub(crate) fn compare(&self, ray: &Ray) -> Verdict {
        let Some(crossings) = self.ideal.crossings(ray) else { return Ok(()) };
        ranges(&crossings).into_iter().try_for_each(|range| self.ask(ray, range))
    }

    /// Whether none of these rays hits the answer, whatever lies in front of the rays.
    pub(crate) fn is_never_hit(&self, rays: &[Ray]) -> bool {
        rays.iter().all(|ray| self.shape.intersect(ray, Interval::POSITIVE).is_none())
    }
}

/// Accept the answer to a question, or name the mistake. `crossings` are all there are, inside and outside the range.
fn judge(question: &Question, crossings: &[Crossing], answer: Option<Hit>, slack: Slack) -> Verdict {
    let (ray, range) = (question.ray, question.range);
    let expected = first_in(crossings, range);
    let mistake = |name, advice: &str| {
        Err(question.mistake(name, words::answer(answer), words::crossing(expected, ray), advice))
    };

    // Is there a hit where one should be?
    let Some(hit) = answer else {
        return match expected {
            None => Ok(()),
            Some(c) if c.t < 0.0 => mistake(
                "only-positive",
                "This range begins before the ray's origin. The range says what counts, not `t > 0`.",
            ),
            Some(c) if crossings.iter().any(|other| other.t < c.t) => mistake(
                "later-hit-forgotten",
                "The ray meets the shape before this range begins, and once more inside the range. When a hit does not \
                 count, go on with the next one instead of giving up.",
            ),
            Some(_) => mistake("missed", "The shape was missed. Work out by hand what your formula gives for this ray."),
        };
    };
    if !hit.t.is_finite() {
        return mistake("not-a-number", "`t` must be a number: is something divided by zero?");
    }
    if !range.contains(hit.t) {
        return mistake("ignores-range", "This `t` lies outside the range. `range.contains(t)` tells which hits count.");
    }
    let Some(expected) = expected else {
        return mistake("hit-beside", "There is nothing at that place: the ray passes by.");
    };

    // Is it the right hit?
    if !is_at(&hit, &expected, ray, slack.t) {
        let length = f64::from(ray.direction.length());
        let is_scaled = [length, 1.0 / length].iter().any(|by| (f64::from(hit.t) * by - expected.t).abs() <= slack.t);
        return if crossings.iter().any(|c| is_at(&hit, c, ray, slack.t)) {
            mistake("not-nearest", "This is a hit, but another one is nearer. Of all hits in the range the least `t` wins.")
        } else if is_scaled {
            mistake(
                "unit-direction",
                "`t` counts lengths of the ray's direction, and this direction is not of unit length. Do not normalise \
                 it, or divide by its length again in the end.",
            )
        } else {
            mistake("wrong-t", "`t` is wrong. Work out by hand what your formula gives for this ray.")
        };
    }
    judge_surface(&hit, &expected, ray, slack).or_else(|(name, advice)| mistake(name, advice))
}

/// Accept position, normals and side, or say what is wrong.
fn judge_surface(hit: &Hit, expected: &Crossing, ray: &Ray, slack: Slack) -> Result<(), (&'static str, &'static str)> {
    // Written so that a position that is no number is wrong.
    let is_position_right = hit.position.as_dvec3().distance(ray.at(hit.t).as_dvec3()) <= slack.t;
    if !is_position_right {
        return Err(("wrong-position", "`position` is not the point of the ray at `t`. `Hit::new` sets it."));
    }
    // Whether a ray along the surface comes from outside or from inside, rounding decides.
    if expected.cosine(ray).abs() < 4.0 * slack.normal {
        return Ok(());
    }
    let normal = hit.geometric_normal.as_dvec3();
    let is_normal_near = |other| normal.distance(other) <= slack.normal;
    if (normal.length() - 1.0).abs() > 1e-3 || normal.is_nan() {
        return Err(("normal-not-unit", "The normal must have length 1. `Hit::new` sees to that."));
    }
    if is_normal_near(-expected.normal(ray)) {
        return Err((
            "normal-not-turned",
            "The normal must face the ray. `Hit::new` turns it, if you give it the outward one.",
        ));
    }
    if !is_normal_near(expected.normal(ray)) {
        return Err(("wrong-normal", "The point is right, but the normal there is not."));
    }
    if hit.side != expected.side(ray) {
        return Err((
            "wrong-side",
            "The point is right, but the side is not: the direction that was given as outward points inward.",
        ));
    }
    if !hit.shading_normal.abs_diff_eq(hit.geometric_normal, 1e-3) {
        return Err(("wrong-shading-normal", "This shape is shaded with its own normal: both normals are the same."));
    }
    Ok(())
}
