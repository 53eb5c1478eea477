//! Checks exercise 2.2, ambient occlusion.

use common::{
    Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use ray_casting::{hit::Hit, ray::Ray, scene::Scene};

use super::{
    blockers::{Blockers, Way},
    words,
};

/// A question: how open is this hit?
#[derive(Clone)]
struct Question {
    blockers: Blockers,
    hit: Hit,
    directions: Vec<Vec3>,
    reach: f32,
}

/// What the value of an answer is made of.
#[derive(Clone, Copy)]
struct Recipe {
    /// What to do with directions into the surface.
    below: Below,
    /// The weight of a direction, by its cosine.
    weight: fn(f64) -> f64,
    /// Openness from the weights that get away, all weights, and the numbers of all directions and of those that get away.
    value: fn(f64, f64, [f64; 2]) -> f64,
    /// How far the rays look, when asked to look that far.
    reach: fn(f64) -> f64,
}

#[derive(Clone, Copy, PartialEq)]
enum Below {
    Turned,
    Mirrored,
    LeftOut,
    Blocked,
    /// Blocked, with a weight below zero.
    Negative,
    /// Turned, with a weight below zero.
    TurnedLate,
}

const RIGHT: Recipe = Recipe {
    below: Below::Turned,
    weight: |cosine| cosine,
    value: |open, all, _| if all > 0.0 { open / all } else { 1.0 },
    reach: |reach| reach,
};

/// A mistake that is known by what comes out: name, recipe, advice.
type Mistake = (&'static str, Recipe, &'static str);

/// Mistakes in the sums.
const SUMS: [Mistake; 14] = [
    (
        "cosine-forgotten",
        Recipe { weight: |_| 1.0, ..RIGHT },
        "This is what comes out when all directions count alike. The weight of a direction is its cosine, ω·N, above the \
         line and below it.",
    ),
    (
        "cosine-squared",
        Recipe { weight: |cosine| cosine * cosine, ..RIGHT },
        "The weight of a direction is its cosine. This is what comes out with the square of it.",
    ),
    (
        "divided-by-count",
        Recipe { value: |open, _, [count, _]| open / count, ..RIGHT },
        "This sum of cosines is divided by the number of directions. Divide it by the sum of all cosines: with that, an \
         open plain comes to 1.",
    ),
    (
        "divided-by-count",
        Recipe { value: |open, _, [count, _]| 2.0 * open / count, ..RIGHT },
        "This sum of cosines is divided by half the number of directions, which fits only in the mean over very many. Divide it by \
         the sum of all cosines: with that, an open plain comes to 1.",
    ),
    (
        "count-by-cosines",
        Recipe { value: |_, all, [_, away]| away / all, ..RIGHT },
        "This is the number of directions that get away, divided by the sum of all cosines. Above the line, too, each direction \
         counts with its cosine.",
    ),
    (
        "mirrored",
        Recipe { below: Below::Mirrored, ..RIGHT },
        "Directions that point into the surface seem to be mirrored at it. Turn them round instead, which is simpler: `-direction`.",
    ),
    (
        "sum-not-mean",
        Recipe { value: |open, _, _| open, ..RIGHT },
        "This is a sum. Divide it by the sum of the weights of all directions, or the answer grows with their number.",
    ),
    (
        "sum-not-mean",
        Recipe { weight: |_| 1.0, value: |open, _, _| open, ..RIGHT },
        "This is the number of directions that get away. What is asked for is a share, with the cosine as weight.",
    ),
    (
        "occlusion-not-openness",
        Recipe { value: |open, all, _| 1.0 - open / all, ..RIGHT },
        "This is the share that is hidden. Openness is the share that gets away: is there a `!` too few or too many?",
    ),
    (
        "only-the-open-ones",
        Recipe { value: |open, _, _| f64::from(open > 0.0), ..RIGHT },
        "The sum in the denominator goes over all directions, those that are blocked too.",
    ),
    (
        "left-out",
        Recipe { below: Below::LeftOut, ..RIGHT },
        "Directions that point into the surface seem to be left out. Turn them round instead: `-direction`.",
    ),
    (
        "not-turned-round",
        Recipe { below: Below::Blocked, ..RIGHT },
        "Directions that point into the surface seem to count as blocked. Turn them round before you send the ray.",
    ),
    (
        "not-turned-round",
        Recipe { below: Below::Negative, ..RIGHT },
        "Directions that point into the surface count with a negative cosine. Turn them round before you send the ray and compute \
         the cosine.",
    ),
    (
        "cosine-too-early",
        Recipe { below: Below::TurnedLate, ..RIGHT },
        "Directions that point into the surface are turned round, but their cosine is still negative. Compute it from the turned \
         direction.",
    ),
];

/// Rays without an end.
const NO_REACH: Mistake = (
    "reach-ignored",
    Recipe { reach: |_| f64::INFINITY, ..RIGHT },
    "This is blocked by something farther away than `reach`. The range of a shadow ray can end there: `up_to`.",
);

impl Question {
    /// The hit of a ray, without the directions for which rounding decides. `None` if the ray hits nothing.
    fn new(blockers: Blockers, ray: &Ray, directions: &[Vec3], reach: f32) -> Option<Self> {
        let hit = blockers.hit(ray)?;
        let mut question = Self { blockers, hit, directions: directions.to_vec(), reach };
        let clear = |direction: &Vec3| {
            let reaches = [f64::from(reach), f64::INFINITY];
            let both = [*direction, -*direction];
            both.iter().all(|d| reaches.iter().all(|reach| question.way(*d, *reach) != Way::Unclear))
        };
        let directions = directions.iter().copied().filter(clear).collect();
        question.directions = directions;
        Some(question)
    }

    fn way(&self, direction: Vec3, reach: f64) -> Way {
        let [point, normal] = [self.hit.position, self.hit.geometric_normal].map(|v| v.as_dvec3());
        self.blockers.way(point, normal, direction.as_dvec3(), reach)
    }

    /// What comes out by a recipe.
    fn value(&self, recipe: &Recipe) -> f64 {
        let reach = (recipe.reach)(f64::from(self.reach));
        let (mut open, mut all, mut away) = (0.0, 0.0, 0.0);
        let normal = self.hit.geometric_normal;
        for &direction in &self.directions {
            let cosine = direction.as_dvec3().dot(normal.as_dvec3());
            let is_below = cosine < 0.0;
            if is_below && recipe.below == Below::LeftOut {
                continue;
            }
            let is_negative = is_below && matches!(recipe.below, Below::Negative | Below::TurnedLate);
            let weight = (recipe.weight)(cosine.abs()) * if is_negative { -1.0 } else { 1.0 };
            all += weight;
            let outward = match recipe.below {
                Below::Mirrored if is_below => direction.reflect(normal),
                _ if is_below => -direction,
                _ => direction,
            };
            let is_blocked = is_below && matches!(recipe.below, Below::Blocked | Below::Negative);
            if !is_blocked && self.way(outward, reach) == Way::Free {
                open += weight;
                away += 1.0;
            }
        }
        #[expect(clippy::cast_precision_loss, reason = "few directions")]
        let count = self.directions.len() as f64;
        (recipe.value)(open, all, [count, away])
    }

    fn tried(&self) -> String {
        let directions = match &*self.directions {
            [] => "no directions".into(),
            [only] => format!("the only direction {}", words::triple(*only)),
            [first, second, .., last] if self.directions.len() > 12 => {
                let [first, second, last] = [*first, *second, *last].map(words::triple);
                format!("{} directions: {first}, {second} and so on to {last}", self.directions.len())
            }
            all => format!("the directions {}", all.iter().map(|d| words::triple(*d)).collect::<Vec<_>>().join(", ")),
        };
        let reach = if self.reach.is_finite() { self.reach.to_string() } else { "∞".into() };
        format!("{}, reach {reach}, {directions}, {}", words::hit(&self.hit), self.blockers.words())
    }
}

/// Not the name of a mistake: what came out is of no known kind.
const OTHER: &str = "other";

/// The function under test.
struct Trial<F>(F);

impl<F: Fn(&Scene<()>, &Hit, &[Vec3], f32) -> f32> Trial<F> {
    fn answer(&self, question: &Question) -> f64 {
        let Question { blockers, hit, directions, reach } = question;
        f64::from(trying(|| question.tried(), || (self.0)(&blockers.scene(()), hit, directions, *reach)))
    }

    /// The mistake, if the answer is wrong: the known one that gives what came out, if any, or the one of that name.
    fn ask(&self, question: &Question, known: &[Mistake], name: &'static str, advice: &str) -> Verdict {
        let (got, expected) = (self.answer(question), question.value(&RIGHT));
        let is = |value: f64| (got - value).abs() < 1e-4;
        if is(expected) {
            return Ok(());
        }
        let known = known.iter().find(|(_, recipe, _)| is(question.value(recipe)));
        let (name, advice) = if got.is_nan() {
            (
                "not-a-number",
                "Something was divided by zero: what if there are no directions, or all of them run along the surface?",
            )
        } else if let Some((name, _, advice)) = known {
            (*name, *advice)
        } else if name != OTHER && got > 1.0001 {
            (
                "above-one",
                "Openness is a share, and no share is above 1. What stands above the line must be a part of what stands below it: \
                 cosines of the directions that get away, cosines of all directions.",
            )
        } else {
            (name, advice)
        };
        Err(Finding {
            tried: question.tried(),
            got: words::number(got),
            expected: words::number(expected),
            advice: advice.into(),
        }
        .named(name))
    }

    /// Ask for one particular mistake.
    fn probe(&self, question: &Question, name: &'static str, advice: &str) -> Verdict {
        self.ask(question, &[], name, advice)
    }
}

/// Unit vectors above the floor. None of them lies opposite to another.
const ABOVE: [Vec3; 5] = [
    Vec3::new(0.0, 1.0, 0.0),
    Vec3::new(0.8, 0.6, 0.0),
    Vec3::new(-0.6, 0.8, 0.0),
    Vec3::new(0.0, 0.6, -0.8),
    Vec3::new(0.48, 0.6, 0.64),
];

/// Unit vectors below it.
const BELOW: [Vec3; 3] = [Vec3::new(-0.96, -0.28, 0.0), Vec3::new(0.0, -0.96, 0.28), Vec3::new(0.64, -0.6, 0.48)];

/// Accept a function, or name what is wrong with it.
pub(crate) fn check(openness: impl Fn(&Scene<()>, &Hit, &[Vec3], f32) -> f32) -> Verdict {
    // Behind references: so all answers share one copy of the steps.
    steps(&openness)
}

/// An answer.
type Openness<'f> = &'f dyn Fn(&Scene<()>, &Hit, &[Vec3], f32) -> f32;

/// The steps of the check.
fn steps(openness: Openness<'_>) -> Verdict {
    let trial = Trial(openness);
    let both: Vec<_> = ABOVE.into_iter().chain(BELOW).collect();
    let down = Ray::new(Vec3::Y * 0.1, -Vec3::Y);
    let beside = Blockers::on_floor(&[(Vec3::new(1.2, 0.9, 0.0), 0.4), (Vec3::new(-1.2, 0.35, 0.0), 0.3)]);
    let ask = |blockers: &Blockers, ray: &Ray, directions: &[Vec3], reach, known: &[Mistake], name, advice: &str| {
        let question = Question::new(blockers.clone(), ray, directions, reach);
        question.map_or(Ok(()), |question| trial.ask(&question, known, name, advice))
    };
    // The stub says that everything is open.
    let stub = Question::new(beside.clone(), &down, &both, 9.0);
    let closed = Question::new(Blockers::in_space(&[(Vec3::ZERO, 1.0)]), &Ray::new(Vec3::ZERO, Vec3::X), &ABOVE, 9.0);
    let asked: Vec<_> = [&stub, &closed].into_iter().flatten().collect();
    if let [first, .., last] = &*asked
        && asked.iter().all(|question| trial.answer(question) == 1.0)
    {
        // Sums overflow here, and their ratio is a NaN. The stub has none.
        let overflow = Question { directions: vec![first.hit.geometric_normal * f32::MAX; 3], ..(*first).clone() };
        if trial.answer(&overflow) == 1.0 {
            return Err(Diagnosis::not_started(
                "Everything is open so far: `openness` returns 1 even in a closed ball.",
            ));
        }
        let advice = "Nothing ever seems to be in the way, not even of rays inside a closed ball. Does the range of the shadow ray go \
                      from 0 to `reach`, and is what gets away told from what does not?";
        trial.probe(last, "all-open", advice)?;
    }

    let plain = Blockers::on_floor(&[]);
    if let Some(question) = Question::new(plain.clone(), &down, &ABOVE, 9.0)
        && [Some(&question), stub.as_ref()].into_iter().flatten().all(|question| trial.answer(question) == 0.0)
    {
        let advice = "Even on an open plain nothing gets away. Do the rays start below the surface, or go into it?";
        trial.probe(&question, "all-blocked", advice)?;
    }
    let up = "Nothing but the floor is there, and all of these directions point upward. They all get away. If the floor hides \
              itself: do the rays start above it, by `Offset::Following.origin(hit, normal)`?";
    let advice = "Work it out on paper: which of these directions meet a ball, and what are their cosines?";
    ask(&beside, &down, &ABOVE, 9.0, &SUMS, "wrong-openness", advice)?;
    ask(&plain, &down, &ABOVE, 9.0, &[], "open-plain", up)?;
    let turn = "Nothing but the floor is there, but some of these directions point into it. Turn those round.";
    ask(&plain, &down, &both, 9.0, &SUMS, "not-turned-round", turn)?;
    ask(&beside, &down, &both, 9.0, &SUMS, "wrong-openness", advice)?;

    let advice =
        "From inside a closed ball nothing gets away. Do the rays start on the side to which the hit's normal points?";
    ask(&Blockers::in_space(&[(Vec3::ZERO, 1.0)]), &Ray::new(Vec3::ZERO, Vec3::X), &both, 9.0, &[], "leaks", advice)?;
    let advice = "What lies beyond `reach` hides nothing, what lies before it does.";
    for reach in [0.5, 1.0, 1.4, f32::INFINITY] {
        ask(&beside, &down, &both, reach, &[NO_REACH], "wrong-reach", advice)?;
    }
    nobody_knows(&trial, &plain, &down)?;
    many_directions(&trial, &beside, &down)?;
    normals(&trial, &both)?;
    offsets(&trial)?;

    // Many hits.
    let mut dice = Dice::new(22);
    for _ in 0..400 {
        let ball = |dice: &mut Dice| (dice.point(2.0) + Vec3::Y * 2.2, dice.choice([0.2, 0.5, 1.0]));
        let balls = [(); 4].map(|()| ball(&mut dice));
        let directions = [(); 5].map(|()| dice.direction().normalize());
        let ray = Ray::new(Vec3::Y * 9.0 + dice.point(2.0), -Vec3::Y + dice.point(0.2));
        let reach = dice.choice([0.5, 1.0, 3.0, f32::INFINITY]);
        let advice = "Work it out on paper: which of these directions, turned outward, meet a ball before `reach`?";
        ask(&Blockers::on_floor(&balls), &ray, &directions, reach, &[], "wrong-openness", advice)?;
    }
    Ok(())
}

/// More directions than one would write down.
fn many_directions<F>(trial: &Trial<F>, beside: &Blockers, down: &Ray) -> Verdict
where
    F: Fn(&Scene<()>, &Hit, &[Vec3], f32) -> f32,
{
    let mut dice = Dice::new(222);
    for count in [50, 300] {
        // The last ones point at a ball, which no fair share of the first does.
        let toward = |dice: &mut Dice| (Vec3::new(1.2, 0.9, 0.0) + dice.point(0.1)).normalize();
        let directions: Vec<_> =
            (0..count).map(|i| if i < count / 2 { dice.direction().normalize() } else { toward(&mut dice) }).collect();
        let advice = "There are many directions here. Does the loop go through all of them?";
        if let Some(question) = Question::new(beside.clone(), down, &directions, 9.0) {
            trial.probe(&question, "few-directions", advice)?;
        }
    }
    Ok(())
}

/// Nothing to sum up.
fn nobody_knows<F>(trial: &Trial<F>, plain: &Blockers, down: &Ray) -> Verdict
where
    F: Fn(&Scene<()>, &Hit, &[Vec3], f32) -> f32,
{
    let Some(hit) = plain.hit(down) else { return Ok(()) };
    for directions in [vec![], vec![Vec3::X, -Vec3::Z]] {
        let question = Question { blockers: plain.clone(), hit, directions, reach: 9.0 };
        let advice = "All weights sum up to 0 here. Nobody knows how open this place is: then the answer is 1.";
        trial.probe(&question, "nobody-knows", advice)?;
    }
    Ok(())
}

/// Surfaces that are not level, and normals that are not those of the surface.
fn normals<F>(trial: &Trial<F>, directions: &[Vec3]) -> Verdict
where
    F: Fn(&Scene<()>, &Hit, &[Vec3], f32) -> f32,
{
    let pair = Blockers::in_space(&[(Vec3::ZERO, 1.0), (Vec3::new(2.4, 1.5, 0.0), 1.0)]);
    for from in [Vec3::X, -Vec3::X, -Vec3::Y, Vec3::new(1.0, 0.8, 0.5)] {
        let ray = Ray::new(from * 1.2, -from);
        if let Some(question) = Question::new(pair.clone(), &ray, directions, 9.0) {
            let advice =
                "This surface is not level. Does your function turn and weigh directions by the hit's own normal?";
            trial.probe(&question, "normal-ignored", advice)?;
            let leaning = (question.hit.geometric_normal + Vec3::new(0.3, -0.5, 0.6)).normalize();
            let hit = Hit { shading_normal: leaning, ..question.hit };
            let advice = "At this hit the shading normal is another one than the geometric normal. Here all is done with the \
                          geometric one: which way is out, where rays start, and the weight.";
            trial.probe(&Question { hit, ..question }, "shading-normal", advice)?;
        }
    }
    Ok(())
}

/// Rays must leave the surface, wherever it is and however large.
fn offsets<F>(trial: &Trial<F>) -> Verdict
where
    F: Fn(&Scene<()>, &Hit, &[Vec3], f32) -> f32,
{
    let mut dice = Dice::new(122);
    // At (k, k, k).
    for (k, radius, name, advice) in [
        (
            3.0,
            1.0,
            "self-shadow",
            "There is nothing but one ball here, seen from outside, so that all directions get away. A ray hits the \
             surface that it leaves if it starts on it, or too little above it, or beside it along its own direction. Start above \
             it, along the normal: `Offset::Following.origin(hit, normal)`.",
        ),
        (
            1e5,
            1.0,
            "fixed-offset",
            "There is nothing but one ball here, seen from outside, so that all directions get away. But its numbers are \
             great, and so are their rounding errors. An offset that does not grow with them is lost: `Offset::Following` does.",
        ),
    ] {
        for _ in 0..200 {
            let ball = Blockers::in_space(&[(Vec3::splat(k), radius)]);
            let ray = Ray::new(Vec3::splat(k) + dice.direction().normalize() * 4.0, Vec3::ZERO);
            let ray = Ray::new(ray.origin, Vec3::splat(k) + dice.point(0.4) - ray.origin);
            let directions = [(); 4].map(|()| dice.direction().normalize());
            if let Some(question) = Question::new(ball, &ray, &directions, f32::INFINITY) {
                trial.probe(&question, name, advice)?;
            }
        }
    }
    let plain = Blockers::on_floor(&[]);
    for _ in 0..400 {
        let ray = Ray::new(Vec3::Y * 9.0 + dice.point(3.0), -Vec3::Y + dice.point(0.4));
        let directions = [(); 4].map(|()| dice.direction().normalize());
        let advice = "There is nothing but the floor here, so that all directions get away: the floor hides itself. Rays that start \
                      too little above it, or beside it along their own direction, hit it at once. Start above it, along the \
                      normal: `Offset::Following.origin(hit, normal)`.";
        if let Some(question) = Question::new(plain.clone(), &ray, &directions, f32::INFINITY) {
            trial.probe(&question, "self-shadow", advice)?;
        }
    }
    // Two grains that nearly touch: what hides the sky is closer than any fixed offset that would do elsewhere.
    let grains = Blockers::in_space(&[(Vec3::ZERO, 1e-3), (Vec3::new(0.0, 2.05e-3, 0.0), 1e-3)]);
    let ray = Ray::new(Vec3::new(4e-3, 1.02e-3, 0.0), Vec3::new(-4e-3, -0.1e-3, 0.0));
    if let Some(question) = Question::new(grains, &ray, &ABOVE, f32::INFINITY) {
        let advice = "Two grains of dust nearly touch here. A fixed offset jumps from the one to behind the surface of the other: \
                      the offset must follow the numbers. `Offset::Following` does.";
        trial.probe(&question, "fixed-offset", advice)?;
    }
    Ok(())
}
