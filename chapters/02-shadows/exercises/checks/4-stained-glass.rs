//! Checks exercise 2.4, stained glass.

use std::sync::{
    Arc,
    atomic::{AtomicUsize, Ordering},
};

use common::{
    Interval, Rgb, Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use glam::DVec3;
use ray_casting::{
    hit::Hit,
    light::{Illumination, Light as _, PointLight},
    ray::Ray,
    scene::Scene,
    shape::Shape,
    sphere::Sphere,
};

use super::{
    pane_mistakes::{Crossing, MISTAKES, Mistake, Recipe, right},
    words,
};

/// Level panes without end, one or more of the same glass, which make one object.
#[derive(Clone)]
struct Panes {
    heights: Vec<f32>,
    transmittance: Rgb,
}

/// The same as a shape that counts how often it is asked. After too many questions it says no, so that no loop is endless.
struct Counted {
    heights: Vec<f32>,
    asked: Arc<AtomicUsize>,
}

/// Whether that surface of an object is turned downward: every other one, beginning with the first.
fn is_turned(number: usize) -> bool {
    number.is_multiple_of(2)
}

/// More questions than any sound loop asks for.
const TOO_OFTEN: usize = 1_000_000;

impl Shape for Counted {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        if self.asked.fetch_add(1, Ordering::Relaxed) > TOO_OFTEN {
            return None;
        }
        let crossings = self.heights.iter().map(|height| (height - ray.origin.y) / ray.direction.y).zip(0..);
        let nearest = crossings.filter(|(t, _)| range.contains(*t)).min_by(|a, b| a.0.total_cmp(&b.0));
        nearest.map(|(t, number)| Hit::new(ray, t, if is_turned(number) { -Vec3::Y } else { Vec3::Y }))
    }
}

/// A question: how much light comes through?
#[derive(Clone)]
struct Question {
    /// Radius and center of the opaque ball that is lit, or `None` for an opaque floor at height 0.
    ball: Option<Sphere>,
    hit: Hit,
    panes: Vec<Panes>,
    light: Illumination,
}

impl Question {
    /// The floor under panes, with a light in some direction.
    fn on_floor(panes: &[Panes], toward: Vec3, distance: f32) -> Self {
        let ray = Ray::new(Vec3::new(0.1, 1.0, 0.2), -Vec3::Y);
        let light = Illumination { direction: toward.normalize(), distance, strength: STRENGTH };
        Self { ball: None, hit: Hit::new(&ray, 1.0, Vec3::Y), panes: panes.to_vec(), light }
    }

    /// The scene, and how often its panes have been asked.
    fn scene(&self) -> (Scene<Rgb>, Arc<AtomicUsize>) {
        let asked = Arc::new(AtomicUsize::new(0));
        let mut scene = Scene::new();
        for Panes { heights, transmittance } in &self.panes {
            scene.add("glass", Counted { heights: heights.clone(), asked: Arc::clone(&asked) }, *transmittance);
        }
        match self.ball {
            Some(ball) => scene.add("ball", ball, Rgb::ZERO),
            None => scene.add("floor", Counted { heights: vec![0.0], asked: Arc::clone(&asked) }, Rgb::ZERO),
        };
        (scene, asked)
    }

    /// What comes out by a recipe. The thing that is lit does not hide itself.
    fn value(&self, recipe: Recipe) -> DVec3 {
        let (from, rise) = (f64::from(self.hit.position.y), f64::from(self.light.direction.y));
        let crossings = self.panes.iter().enumerate().flat_map(|(object, panes)| {
            let transmittance = panes.transmittance.as_dvec3();
            let heights = panes.heights.iter().zip(0..);
            heights.map(move |(h, number)| {
                let t = (f64::from(*h) - from) / rise;
                Crossing { t, transmittance, object, is_turned: is_turned(number) }
            })
        });
        recipe(&crossings.collect::<Vec<_>>(), f64::from(self.light.distance))
    }

    fn tried(&self) -> String {
        let thing = self.ball.map_or("an opaque floor at y = 0".into(), |ball| {
            format!("the opaque sphere around {} with radius {}", words::triple(ball.center), ball.radius)
        });
        let panes = self.panes.iter().map(|Panes { heights, transmittance }| {
            let heights: Vec<_> = heights.iter().take(5).map(|h| format!("y = {h}")).collect();
            let glass = if *transmittance == Rgb::ZERO {
                "an opaque level plane".into()
            } else {
                format!("a level pane of transmittance {}", words::triple(*transmittance))
            };
            format!("{glass} at {}", heights.join(" and "))
        });
        const TOLD: usize = 6;
        let mut told: Vec<_> = panes.take(TOLD).collect();
        let heights: usize = self.panes.iter().map(|p| p.heights.len()).sum();
        if heights > 8 || self.panes.len() > TOLD {
            told.push(format!("so on, {heights} panes in all"));
        }
        if told.is_empty() {
            told.push("no glass".into());
        }
        let Illumination { direction, distance, .. } = self.light;
        let distance = if distance.is_finite() { distance.to_string() } else { "∞".into() };
        let light = format!("light in direction {} at distance {distance}", words::triple(direction));
        let leaning = if self.hit.shading_normal == self.hit.geometric_normal {
            String::new()
        } else {
            format!(" and shading normal {}", words::triple(self.hit.shading_normal))
        };
        format!("{}{leaning} on {thing}, {light}, {}", words::hit(&self.hit), told.join(", "))
    }
}

/// Name and advice for a loop without end.
const ENDLESS: (&str, &str) = (
    "endless",
    "The scene was asked a million times, and there would have been no end. Does the loop find the same pane again and again? Let \
     the range begin at the last hit: `range.min = hit.t`.",
);
const NO_END: &str = "no end";

/// The function under test.
struct Trial<F>(F);

impl<F: Fn(&Scene<Rgb>, &Hit, &Illumination) -> Rgb> Trial<F> {
    /// The answer, and whether it was found in reasonable time.
    fn answer(&self, question: &Question) -> (DVec3, bool) {
        let (scene, asked) = question.scene();
        let answer = trying(|| question.tried(), || (self.0)(&scene, &question.hit, &question.light));
        (answer.as_dvec3(), asked.load(Ordering::Relaxed) <= TOO_OFTEN)
    }

    /// The mistake, if the answer is wrong: the known one that gives what came out, or the one of that name.
    fn ask(&self, question: &Question, known: &[Mistake], name: &'static str, advice: &str) -> Verdict {
        let (got, has_ended) = self.answer(question);
        let expected = question.value(right);
        let is = |value: DVec3| (got - value).abs().max_element() < 1e-4 * value.max_element().max(1e-3);
        // What is opaque lets nothing through at all.
        let is_right = is(expected) && (expected != DVec3::ZERO || got == DVec3::ZERO);
        if has_ended && is_right {
            return Ok(());
        }
        let known = known.iter().find(|(_, recipe, _)| is(question.value(*recipe)));
        let strength = question.light.strength.as_dvec3();
        let (name, advice) = if !has_ended {
            ENDLESS
        } else if got.is_nan() {
            ("not-a-number", "Where does a NaN come from? Is something divided by zero, or 0 multiplied by infinity?")
        } else if let Some((name, _, advice)) = known {
            (*name, *advice)
        } else if expected != DVec3::ZERO && is(expected * strength) {
            (
                "times-strength",
                "The answer is multiplied by `light.strength` here. A share of the light is asked for, 0 to 1: whoever calls this \
                 function multiplies.",
            )
        } else {
            (name, advice)
        };
        Err(Finding {
            tried: question.tried(),
            got: if has_ended { words::rounded(got) } else { NO_END.into() },
            expected: words::rounded(expected),
            advice: advice.into(),
        }
        .named(name))
    }

    /// Ask for one particular mistake.
    fn probe(&self, question: &Question, name: &'static str, advice: &str) -> Verdict {
        self.ask(question, &[], name, advice)
    }
}

fn pane(height: f32, transmittance: Rgb) -> Panes {
    Panes { heights: vec![height], transmittance }
}

/// What arrives from the light without glass. It is not asked for.
const STRENGTH: Rgb = Rgb::new(2.0, 3.0, 5.0);
const RED: Rgb = Rgb::new(0.8, 0.3, 0.1);
const GREEN: Rgb = Rgb::new(0.4, 0.9, 0.3);
const BLUE: Rgb = Rgb::new(0.2, 0.5, 0.7);
const CLEAR: Rgb = Rgb::ONE;
const OPAQUE: Rgb = Rgb::ZERO;

/// Height of the lower of two panes that nearly touch.
const CLOSE: f32 = 0.001;

/// Where most lights are: not straight above, so that distances are not heights.
const SLANTING: Vec3 = Vec3::new(0.6, 0.8, 0.0);

/// Accept a function, or name what is wrong with it.
pub(crate) fn check(light_through: impl Fn(&Scene<Rgb>, &Hit, &Illumination) -> Rgb) -> Verdict {
    // Behind references: so all answers share one copy of the steps.
    steps(&light_through)
}

/// The steps of the check.
fn steps(light_through: &dyn Fn(&Scene<Rgb>, &Hit, &Illumination) -> Rgb) -> Verdict {
    let trial = Trial(light_through);
    let floor = |panes: &[Panes]| Question::on_floor(panes, SLANTING, 10.0);
    let (free, red) = (floor(&[]), floor(&[pane(1.0, RED)]));
    let clear = floor(&[pane(1.0, CLEAR)]);
    let is_brick = [&red, &clear].iter().all(|question| trial.answer(question) == (DVec3::ZERO, true));
    if trial.answer(&free).0 == DVec3::ONE && is_brick {
        return Err(Diagnosis::not_started(
            "Glass still casts the shadow of a brick: `light_through` lets nothing through where a pane is in the way.",
        ));
    }
    let advice = "Nothing is between the point and the light. All of it arrives.";
    trial.probe(&free, "free-way", advice)?;
    // What is known by what comes out, where no two mistakes look alike.
    let many = [
        pane(2.0, GREEN),
        Panes { heights: vec![2.5, 1.5, 2.8], transmittance: BLUE },
        pane(1.0, RED),
        pane(3.0, Rgb::new(0.6, 0.4, 0.8)),
        pane(9.0, Rgb::new(0.9, 0.2, 0.4)),
        pane(-1.0, Rgb::new(0.7, 0.6, 0.2)),
    ];
    let advice = "Multiply the transmittances of all panes between the floor and the light, one factor for each time that the \
                  ray meets a surface.";
    trial.ask(&floor(&many), &MISTAKES, "wrong-product", advice)?;
    trial.ask(&red, &MISTAKES, "one-pane", "One pane is in the way. What arrives is its transmittance.")?;
    distances(&trial)?;
    opaque(&trial)?;
    let advice = "These are the same panes as before, and only their order in the scene has changed. A product does not ask for \
                  the order.";
    for turn in 0..many.len() {
        let mut turned = many.clone();
        turned.rotate_left(turn);
        trial.probe(&floor(&turned), "order-matters", advice)?;
    }
    many_panes(&trial)?;
    degenerate(&trial)?;
    offsets(&trial)?;

    // Many scenes.
    let mut dice = Dice::new(24);
    for _ in 0..500 {
        let panes = [(); 4].map(|()| {
            // Within one object each height comes once: nobody can meet the same surface twice in one place.
            let (least, apart) = (dice.number(-2.0, 4.0), dice.number(0.1, 2.0));
            let heights = [0.0, 1.0, 2.0].map(|i| least + apart * i);
            let count = dice.choice([1, 1, 2, 3]);
            let transmittance = dice.choice([RED, GREEN, BLUE, CLEAR, RED, GREEN, OPAQUE]);
            Panes { heights: heights[..count].to_vec(), transmittance }
        });
        let toward = dice.direction();
        let question = Question::on_floor(&panes, toward.with_y(toward.y.abs() + 0.2), dice.number(0.5, 9.0));
        let reach = question.light.direction.y * question.light.distance;
        let is_fair = |h: &f32| h.abs() > 0.005 && (h - reach).abs() > 0.005;
        if panes.iter().flat_map(|p| &p.heights).all(is_fair) {
            trial.probe(
                &question,
                "wrong-answer",
                "Work this out on paper: which panes lie between, and what is their product?",
            )?;
        }
    }
    Ok(())
}

/// Behind the point and beyond the light.
fn distances<F: Fn(&Scene<Rgb>, &Hit, &Illumination) -> Rgb>(trial: &Trial<F>) -> Verdict {
    let ask = |panes: &[Panes], distance, name, advice| {
        trial.probe(&Question::on_floor(panes, SLANTING, distance), name, advice)
    };
    let advice = "What lies beyond the light does not count, be it glass or a wall. The light's distance is measured along the \
                  ray, and is not its height.";
    for beyond in [RED, OPAQUE] {
        ask(&[pane(1.0, GREEN), pane(9.0, beyond)], 10.0, "beyond-the-light", advice)?;
        ask(&[pane(1.0, GREEN)], 1.2, "beyond-the-light", advice)?;
    }
    let advice = "One object has a pane before the light and another one beyond it. Behind a hit, too, the range ends at the \
                  light's distance: change only its beginning, `range.min = hit.t`.";
    ask(&[Panes { heights: vec![1.0, 9.0], transmittance: GREEN }], 10.0, "end-lost", advice)?;
    let advice = "This pane stands just before the light. It counts.";
    ask(&[pane(7.9, GREEN)], 10.0, "before-the-light", advice)?;
    let advice = "What lies below the floor is behind the ray, and does not count.";
    for behind in [RED, OPAQUE] {
        ask(&[pane(1.0, GREEN), pane(-1.0, behind)], 10.0, "behind-the-point", advice)?;
    }
    let advice = "The sun is infinitely far away. All panes in front of the point count.";
    ask(&[pane(1.0, GREEN), pane(1000.0, RED)], f32::INFINITY, "infinite-distance", advice)
}

/// Opaque things.
fn opaque<F: Fn(&Scene<Rgb>, &Hit, &Illumination) -> Rgb>(trial: &Trial<F>) -> Verdict {
    let advice = "Something opaque is in the way. Whatever glass there is too, nothing arrives, to the last bit.";
    let wall = pane(2.0, OPAQUE);
    for panes in [
        vec![wall.clone()],
        vec![pane(1.0, RED), wall.clone()],
        vec![wall.clone(), pane(3.0, RED)],
        vec![pane(3.0, RED), wall.clone()],
        vec![pane(1.0, RED), wall.clone(), pane(3.0, CLEAR)],
    ] {
        trial.probe(&Question::on_floor(&panes, SLANTING, 10.0), "opaque-ignored", advice)?;
    }
    let advice = "Five dark panes leave very little of the light, but more than nothing, and that is the answer. Stop early only when \
                  the product is exactly 0.";
    let dark: Vec<_> = (1..=5_u8).map(|i| pane(f32::from(i), Rgb::splat(0.1))).collect();
    trial.probe(&Question::on_floor(&dark, SLANTING, 10.0), "given-up-early", advice)
}

/// Panes in the same place, close together, and in great numbers.
fn many_panes<F: Fn(&Scene<Rgb>, &Hit, &Illumination) -> Rgb>(trial: &Trial<F>) -> Verdict {
    let ask = |panes: &[Panes], name, advice| trial.probe(&Question::on_floor(panes, SLANTING, 10.0), name, advice);
    let advice = "This object is hit three times. It counts each time, and each time once.";
    ask(&[Panes { heights: vec![1.0, 2.0, 3.0], transmittance: BLUE }], "object-once", advice)?;
    let advice = "Two panes lie in the same place, and are met at the same `t`. Both count. Asked through the \
                  whole scene, the second is lost behind the first: ask every object of `scene.objects` by itself, each with a range of \
                  its own. And `t` alone does not tell two panes apart: a list of what has been found must not skip equal ones.";
    ask(&[pane(1.0, RED), pane(1.0, GREEN)], "same-place", advice)?;
    ask(&[pane(1.0, RED), pane(2.0, BLUE), pane(1.0, RED), pane(2.0, OPAQUE)], "same-place", advice)?;
    let advice = "This pane lies 0.00005 above the point, and is lost. Either the shadow ray starts above the pane: the offset must be \
                  small where numbers are small, as `Offset::Following` is. Or its range begins too late: it begins at 0.";
    ask(&[pane(0.000_05, RED)], "start-too-high", advice)?;
    let advice = "These panes are 0.00005 scene units apart. What you add to go on behind a hit is more than that. The open range \
                  needs nothing of that kind: let it begin at the hit.";
    let close = Panes { heights: vec![1.0, 1.000_05, 1.000_1], transmittance: BLUE };
    ask(&[close, pane(0.000_05, RED)], "fixed-distance", advice)?;
    // A few of the smallest steps of an f32 apart.
    let advice = "These panes are so close together that their `t` differ in the last digits only. Whatever you add to a `t`, or \
                  multiply it with, jumps over some of them. Let the range begin at the hit itself: `range.min = hit.t`.";
    let next = f32::from_bits(CLOSE.to_bits() + 4);
    ask(&[Panes { heights: vec![CLOSE, next], transmittance: BLUE }], "fixed-distance", advice)?;
    let advice =
        "There are 2000 panes here. Is there a fixed limit to their number? Go on until nothing is hit any more.";
    let heights: Vec<_> = (1..=2000_u16).map(|i| f32::from(i) / 512.0).collect();
    let faint = Rgb::new(0.9998, 0.9995, 0.999);
    ask(&[Panes { heights: heights.clone(), transmittance: faint }], "upper-limit", advice)?;
    let single: Vec<_> = heights.iter().map(|h| pane(*h, faint)).collect();
    ask(&single, "upper-limit", advice)
}

/// Clear glass, and a light in the point itself.
fn degenerate<F: Fn(&Scene<Rgb>, &Hit, &Illumination) -> Rgb>(trial: &Trial<F>) -> Verdict {
    let clear = Question::on_floor(&[pane(1.0, CLEAR), pane(2.0, CLEAR)], SLANTING, 10.0);
    trial.probe(&clear, "clear-glass", "Clear glass lets all the light through.")?;
    let advice = "The light stands in the point itself: its direction is a NaN, its distance 0, and nothing is in between. Does \
                  the range end at the distance, and does the loop end when nothing is hit?";
    let mut question = Question::on_floor(&[pane(1.0, RED)], SLANTING, 10.0);
    question.light =
        PointLight { position: question.hit.position, intensity: Rgb::ONE }.illuminate(question.hit.position);
    let (got, has_ended) = trial.answer(&question);
    if got == DVec3::ONE && has_ended {
        return Ok(());
    }
    let (name, advice) = if has_ended { ("light-in-the-point", advice) } else { ENDLESS };
    let got = if has_ended { words::rounded(got) } else { NO_END.into() };
    let expected = words::rounded(DVec3::ONE);
    Err(Finding { tried: question.tried(), got, expected, advice: advice.into() }.named(name))
}

/// Shadow rays must leave the surface, wherever it is.
fn offsets<F: Fn(&Scene<Rgb>, &Hit, &Illumination) -> Rgb>(trial: &Trial<F>) -> Verdict {
    // A shading normal that leans so far that it points a little into the floor.
    let level = Question::on_floor(&[pane(1.0, RED)], SLANTING, 10.0);
    let hit = Hit { shading_normal: Vec3::new(0.96, -0.28, 0.0), ..level.hit };
    let advice = "At this hit the shading normal is another one than the geometric normal, and points into the floor. Shadow rays start \
                  on the side of the geometric normal: `hit.geometric_normal`.";
    trial.probe(&Question { hit, ..level }, "shading-normal", advice)?;
    let mut dice = Dice::new(124);
    for (k, name, advice) in [
        (
            3.0,
            "self-shadow",
            "The lit ball is opaque, and this point of it sees the light through two panes. A ray that starts on the surface \
             itself hits the ball at once: start a little above, `Offset::Following.origin(hit, hit.geometric_normal)`.",
        ),
        (
            1e4,
            "fixed-offset",
            "The lit ball is opaque, and this point of it sees the light through two panes. But its numbers are great, and so \
             are their rounding errors. An offset that does not grow with them is lost: `Offset::Following` does.",
        ),
    ] {
        let ball = Sphere::new(Vec3::splat(k), 1.0);
        let panes = [pane(k + 3.0, RED), Panes { heights: vec![k + 4.0, k + 5.0], transmittance: GREEN }];
        for _ in 0..400 {
            let origin = ball.center + Vec3::Y * 3.0 + dice.point(1.5);
            let ray = Ray::new(origin, ball.center + dice.point(0.6) - origin);
            let light = Illumination { direction: SLANTING, distance: f32::INFINITY, strength: Rgb::ONE };
            let Some(hit) = ball.intersect(&ray, Interval::POSITIVE) else { continue };
            if hit.geometric_normal.dot(light.direction) > 0.05 {
                let question = Question { ball: Some(ball), hit, panes: panes.to_vec(), light };
                trial.probe(&question, name, advice)?;
            }
        }
    }
    Ok(())
}
