//! Checks exercise 2.5, the terminator mended.

use common::{
    Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use glam::DVec3;

use super::words;

/// A point in a triangle.
#[derive(Clone, Copy)]
struct Question {
    corners: [Vec3; 3],
    normals: [Vec3; 3],
    weights: [f32; 3],
}

/// One corner of the triangle, seen from the point.
#[derive(Clone, Copy)]
struct Corner {
    normal: DVec3,
    weight: f64,
    /// How far the plane in the corner lies above the point.
    height: f64,
}

/// What comes out, as an offset from the point: by the corners and the triangle's own unit normal.
type Recipe = fn([Corner; 3], DVec3) -> DVec3;

fn sum(corners: [Corner; 3], part: impl Fn(Corner) -> DVec3) -> DVec3 {
    corners.into_iter().map(part).sum()
}

fn right(corners: [Corner; 3], _own: DVec3) -> DVec3 {
    sum(corners, |c| c.normal * c.weight * c.height.max(0.0))
}

/// The interpolated normal.
fn interpolated(corners: [Corner; 3]) -> DVec3 {
    sum(corners, |c| c.normal * c.weight).normalize()
}

/// A mistake that is known by what comes out: name, recipe, advice.
type Mistake = (&'static str, Recipe, &'static str);

const MISTAKES: [Mistake; 9] = [
    (
        "sunk",
        |corners, _| sum(corners, |c| c.normal * c.weight * c.height),
        "This point is sunk below the triangle, or lifted less than it should be: a plane that lies below the point counts with \
         0, not with a negative height. `max` sees to that.",
    ),
    (
        "wrong-sign",
        |corners, _| sum(corners, |c| c.normal * c.weight * (-c.height).max(0.0)),
        "The sign of the height is wrong. It is positive where the plane lies above the point: (corner − point) · normal.",
    ),
    (
        "wrong-sign",
        |corners, own| -right(corners, own),
        "The point is moved the wrong way. It must go up to the planes, along the normals.",
    ),
    (
        "wrong-sign",
        |corners, _| sum(corners, |c| c.normal * c.weight * c.height.min(0.0)),
        "Only planes below the point count here, and the point sinks. It is the other way round: `max`, not `min`.",
    ),
    (
        "weights-ignored",
        |corners, _| sum(corners, |c| c.normal * c.height.max(0.0)),
        "The three lifts are added up without weights. The nearer the point is to a corner, the more that corner counts: \
         multiply by the weights.",
    ),
    (
        "weights-ignored",
        |corners, _| sum(corners, |c| c.normal * c.height.max(0.0)) / 3.0,
        "All three corners count alike. The nearer the point is to a corner, the more that corner counts: multiply by the weights.",
    ),
    (
        "triangle-normal",
        |corners, own| own * sum(corners, |c| DVec3::splat(c.weight * c.height.max(0.0))).x,
        "The point is lifted along the triangle's own normal. For each corner, lift it along the normal of that corner.",
    ),
    (
        "interpolated-normal",
        |corners, _| interpolated(corners) * sum(corners, |c| DVec3::splat(c.weight * c.height.max(0.0))).x,
        "The point is lifted along the interpolated normal. For each corner, lift it along the normal of that corner.",
    ),
    (
        "order-mixed",
        |[a, b, c], own| {
            let turned =
                [Corner { weight: b.weight, ..a }, Corner { weight: c.weight, ..b }, Corner { weight: a.weight, ..c }];
            right(turned, own)
        },
        "Corners and weights do not belong together here. The first weight is that of the first corner.",
    ),
];

impl Question {
    /// The point itself.
    fn point(&self) -> Vec3 {
        let [a, b, c] = self.corners;
        let [alpha, beta, gamma] = self.weights;
        a * alpha + b * beta + c * gamma
    }

    /// Longest edge.
    fn size(&self) -> f64 {
        let [a, b, c] = self.corners.map(|v| v.as_dvec3());
        a.distance(b).max(b.distance(c)).max(c.distance(a))
    }

    /// The offset from the point by a recipe.
    fn offset(&self, recipe: Recipe) -> DVec3 {
        let point = self.point().as_dvec3();
        let corner = |i: usize| {
            let normal = self.normals[i].as_dvec3();
            let height = (self.corners[i].as_dvec3() - point).dot(normal);
            Corner { normal, weight: f64::from(self.weights[i]), height }
        };
        let [a, b, c] = self.corners.map(|v| v.as_dvec3());
        recipe([corner(0), corner(1), corner(2)], (b - a).cross(c - a).normalize_or_zero())
    }

    fn tried(&self) -> String {
        let list = |vectors: [Vec3; 3]| vectors.map(words::triple).join(", ");
        let [alpha, beta, gamma] = self.weights;
        format!(
            "the point {} with weights {alpha}, {beta}, {gamma} in the triangle of corners {} with normals {}",
            words::triple(self.point()),
            list(self.corners),
            list(self.normals)
        )
    }
}

/// The function under test.
struct Trial<F>(F);

impl<F: Fn(Vec3, [Vec3; 3], [Vec3; 3], [f32; 3]) -> Vec3> Trial<F> {
    fn answer(&self, question: &Question) -> DVec3 {
        let Question { corners, normals, weights } = *question;
        trying(|| question.tried(), || (self.0)(question.point(), corners, normals, weights)).as_dvec3()
    }

    /// The mistake, if the answer is wrong: the known one that gives what came out, or the one of that name.
    fn ask(&self, question: &Question, known: &[Mistake], name: &'static str, advice: &str) -> Verdict {
        let (point, got) = (question.point().as_dvec3(), self.answer(question));
        let is = |offset: DVec3| got.distance(point + offset) <= 5e-6 * question.size();
        let expected = question.offset(right);
        if is(expected) {
            return Ok(());
        }
        let known = known.iter().find(|(_, recipe, _)| is(question.offset(*recipe)));
        let (name, advice) = if !got.is_finite() {
            ("not-a-number", "Something was divided by zero, or a vector of length zero was normalized.")
        } else if is(expected - point) {
            ("offset-not-point", "This is how far the point must be lifted. Add the point itself.")
        } else {
            known.map_or((name, advice), |(name, _, advice)| (name, advice))
        };
        Err(Finding {
            tried: question.tried(),
            got: words::rounded(got),
            expected: words::rounded(point + expected),
            advice: advice.into(),
        }
        .named(name))
    }
}

/// Accept a function, or name what is wrong with it.
pub(crate) fn check(lifted: impl Fn(Vec3, [Vec3; 3], [Vec3; 3], [f32; 3]) -> Vec3) -> Verdict {
    let trial = Trial(lifted);
    let corners = [Vec3::ZERO, Vec3::new(2.0, 0.0, 0.0), Vec3::new(0.0, 0.0, -2.0)];
    // Like a part of a ball, of a hollow one, and of a saddle.
    let round = [Vec3::new(-0.48, 0.8, 0.36), Vec3::new(0.6, 0.8, 0.0), Vec3::new(0.0, 0.8, -0.6)];
    let hollow = [Vec3::new(0.48, 0.8, -0.36), Vec3::new(-0.6, 0.8, 0.0), Vec3::new(0.0, 0.8, 0.6)];
    let saddle = [round[0], hollow[1], round[2]];
    const INSIDE: [f32; 3] = [0.5, 0.125, 0.375];
    let question = |normals, weights| Question { corners, normals, weights };

    let outside = [question(round, INSIDE), question(saddle, INSIDE)];
    if outside.iter().all(|q| trial.answer(q) == q.point().as_dvec3()) {
        return Err(Diagnosis::not_started("Nothing is lifted yet: `lifted` returns the point as it is."));
    }
    let advice = "Work it out on paper: three heights, three lifts along the normals, and their weighted mean.";
    trial.ask(&question(round, INSIDE), &MISTAKES, "wrong-lift", advice)?;
    let advice = "The planes of some corners lie below this point. Those do not count.";
    trial.ask(&question(saddle, INSIDE), &MISTAKES, "sunk", advice)?;
    let advice = "All three planes lie below this point: the surface is hollow. The point stays where it is.";
    trial.ask(&question(hollow, INSIDE), &[], "sunk", advice)?;
    let advice = "All normals are at right angles to this triangle. It is flat, and the point stays where it is.";
    trial.ask(&question([Vec3::Y; 3], INSIDE), &[], "flat-lifted", advice)?;
    for weights in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
        let advice = "This is a corner. The plane of the corner goes through it, and the other two have the weight 0: the point \
                      stays where it is.";
        trial.ask(&question(round, weights), &[], "corner-lifted", advice)?;
    }
    for weights in [[0.5, 0.5, 0.0], [0.0, 0.25, 0.75], [0.75, 0.0, 0.25]] {
        let advice = "This point lies on an edge. Only the two corners of the edge count, or the neighbor triangle would lift it to \
                      another place.";
        trial.ask(&question(round, weights), &[], "edge-torn", advice)?;
    }
    for size in [1e-3, 1e3] {
        let advice =
            "This triangle is of another size. Do not compare with fixed small numbers, and do not limit the lift.";
        let corners = corners.map(|corner| corner * size);
        trial.ask(&Question { corners, normals: round, weights: INSIDE }, &[], "fixed-size", advice)?;
    }

    // Many triangles.
    let mut dice = Dice::new(25);
    for _ in 0..2000 {
        let corners = [(); 3].map(|()| dice.point(3.0));
        let normals = [(); 3].map(|()| dice.direction().normalize());
        let [a, b] = [(); 2].map(|()| dice.choice([0.0, 0.125, 0.25, 0.375, 0.5]));
        let advice = "Work it out on paper: three heights, three lifts along the normals, and their weighted mean.";
        trial.ask(&Question { corners, normals, weights: [a, b, 1.0 - a - b] }, &[], "wrong-lift", advice)?;
    }
    Ok(())
}
