//! Compares what a shape answers with what is right, and names the likely mistake.

use common::{
    Interval,
    exercise::{Finding, Verdict, trying},
};
use ray_casting::{hit::Hit, ray::Ray, shape::Shape};

use super::{
    crossing::{Crossing, Reference, first_in, is_at, ranges},
    words,
};

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
    /// Ask about one ray and one range. A ray that is no fair question is passed over.
    pub(crate) fn ask(&self, ray: &Ray, range: Interval) -> Verdict {
        self.judge(ray, range, |general| general)
    }

    /// Ask for one particular mistake: if the wrong hit comes back, this is its name and where to look, unless it is plain
    /// what is wrong.
    pub(crate) fn probe(&self, ray: &Ray, range: Interval, name: &'static str, advice: &str) -> Verdict {
        let is_plain = |general: Mistake| [UNIT_DIRECTION.0, NOT_NEAREST.0].contains(&general.0);
        self.judge(ray, range, |general| if is_plain(general) { general } else { (name, advice) })
    }

    /// Ask about one ray with all ranges that are worth it.
    pub(crate) fn compare(&self, ray: &Ray) -> Verdict {
        let Some(crossings) = self.ideal.crossings(ray) else { return Ok(()) };
        ranges(&crossings).into_iter().try_for_each(|range| self.ask(ray, range))
    }

    /// Whether none of these rays hits the answer, neither before nor behind its origin.
    pub(crate) fn is_never_hit(&self, rays: &[Ray]) -> bool {
        let ranges = [Interval::POSITIVE, Interval::new(-100.0, 100.0)];
        rays.iter().all(|ray| ranges.iter().all(|range| self.shape.intersect(ray, *range).is_none()))
    }

    /// Accept the answer, or name the mistake. `particular` may give the wrong hit another name than its general one.
    fn judge<'a>(&self, ray: &Ray, range: Interval, particular: impl Fn(Mistake<'a>) -> Mistake<'a>) -> Verdict {
        let Some(crossings) = self.ideal.crossings(ray) else { return Ok(()) };
        let expected = first_in(&crossings, range);
        let tried = || format!("{}, {}, at {}", words::ray(ray), words::range(range), self.ideal.words());
        let answer = trying(tried, || self.shape.intersect(ray, range));
        let finding = |(name, advice): Mistake, more: &str| {
            Finding {
                tried: tried(),
                got: words::answer(answer),
                expected: words::crossing(expected, ray),
                advice: format!("{advice}{more}"),
            }
            .named(name)
        };
        wrong_hit(ray, range, &crossings, answer, self.slack).map_err(|general| finding(particular(general), ""))?;
        let (Some(hit), Some(expected)) = (answer, expected) else { return Ok(()) };
        wrong_surface(&hit, &expected, ray, self.slack)
            .map_err(|mistake| finding(mistake, &format!(" The outward normal {}.", self.ideal.outward_normal())))
    }
}

/// Name and advice.
type Mistake<'a> = (&'static str, &'a str);

/// A hit, but not the first one.
const NOT_NEAREST: Mistake =
    ("not-nearest", "This is a hit, but another one is nearer. Of all hits in the range the least `t` wins.");

/// A ray parameter in scene units.
const UNIT_DIRECTION: Mistake = (
    "unit-direction",
    "`t` counts lengths of the ray's direction, and this direction is not of unit length. Do not normalize it, or divide \
     by its length again in the end.",
);

/// Accept that there is a hit and its `t`, or say what is wrong.
fn wrong_hit(
    ray: &Ray,
    range: Interval,
    crossings: &[Crossing],
    answer: Option<Hit>,
    slack: Slack,
) -> Result<(), Mistake<'static>> {
    let expected = first_in(crossings, range);
    let hit = match (answer, expected) {
        (None, None) => return Ok(()),
        (None, Some(c)) if c.t < 0.0 => {
            return Err((
                "only-positive",
                "This range begins before the ray's origin. The range says what counts, not `t > 0`.",
            ));
        }
        (None, Some(c)) if crossings.iter().any(|other| other.t < c.t) => {
            return Err((
                "later-hit-forgotten",
                "The ray meets the shape before this range begins, and once more inside the range. When a hit does not \
                 count, go on with the next one instead of giving up.",
            ));
        }
        (None, Some(_)) => {
            return Err(("missed", "The shape was missed. Work out by hand what your formula gives for this ray."));
        }
        (Some(hit), _) => hit,
    };
    if !hit.t.is_finite() {
        return Err(("not-a-number", "`t` must be a number: is something divided by zero?"));
    }
    if !range.contains(hit.t) {
        return Err(("ignores-range", "This `t` lies outside the range. `range.contains(t)` tells which hits count."));
    }
    let Some(expected) = expected else {
        return Err(("hit-beside", "There is nothing at that place: the ray passes by."));
    };
    let length = f64::from(ray.direction.length());
    let is_scaled = [length, 1.0 / length].iter().any(|by| (f64::from(hit.t) * by - expected.t).abs() <= slack.t);
    if is_at(&hit, &expected, ray, slack.t) {
        Ok(())
    } else if crossings.iter().any(|c| is_at(&hit, c, ray, slack.t)) {
        Err(NOT_NEAREST)
    } else if is_scaled {
        Err(UNIT_DIRECTION)
    } else {
        Err(("wrong-t", "`t` is wrong. Work out by hand what your formula gives for this ray."))
    }
}

/// Accept position, normals and side of the right hit, or say what is wrong.
fn wrong_surface(hit: &Hit, expected: &Crossing, ray: &Ray, slack: Slack) -> Result<(), Mistake<'static>> {
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
    if normal.is_nan() || (normal.length() - 1.0).abs() > 1e-3 {
        Err(("normal-not-unit", "The normal must have length 1. `Hit::new` sees to that."))
    } else if is_normal_near(-expected.normal(ray)) {
        Err(("normal-not-turned", "The normal must face the ray. `Hit::new` turns it, if you give it the outward one."))
    } else if !is_normal_near(expected.normal(ray)) {
        Err(("wrong-normal", "The point is right, but the normal there is not."))
    } else if hit.side != expected.side(ray) {
        Err((
            "wrong-side",
            "Point and normal are right, but the side is not. Give `Hit::new` the outward normal as it is, wherever the \
             ray comes from: it notes the side before it turns the normal.",
        ))
    } else if !hit.shading_normal.abs_diff_eq(hit.geometric_normal, 1e-3) {
        Err(("wrong-shading-normal", "This shape is shaded with its own normal: both normals are the same."))
    } else {
        Ok(())
    }
}
