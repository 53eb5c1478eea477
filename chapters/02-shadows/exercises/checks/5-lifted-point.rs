//! Checks exercise 2.5, the terminator mended.

use common::{
    Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use glam::DVec3;

use super::{
    lift_mistakes::{Corner, MISTAKES, Mistake, Recipe, right},
    words,
};

/// A point in a triangle.
#[derive(Clone, Copy)]
struct Question {
    corners: [Vec3; 3],
    normals: [Vec3; 3],
    weights: [f32; 3],
}

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

    /// The corners, seen from the point.
    fn seen(&self) -> [Corner; 3] {
        let point = self.point().as_dvec3();
        let corner = |i: usize| {
            let normal = self.normals[i].as_dvec3();
            Corner { normal, weight: f64::from(self.weights[i]), way: self.corners[i].as_dvec3() - point }
        };
        [corner(0), corner(1), corner(2)]
    }

    /// The offset from the point by a recipe.
    fn offset(&self, recipe: Recipe) -> DVec3 {
        let [a, b, c] = self.corners.map(|v| v.as_dvec3());
        recipe(self.seen(), (b - a).cross(c - a).normalize_or_zero())
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

    /// What is wrong with that answer.
    fn finding(&self, got: DVec3, advice: &str) -> Finding {
        let expected = self.point().as_dvec3() + self.offset(right);
        let [a, b, c] = self.seen().map(|corner| words::number(corner.height()));
        let expected = format!("{}, with the heights {a}, {b} and {c}", words::rounded(expected));
        Finding { tried: self.tried(), got: words::rounded(got), expected, advice: advice.into() }
    }
}

/// The function under test.
struct Trial<F>(F);

impl<F: Fn(Vec3, [Vec3; 3], [Vec3; 3], [f32; 3]) -> Vec3> Trial<F> {
    fn answer(&self, question: &Question) -> DVec3 {
        let Question { corners, normals, weights } = *question;
        trying(|| question.tried(), || (self.0)(question.point(), corners, normals, weights)).as_dvec3()
    }

    /// Nothing is lifted: has nobody begun, or do the heights come out as 0?
    fn begun(&self, questions: &[Question; 2]) -> Verdict {
        let is_as_it_was = |q: &Question| self.answer(q).distance(q.point().as_dvec3()) <= 1e-6 * q.size();
        if !questions.iter().all(is_as_it_was) {
            return Ok(());
        }
        // Points above and below the plane of the triangle have a height along any normal. The stub does not care.
        let Question { corners, normals, weights } = questions[0];
        let does_nothing = [-0.5, 0.5].iter().all(|height| {
            let point = questions[0].point() + Vec3::Y * *height;
            trying(|| questions[0].tried(), || (self.0)(point, corners, normals, weights)) == point
        });
        if does_nothing {
            return Err(Diagnosis::not_started("Nothing is lifted yet: `lifted` returns the point as it is."));
        }
        let advice = "Nothing is lifted here: all heights seem to be 0. A height is measured along the normal of the corner, \
                      `normals[i]`. The triangle's own normal is another one, and along that the corner lies as high as the point.";
        let got = self.answer(&questions[0]);
        Err(questions[0].finding(got, advice).named("no-height"))
    }

    /// The mistake, if the answer is wrong: the known one that gives what came out, or the one of that name.
    fn ask(&self, question: &Question, known: &[Mistake], name: &'static str, advice: &str) -> Verdict {
        let (point, got) = (question.point().as_dvec3(), self.answer(question));
        let is = |offset: DVec3| got.distance(point + offset) <= 5e-6 * question.size();
        let expected = question.offset(right);
        if is(expected) {
            return Ok(());
        }
        let known = known.iter().find(|(_, recipes, _)| recipes.iter().any(|recipe| is(question.offset(*recipe))));
        let (name, advice) = if !got.is_finite() {
            ("not-a-number", "Something was divided by zero, or a vector of length zero was normalized.")
        } else if is(expected - point) {
            ("offset-not-point", "This is how far the point must be lifted. Add the point itself.")
        } else {
            known.map_or((name, advice), |(name, _, advice)| (name, advice))
        };
        Err(question.finding(got, advice).named(name))
    }
}

/// Accept a function, or name what is wrong with it.
pub(crate) fn check(lifted: impl Fn(Vec3, [Vec3; 3], [Vec3; 3], [f32; 3]) -> Vec3) -> Verdict {
    // Behind references: so all answers share one copy of the steps.
    steps(&lifted)
}

/// The steps of the check.
fn steps(lifted: &dyn Fn(Vec3, [Vec3; 3], [Vec3; 3], [f32; 3]) -> Vec3) -> Verdict {
    let trial = Trial(lifted);
    let corners = [Vec3::ZERO, Vec3::new(2.0, 0.0, 0.0), Vec3::new(0.0, 0.0, -2.0)];
    // Like a part of a ball, of a hollow one, and of a saddle.
    let round = [Vec3::new(-0.48, 0.8, 0.36), Vec3::new(0.6, 0.8, 0.0), Vec3::new(0.0, 0.8, -0.6)];
    let hollow = [Vec3::new(0.48, 0.8, -0.36), Vec3::new(-0.6, 0.8, 0.0), Vec3::new(0.0, 0.8, 0.6)];
    let saddle = [round[0], hollow[1], round[2]];
    const INSIDE: [f32; 3] = [0.5, 0.125, 0.375];
    let question = |normals, weights| Question { corners, normals, weights };

    let outside = [question(round, INSIDE), question(saddle, INSIDE)];
    trial.begun(&outside)?;
    let advice = "Work it out on paper: three heights, each (corner − point) · normal; what is negative counts as 0; each times its \
                  normal and its weight; and the sum of that added to the point.";
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
        let advice = "Work it out on paper: three heights, each (corner − point) · normal; what is negative counts as 0; each times its \
                  normal and its weight; and the sum of that added to the point.";
        trial.ask(&Question { corners, normals, weights: [a, b, 1.0 - a - b] }, &MISTAKES, "wrong-lift", advice)?;
    }
    Ok(())
}
