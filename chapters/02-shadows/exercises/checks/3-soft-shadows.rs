//! Checks exercise 2.3, soft shadows.

use common::{
    Rgb, Vec2, Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use glam::DVec3;
use ray_casting::{hit::Hit, ray::Ray, scene::Scene};

use super::{
    blockers::Blockers,
    panel::{Question, RIGHT},
    panel_mistakes::{HIDDEN, LIGHT, Mistake, PLACES, SHADOWS},
    words,
};

/// Not the name of a mistake: what came out is of no known kind.
const OTHER: &str = "other";

/// An answer in words.
fn told((visible, irradiance): (f64, DVec3)) -> String {
    format!("visible {}, irradiance {}", words::number(visible), words::rounded(irradiance))
}

/// The function under test.
struct Trial<F>(F);

impl<F: Fn([Vec3; 3], Rgb, &Scene<()>, &Hit, u16, &[Vec2]) -> (f32, Rgb)> Trial<F> {
    fn answer(&self, question: &Question) -> (f64, DVec3) {
        let Question { blockers, hit, panel, radiance, n, jitter } = question;
        let scene = blockers.scene(());
        let (visible, irradiance) =
            trying(|| question.tried(), || (self.0)(*panel, *radiance, &scene, hit, *n, jitter));
        (f64::from(visible), irradiance.as_dvec3())
    }

    /// The mistake, if the answer is wrong: the known one that gives what came out, or the one of that name.
    fn ask(&self, question: &Question, known: &[&[Mistake]], name: &'static str, advice: &str) -> Verdict {
        let Some(expected) = question.value(&RIGHT) else { return Ok(()) };
        let got = self.answer(question);
        let is = |(visible, irradiance): (f64, DVec3)| {
            let size = irradiance.max_element().max(1e-6);
            (got.0 - visible).abs() < 1e-4 && (got.1 - irradiance).abs().max_element() < 1e-3 * size
        };
        if is(expected) {
            return Ok(());
        }
        // Some mistakes come to nearly the same: the nearest is it.
        let fits = |mistake| {
            let (_, recipe, _): &Mistake = mistake;
            question.value(recipe).filter(|value| is(*value)).map(|value| (mistake, value.1.distance(got.1)))
        };
        let known = known.iter().copied().flatten().chain(&HIDDEN).filter_map(fits);
        let known = known.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(mistake, _)| mistake);
        let is_gray = got.1 == DVec3::splat(got.1.x) && expected.1 != DVec3::splat(expected.1.x);
        let (name, advice) = if !got.0.is_finite() || !got.1.is_finite() {
            ("not-a-number", "Something was divided by zero, or a vector of length zero was normalized.")
        } else if let Some((name, _, advice)) = known {
            (*name, *advice)
        } else if got.1.max_element() > 0.0 && is_gray {
            (
                "one-channel",
                "All three channels are the same, but those of the radiance differ. Compute with the whole `Rgb`.",
            )
        } else if name != OTHER && got.0 > 1.0001 {
            ("not-a-share", "`visible` is a share of the places, and no share is above 1. Divide by n·n.")
        } else {
            (name, advice)
        };
        let places = question.places().map(|places| format!(", from the {places}")).unwrap_or_default();
        Err(Finding {
            tried: question.tried(),
            got: told(got),
            expected: format!("{}{places}", told(expected)),
            advice: advice.into(),
        }
        .named(name))
    }

    /// Name one of the known mistakes, if it gives what came out; pass over all others.
    fn known(&self, question: &Question, known: &[&[Mistake]]) -> Verdict {
        self.ask(question, known, OTHER, "").or_else(|diagnosis| match diagnosis.name {
            OTHER => Ok(()),
            _ => Err(diagnosis),
        })
    }

    /// Ask for one particular mistake.
    fn probe(&self, question: &Question, name: &'static str, advice: &str) -> Verdict {
        self.ask(question, &[], name, advice)
    }
}

const RADIANCE: Rgb = Rgb::new(2.0, 4.0, 8.0);

/// A panel over the origin of space that shines downward.
const OVERHEAD: [Vec3; 3] = [Vec3::new(-1.0, 2.0, -0.5), Vec3::X, Vec3::Z];

/// A panel beside it that leans.
const LEANING: [Vec3; 3] = [Vec3::new(1.0, 1.2, -0.9), Vec3::new(0.0, 0.3, 1.8), Vec3::new(-0.4, 1.2, 0.0)];

const MIDDLE: Vec2 = Vec2::splat(0.5);

/// A question about the floor, in the origin of space.
fn on_floor(balls: &[(Vec3, f32)], panel: [Vec3; 3], n: u16, jitter: &[Vec2]) -> Question {
    on_floor_at(Vec3::ZERO, balls, panel, n, jitter)
}

/// A question about the floor at some place.
fn on_floor_at(place: Vec3, balls: &[(Vec3, f32)], panel: [Vec3; 3], n: u16, jitter: &[Vec2]) -> Question {
    let blockers = Blockers::on_floor(balls);
    // A hit of a floor that is there: at height 0, its normal upward.
    let down = Ray::new(place + Vec3::Y * 0.1, -Vec3::Y);
    let hit = blockers.hit(&down).unwrap_or_else(|| Hit::new(&down, 0.1, Vec3::Y));
    Question { blockers, hit, panel, radiance: RADIANCE, n, jitter: jitter.to_vec() }
}

/// Four entries, all different.
const FOUR: [Vec2; 4] = [Vec2::new(0.1, 0.2), Vec2::new(0.9, 0.3), Vec2::new(0.3, 0.9), Vec2::new(0.6, 0.7)];

/// Accept a panel, or name what is wrong with it.
pub(crate) fn check(light: impl Fn([Vec3; 3], Rgb, &Scene<()>, &Hit, u16, &[Vec2]) -> (f32, Rgb)) -> Verdict {
    // Behind references: so all answers share one copy of the steps.
    steps(&light)
}

/// An answer.
type SoftLight<'f> = &'f dyn Fn([Vec3; 3], Rgb, &Scene<()>, &Hit, u16, &[Vec2]) -> (f32, Rgb);

/// The steps of the check.
fn steps(light: SoftLight<'_>) -> Verdict {
    let trial = Trial(light);
    let plain = on_floor(&[], OVERHEAD, 1, &[MIDDLE]);
    let leaning = on_floor_at(Vec3::new(-0.5, 0.0, 0.25), &[], LEANING, 2, &FOUR);
    dark(&trial, &[&plain, &leaning])?;
    // What is known by what comes out, where no two mistakes look alike; then step by step.
    trial.known(&leaning, &[&PLACES, &LIGHT])?;
    let advice = "One place in the middle of the panel, and nothing in the way. Work it out on paper: the place from u, v and \
                  the corner, then area, distance, and both cosines.";
    trial.ask(&plain, &[&LIGHT], "wrong-light", advice)?;
    let advice = "One place, and nothing in the way, but the panel leans, and the place is not in its middle. Work it out on \
                  paper: the place from u, v and the corner, then area, distance, and both cosines.";
    trial.ask(&on_floor(&[], LEANING, 1, &[Vec2::new(0.2, 0.7)]), &[&LIGHT], "wrong-light", advice)?;
    let advice = "Four places, and nothing in the way. Work them out on paper, one by one: u and v, the place, what it gives; \
                  and then the mean, over n·n.";
    trial.probe(&leaning, "wrong-places", advice)?;
    shadows(&trial)?;
    horizons(&trial)?;
    let flat = on_floor(&[], [OVERHEAD[0], Vec3::X, Vec3::X * 2.0], 2, &FOUR);
    let advice = "The edges of this panel are parallel. It has no area, and from it no light arrives.";
    trial.probe(&flat, "no-area", advice)?;
    normals(&trial)?;
    offsets(&trial)?;
    integral(&trial)?;

    // Many panels.
    let mut dice = Dice::new(23);
    for _ in 0..400 {
        let ball = |dice: &mut Dice| (dice.point(1.0) + Vec3::Y * 1.4, dice.choice([0.1, 0.2, 0.4]));
        let balls = [(); 2].map(|()| ball(&mut dice));
        let panel = [dice.point(2.0) + Vec3::Y * 3.0, dice.direction(), dice.direction()];
        let n = dice.choice([1, 2, 3]);
        let jitter: Vec<_> = (0..n * n).map(|_| Vec2::new(dice.number(0.0, 0.99), dice.number(0.0, 0.99))).collect();
        let advice = "Work these places out on paper, one by one.";
        trial.probe(&on_floor(&balls, panel, n, &jitter), "wrong-answer", advice)?;
    }
    Ok(())
}

/// Nothing arrives, where something should: has nobody begun, or is a sign turned?
fn dark<F>(trial: &Trial<F>, questions: &[&Question]) -> Verdict
where
    F: Fn([Vec3; 3], Rgb, &Scene<()>, &Hit, u16, &[Vec2]) -> (f32, Rgb),
{
    let is_dark = |question: &Question| trial.answer(question) == (0.0, DVec3::ZERO);
    let Some(first) = questions.first().filter(|_| questions.iter().all(|q| is_dark(q))) else { return Ok(()) };
    let [corner, one, other] = OVERHEAD;
    let below = corner - Vec3::Y * 4.0;
    let alone = |panel| Question { blockers: Blockers::in_space(&[]), panel, ..(*first).clone() };
    // What gives light instead tells the mistake.
    let others = [
        (
            "sign-of-the-front",
            alone([corner, other, one]),
            "Nothing arrives from this panel, but something does when its back is turned to the point. Is a sign turned? The front \
             is the side to which `edges[0] × edges[1]` points, in this order, and its cosine is that of −ω: \
             `-direction.dot(area)`.",
        ),
        (
            "sign-of-the-way",
            alone([below, one, other]),
            "Nothing arrives from this panel, but something does when it lies below the surface. Is ω turned round? It points from \
             the surface to the light: place − `hit.position`.",
        ),
        (
            "sign-of-the-horizon",
            alone([below, other, one]),
            "Nothing arrives from this panel, but something does from below the horizon. Is the sign of the cosine at the surface \
             turned? It is N·ω, where ω points from the surface to the light.",
        ),
        (
            "shadow-turned",
            on_floor(&[(Vec3::new(-0.25, 1.0, 0.0), 0.8)], OVERHEAD, 1, &[MIDDLE]),
            "Nothing arrives from this panel, but something does when a ball hides it. Is there a `!` too few or too many? A place \
             counts if it is not in shadow.",
        ),
    ];
    for (name, question, advice) in others {
        if !is_dark(&question) {
            let expected = first.value(&RIGHT).map(told).unwrap_or_default();
            let got = told((0.0, DVec3::ZERO));
            return Err(Finding { tried: first.tried(), got, expected, advice: advice.into() }.named(name));
        }
    }
    // A place that is left out gives light somewhere else.
    let all_dark = questions.iter().all(|q| is_dark(&Question { blockers: Blockers::in_space(&[]), ..(*q).clone() }));
    if all_dark {
        return Err(Diagnosis::not_started("Your panel is dark: `light` returns nothing anywhere."));
    }
    Ok(())
}

/// What hides what.
fn shadows<F>(trial: &Trial<F>) -> Verdict
where
    F: Fn([Vec3; 3], Rgb, &Scene<()>, &Hit, u16, &[Vec2]) -> (f32, Rgb),
{
    // A ball in front of one place, and one behind another.
    let places = FOUR.iter().zip([(0, 0), (1, 0), (0, 1), (1, 1)]).map(|(jitter, (column, row))| {
        let share = (Vec2::new(f32::from(column as u8), f32::from(row as u8)) + *jitter) / 2.0;
        LEANING[0] + LEANING[1] * share.x + LEANING[2] * share.y
    });
    let places: Vec<_> = places.collect();
    let advice = "A ball stands before one place on the panel, and another one behind. Find out for each place by itself \
                  whether it is seen.";
    let middle = LEANING[0] + (LEANING[1] + LEANING[2]) / 2.0;
    let between = on_floor(&[(middle * 0.4, 0.06)], LEANING, 2, &FOUR);
    let beside = "A small ball stands before the middle of the panel, and hides none of the four places.";
    trial.ask(&between, &[&SHADOWS, &PLACES], "wrong-shadow", beside)?;
    for (before, near, behind, far) in [(0, 0.3, 3, 4.0), (0, 0.6, 3, 1.3), (2, 0.6, 1, 1.3), (3, 0.6, 0, 1.3)] {
        let balls = [(places[before] * near, 0.06), (places[behind] * far, 0.06)];
        trial.ask(&on_floor(&balls, LEANING, 2, &FOUR), &[&SHADOWS, &PLACES], "wrong-shadow", advice)?;
    }
    let advice = "A ball hides all of the panel here. No light arrives.";
    trial.ask(&on_floor(&[(Vec3::new(-0.25, 1.0, 0.0), 0.8)], OVERHEAD, 2, &FOUR), &[&SHADOWS], "no-shadow", advice)?;
    let advice = "A ball stands behind the panel. It casts no shadow here.";
    trial.ask(
        &on_floor(&[(Vec3::new(-0.8, 4.0, 0.0), 1.5)], OVERHEAD, 2, &FOUR),
        &[&SHADOWS],
        "beyond-the-light",
        advice,
    )
}

/// Behind the panel and below the horizon.
fn horizons<F>(trial: &Trial<F>) -> Verdict
where
    F: Fn([Vec3; 3], Rgb, &Scene<()>, &Hit, u16, &[Vec2]) -> (f32, Rgb),
{
    let [corner, first, second] = OVERHEAD;
    let advice = "This panel shines upward, away from the surface. It shines on one side only, the one to which \
                  `edges[0] × edges[1]` points. From behind neither light arrives nor is any place seen.";
    trial.probe(&on_floor(&[], [corner, second, first], 2, &FOUR), "shines-backwards", advice)?;
    let advice = "A part of this panel lies below the horizon of the surface, where N·ω is negative. From there no light arrives, \
                  no negative light either, and such places are not seen.";
    let upright = [Vec3::new(2.0, -1.0, -1.0), Vec3::Z * 2.0, Vec3::Y * 3.0];
    let sunk = on_floor(&[], upright, 2, &FOUR);
    trial.probe(&sunk, "below-horizon", advice)?;
    // The same without a floor that would hide what is below.
    let slope = Blockers::in_space(&[(Vec3::new(0.0, -1.0, 0.0), 1.0)]);
    trial.probe(&Question { blockers: slope, ..sunk.clone() }, "below-horizon", advice)?;
    trial.probe(&Question { blockers: Blockers::in_space(&[]), ..sunk.clone() }, "below-horizon", advice)?;
    let advice = "A part of this panel lies below the horizon of the surface, and its back is turned to the point. No light \
                  arrives from any of it. Ask for both signs by themselves.";
    let turned = [upright[0], upright[2], upright[1]];
    trial.probe(&Question { blockers: Blockers::in_space(&[]), panel: turned, ..sunk }, "both-behind", advice)
}

/// Normals for shading that are not those of the surface.
fn normals<F>(trial: &Trial<F>) -> Verdict
where
    F: Fn([Vec3; 3], Rgb, &Scene<()>, &Hit, u16, &[Vec2]) -> (f32, Rgb),
{
    let question = on_floor(&[], LEANING, 2, &FOUR);
    for leaning in [Vec3::new(0.6, 0.8, 0.0), Vec3::new(-0.6, 0.64, 0.48)] {
        let hit = Hit { shading_normal: leaning, ..question.hit };
        let advice = "At this hit the shading normal is another one than the geometric normal. N, with which brightness is \
                      computed, is the shading normal.";
        trial.probe(&Question { hit, ..question.clone() }, "geometric-normal", advice)?;
    }
    Ok(())
}

/// Shadow rays must leave the surface, wherever it is.
fn offsets<F>(trial: &Trial<F>) -> Verdict
where
    F: Fn([Vec3; 3], Rgb, &Scene<()>, &Hit, u16, &[Vec2]) -> (f32, Rgb),
{
    let mut dice = Dice::new(123);
    for (k, name, advice) in [
        (
            3.0,
            "self-shadow",
            "There is nothing but one ball here, so that all places above the horizon are seen. A ray that starts on the \
             surface itself hits it at once. `is_in_shadow` starts a little above it.",
        ),
        (
            1e5,
            "fixed-offset",
            "There is nothing but one ball here, so that all places above the horizon are seen. But its numbers are great, and \
             so are their rounding errors. An offset that does not grow with them is lost: `Offset::Following` does.",
        ),
    ] {
        let center = Vec3::splat(k);
        let panel = [center + Vec3::new(-2.0, 6.0, -2.0), Vec3::X * 4.0, Vec3::Z * 4.0];
        for _ in 0..300 {
            let blockers = Blockers::in_space(&[(center, 1.0)]);
            let origin = center + Vec3::Y * 4.0 + dice.point(1.0);
            let ray = Ray::new(origin, center + dice.point(0.6) - origin);
            let Some(hit) = blockers.hit(&ray) else { continue };
            let question = Question { blockers, hit, panel, radiance: RADIANCE, n: 2, jitter: FOUR.to_vec() };
            let Some((expected, irradiance)) = question.value(&RIGHT) else { continue };
            let (got, _) = trial.answer(&question);
            // Only what is seen is compared: among great numbers the light is not accurate.
            if (got - expected).abs() > 1e-4 || got.is_nan() {
                return Err(Finding {
                    tried: question.tried(),
                    got: format!("visible {}", words::number(got)),
                    expected: format!(
                        "visible {}, about irradiance {}",
                        words::number(expected),
                        words::rounded(irradiance)
                    ),
                    advice: advice.into(),
                }
                .named(name));
            }
        }
    }
    // Two grains of dust nearly touch, and one hides the whole panel from the other.
    let grains = Blockers::in_space(&[(Vec3::ZERO, 1e-3), (Vec3::new(0.0, 2.05e-3, 0.0), 1e-3)]);
    let ray = Ray::new(Vec3::new(4e-3, 1.02e-3, 0.0), Vec3::new(-4e-3, -0.1e-3, 0.0));
    let Some(hit) = grains.hit(&ray) else { return Ok(()) };
    let question = Question { blockers: grains, hit, panel: OVERHEAD, radiance: RADIANCE, n: 2, jitter: FOUR.to_vec() };
    let advice = "Two grains of dust nearly touch here, and one hides the panel from the other. A fixed offset jumps from the one to \
                  behind the surface of the other: the offset must follow the numbers. `Offset::Following` does.";
    trial.probe(&question, "fixed-offset", advice)
}

/// Many places come near to the closed form, and few places are right in the mean.
fn integral<F>(trial: &Trial<F>) -> Verdict
where
    F: Fn([Vec3; 3], Rgb, &Scene<()>, &Hit, u16, &[Vec2]) -> (f32, Rgb),
{
    const MANY: u16 = 40;
    // An upright panel that is half sunk: only the upper half gives light.
    let sunk = [Vec3::new(2.0, -1.0, -1.0), Vec3::Z * 2.0, Vec3::Y * 2.0];
    let risen = [Vec3::new(2.0, 0.0, -1.0), Vec3::Z * 2.0, Vec3::Y];
    for (panel, above, share) in [(OVERHEAD, OVERHEAD, 1.0), (LEANING, LEANING, 1.0), (sunk, risen, 0.5)] {
        let expected = on_floor(&[], above, 1, &[MIDDLE]).closed_form();
        let compare = |question: &Question, visible: f64, got: DVec3, slack: f64, how: &str| {
            if (got - expected).abs().max_element() < slack * expected.max_element() && (visible - share).abs() < 0.02 {
                return Ok(());
            }
            let told = |visible: f64, irradiance| {
                format!("visible {}, irradiance {}", words::number(visible), words::rounded(irradiance))
            };
            Err(Finding {
                tried: question.tried(),
                got: told(visible, got),
                expected: format!("about {}", told(share, expected)),
                advice: format!(
                    "{how} must come near to what the whole panel gives, and do not. Do the places cover all of it?"
                ),
            }
            .named("not-the-integral"))
        };
        let fine = on_floor(&[], panel, MANY, &vec![MIDDLE; usize::from(MANY) * usize::from(MANY)]);
        let (visible, got) = trial.answer(&fine);
        compare(&fine, visible, got, 2e-3, "Many places")?;
        // The mean over many jitters.
        let mut dice = Dice::new(223);
        let mut sum = (0.0, DVec3::ZERO);
        const TIMES: u16 = 4000;
        let mut question = on_floor(&[], panel, 2, &FOUR);
        for _ in 0..TIMES {
            // Numbers from 0 to 1: the middle of all hundredths.
            question.jitter =
                (0..4).map(|_| Vec2::new(dice.number(0.0, 0.99), dice.number(0.0, 0.99)) + 0.005).collect();
            let (visible, irradiance) = trial.answer(&question);
            sum = (sum.0 + visible, sum.1 + irradiance);
        }
        compare(
            &question,
            sum.0 / f64::from(TIMES),
            sum.1 / f64::from(TIMES),
            1e-2,
            "Few places, in the mean over many jitters,",
        )?;
    }
    Ok(())
}
