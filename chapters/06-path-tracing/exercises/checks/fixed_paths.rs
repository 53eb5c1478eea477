//! Whether a path goes where its points tell it.

use std::cell::Cell;

use common::{
    Rgb, Stream, Vec2, Vec3,
    color::luminance,
    exercise::{Diagnosis, Finding, Verdict, trying, words::rounded},
    picture::FilmPoint,
    story::Untold,
};
use path_tracing::{importance::Step, material::Material, path_tracer::PathTracer};
use ray_casting::hit::Hit;
use sampling::{
    direction_sampling::DirectionSampling::{self, CosineHemisphere, UniformHemisphere},
    estimate::Estimate,
    unit_square::sample_unit_square,
};

use super::{
    garden,
    path_mistakes::{self as mistakes, Mistake},
    pixel_means::Trace,
};

/// How the paths of an answer go.
#[derive(Clone, Copy)]
struct Recipe {
    /// Where in the pixel a path goes through.
    in_pixel: fn([Vec2; 3]) -> Vec2,
    /// What decides the first and the second direction.
    directions: fn([Vec2; 3]) -> [Vec2; 2],
    /// How directions are distributed.
    sampling: DirectionSampling,
    /// By what the albedo is multiplied, by the cosine and the density's weight.
    factor: fn(f32, f32) -> f32,
}

const RIGHT: Recipe =
    Recipe { in_pixel: |p| p[0], directions: |p| [p[1], p[2]], sampling: CosineHemisphere, factor: |_, _| 1.0 };

/// Likely mistakes, and how paths go with them.
const RIVALS: [(Recipe, Mistake); 10] = [
    (Recipe { in_pixel: |_| Vec2::splat(0.5), ..RIGHT }, mistakes::MIDDLE_OF_THE_PIXEL),
    (Recipe { in_pixel: |_| Vec2::ZERO, ..RIGHT }, mistakes::CORNER_OF_THE_PIXEL),
    (Recipe { in_pixel: |p| p[0] - 0.5, ..RIGHT }, mistakes::HALF_A_PIXEL_OFF),
    (Recipe { in_pixel: |p| p[0] + 0.5, ..RIGHT }, mistakes::HALF_A_PIXEL_OFF),
    (Recipe { directions: |p| [p[2], p[1]], ..RIGHT }, mistakes::SWAPPED),
    (Recipe { directions: |p| [p[0], p[1]], ..RIGHT }, mistakes::ONE_LATE),
    (Recipe { directions: |p| [p[1], p[1]], ..RIGHT }, mistakes::FIRST_TWICE),
    (Recipe { sampling: UniformHemisphere, ..RIGHT }, mistakes::UNIFORM),
    (
        Recipe {
            sampling: UniformHemisphere,
            factor: |cosine, weight| cosine * weight / std::f32::consts::PI,
            ..RIGHT
        },
        mistakes::UNIFORM,
    ),
    (Recipe { factor: |cosine, _| cosine, ..RIGHT }, mistakes::COSINE_TWICE),
];

impl Recipe {
    /// The radiance along a path.
    fn trace(&self, tracer: &PathTracer, question: &Question, random: &mut Stream) -> Rgb {
        let Question { pixel, points } = *question;
        let position = pixel.position + (self.in_pixel)(points);
        let bounce = Cell::new(0);
        let next = |material: &Material, hit: &Hit, _: Vec3, random: &mut Stream, _: &mut Untold| {
            let given = (self.directions)(points).get(bounce.replace(bounce.get() + 1)).copied();
            let u = given.unwrap_or_else(|| sample_unit_square(random));
            let sample = self.sampling.sample(hit.shading_normal, u);
            let cosine = sample.direction.dot(hit.shading_normal);
            let factor = (self.factor)(cosine, sample.density.weight());
            Some(Step { direction: sample.direction, weight: material.albedo() * factor })
        };
        tracer.walk(tracer.camera.ray(FilmPoint { position, ..pixel }), random, &mut Untold, next)
    }
}

/// A path that is asked for.
struct Question {
    pixel: FilmPoint,
    points: [Vec2; 3],
}

impl Question {
    /// Some pixel of a film of 16 × 10, and some points.
    fn number(i: u64) -> Self {
        let mut random = Stream::new(69, i, 0);
        let size = Vec2::new(16.0, 10.0);
        let position = (size * sample_unit_square(&mut random)).floor();
        Self { pixel: FilmPoint { position, size }, points: [(); 3].map(|()| sample_unit_square(&mut random)) }
    }

    /// What the student's path brings.
    fn ask(&self, trace: Trace, tracer: &PathTracer, seed: u64) -> Rgb {
        trying(|| self.words(tracer), || trace(tracer, self.pixel, self.points, &mut Stream::new(70, seed, 0)))
    }

    fn words(&self, tracer: &PathTracer) -> String {
        let [x, y] = self.pixel.position.to_array();
        let points = self.points.map(|p| format!("({}, {})", p.x, p.y)).join(", ");
        let bounces = tracer.method.bounces.end();
        format!("`trace` with at most {bounces} bounces, of the pixel at ({x}, {y}) with the points {points}")
    }
}

/// Accept paths, or name what is wrong with them.
pub(super) fn check(trace: Trace) -> Verdict {
    let questions: Vec<_> = (0..60).map(Question::number).collect();
    let tracer = garden::tracer(0..=4);
    if questions.iter().all(|question| question.ask(trace, &tracer, 0) == Rgb::ZERO) {
        let message = "`path_points` is right. Now for `trace`, whose paths bring no light at all.";
        return Err(Diagnosis::new("trace-not-started", message));
    }
    // Up to two bounces nothing is left to the stream.
    (0..=2).try_for_each(|most| as_told(trace, &questions, most))?;
    by_chance(trace, &questions)
}

/// Paths of so few bounces that their points decide all.
fn as_told(trace: Trace, questions: &[Question], most: u32) -> Verdict {
    let tracer = garden::tracer(0..=most);
    let is = |question: &Question, recipe: &Recipe| {
        let expected = recipe.trace(&tracer, question, &mut Stream::new(70, 0, 0));
        (question.ask(trace, &tracer, 0) - expected).abs().max_element() <= 1e-4
    };
    let Some(question) = questions.iter().find(|question| !is(question, &RIGHT)) else { return Ok(()) };
    let strays = questions.iter().any(|question| question.ask(trace, &tracer, 0) != question.ask(trace, &tracer, 1));
    let rival = RIVALS.iter().find(|(recipe, _)| questions.iter().all(|question| is(question, recipe)));
    let (name, advice) = match rival {
        Some((_, mistake)) => *mistake,
        None if strays && most == 0 => mistakes::PIXEL_BY_CHANCE,
        None if strays => mistakes::BY_CHANCE,
        None => mistakes::WRONG_PATH,
    };
    let (got, expected) = (question.ask(trace, &tracer, 0), RIGHT.trace(&tracer, question, &mut Stream::new(70, 0, 0)));
    let tried = question.words(&tracer);
    let told = |radiance: Rgb| rounded(radiance.as_dvec3());
    Err(Finding { tried, got: told(got), expected: told(expected), advice: advice.into() }.named(name))
}

/// Paths that go on by chance.
fn by_chance(trace: Trace, questions: &[Question]) -> Verdict {
    // Light of fewer bounces would only drown that of the others.
    let tracer = garden::tracer(3..=6);
    let [mut ours, mut theirs] = [Estimate::default(); 2];
    let mut is_random = false;
    // Those that see the sky at once teach nothing.
    let deep = questions.iter().filter(|question| question.ask(trace, &garden::tracer(0..=0), 0) == Rgb::ZERO);
    for (question, seed) in deep.flat_map(|question| (0..400).map(move |seed| (question, seed))) {
        let got = question.ask(trace, &tracer, seed);
        is_random |= got != question.ask(trace, &tracer, seed + 1);
        theirs.add(luminance(got).into());
        ours.add(luminance(RIGHT.trace(&tracer, question, &mut Stream::new(71, seed, 0))).into());
    }
    let three_sigma = (ours.three_sigma() * ours.three_sigma() + theirs.three_sigma() * theirs.three_sigma()).sqrt();
    // What is no number is not near either.
    let is_near = (ours.mean() - theirs.mean()).abs() <= 1.5 * three_sigma;
    let (name, advice) = if !is_random {
        mistakes::REST_NOT_RANDOM
    } else if !is_near {
        mistakes::REST_BIASED
    } else {
        return Ok(());
    };
    let told = |estimate: Estimate| format!("on average {:.4}", estimate.mean());
    Err(Finding {
        tried: "`trace` of light that was reflected three to six times, with many streams".into(),
        got: if is_random { told(theirs) } else { "the same radiance with every stream".into() },
        expected: format!("{} ± {three_sigma:.4}, and another radiance with each stream", told(ours)),
        advice: advice.into(),
    }
    .named(name))
}
