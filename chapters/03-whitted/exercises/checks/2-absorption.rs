//! Checks exercise 3.2, thin and thick glass.

use common::{
    Interval, Rgb, Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use ray_casting::{
    camera::Camera,
    hit::{Hit, Side},
    material::Phong,
    ray::Ray,
    scene::Scene,
    sphere::Sphere,
};
use shadows::offset::Offset;
use whitted::{
    branches::{Branch, branches},
    material::{Fresnel, Material},
    probe::Kind,
};

use super::{
    tracer::{Follow, Next, Optics, Tracer},
    words,
};

/// What the student writes.
#[derive(Clone, Copy)]
pub(crate) struct Answer {
    /// σ by the color after one unit.
    pub(crate) coefficient: fn(Rgb) -> Rgb,
    /// The share that is left, by σ and the length of the way.
    pub(crate) transmittance: fn(Rgb, f32) -> Rgb,
    /// The length of the way.
    pub(crate) way: fn(&Branch, Option<&Hit>) -> f32,
    /// σ of what a new ray travels through: by the ray, the side that was hit, σ here and σ inside.
    pub(crate) medium: fn(&Branch, Side, Rgb, Rgb) -> Rgb,
}

/// A surface, and what lies behind it.
#[derive(Clone, Copy)]
pub(crate) struct Glass {
    /// The surface.
    pub(crate) surface: Material,
    /// σ of what lies behind it, in 1/unit.
    pub(crate) absorption: Rgb,
}

impl Optics for Answer {
    type Material = Glass;
    type Medium = Rgb;
    const AIR: Rgb = Rgb::ZERO;

    fn rough(&self, material: &Glass, _hit: &Hit) -> Option<Phong> {
        material.surface.rough
    }

    fn survives(&self, here: Rgb, branch: &Branch, hit: Option<&Hit>) -> Rgb {
        (self.transmittance)(here, (self.way)(branch, hit))
    }

    fn branches(&self, (branch, here): Follow<'_, Rgb>, hit: &Hit, material: &Glass) -> Next<Rgb> {
        let new = branches(&branch.ray, hit, &material.surface, Fresnel::Exact, Offset::Following);
        let [a, b] = new.map(|b| b.map(|b| (b, (self.medium)(&b, hit.side, here, material.absorption))));
        [a, b, None, None]
    }

    fn shines_through(&self, material: &Glass, ray: &Ray, hit: &Hit, way: f32) -> Rgb {
        if !material.surface.refractive {
            return Rgb::ZERO;
        }
        // As much goes out as came in at the same angle: the ray is not bent.
        let cosine = -ray.direction.dot(hit.geometric_normal);
        let through = Rgb::ONE - material.surface.reflectance(cosine, Side::Outside, Fresnel::Exact);
        if hit.side == Side::Inside { through * (self.transmittance)(material.absorption, way) } else { through }
    }
}

#[allow(clippy::disallowed_methods, reason = "the platform's functions are the second opinion here")]
fn exp(x: f64) -> f64 {
    x.exp()
}

#[allow(clippy::disallowed_methods, reason = "the platform's functions are the second opinion here")]
fn ln(x: f64) -> f64 {
    x.ln()
}

/// One channel after the other, in f64.
#[expect(clippy::cast_possible_truncation, reason = "to be compared with f32")]
fn each(color: Rgb, f: impl Fn(f64) -> f64) -> Rgb {
    Rgb::from_array(color.to_array().map(|x| f(f64::from(x)) as f32))
}

/// Name and advice.
type Mistake = (&'static str, &'static str);

/// Accept colored glass, or name what is wrong with it.
pub(crate) fn check(answer: Answer) -> Verdict {
    let sample = Rgb::new(0.9, 0.5, 0.1);
    if (answer.coefficient)(sample) == Rgb::ZERO && (answer.transmittance)(sample, 1.0) == Rgb::ONE {
        let message = "Your glass is clear: `coefficient` is always zero, and `transmittance` always one.";
        return Err(Diagnosis::not_started(message));
    }
    coefficient(answer.coefficient)?;
    transmittance(answer.transmittance)?;
    way(answer.way)?;
    medium(answer.medium)?;
    together(answer)
}

/// A likely mistake: what it makes of one channel, which is `Q`, and what it is called.
type Rival<'a, Q> = (&'a dyn Fn(Q) -> f64, Mistake);

/// One question after the other: what was asked of each channel, in words and in numbers, and what came out.
struct Answered<Q> {
    words: String,
    asked: [Q; 3],
    got: Rgb,
}

impl<Q: Copy> Answered<Q> {
    #[expect(clippy::cast_possible_truncation, reason = "to be compared with f32")]
    fn by(&self, formula: &dyn Fn(Q) -> f64) -> Rgb {
        Rgb::from_array(self.asked.map(|q| formula(q) as f32))
    }

    fn is(&self, formula: &dyn Fn(Q) -> f64) -> bool {
        words::is_near(self.got, self.by(formula), 1e-4)
    }
}

/// Accept the answers, or give the mistake its name: that of the first rival that answers all questions like that.
fn judge<Q: Copy>(
    answers: &[Answered<Q>],
    right: &dyn Fn(Q) -> f64,
    rivals: &[Rival<'_, Q>],
    general: Mistake,
) -> Verdict {
    let Some(wrong) = answers.iter().find(|a| !a.is(right)) else { return Ok(()) };
    let rival = rivals.iter().find(|(formula, _)| answers.iter().all(|a| a.is(formula)));
    let (got, right) = (wrong.got, wrong.by(right));
    let is_gray = |a: &Answered<Q>| a.got.is_finite() && a.got.max_element() - a.got.min_element() < 1e-6;
    // One answer alone tells less than its general name does.
    let is_gray = answers.len() > 1 && answers.iter().all(is_gray) && right.max_element() != right.min_element();
    let gray = is_gray.then_some((
        "one-channel",
        "Your three channels are equal, but they should not be: compute each one by itself.",
    ));
    let nan = (answers.len() > 1 && got.is_nan())
        .then_some(("not-a-number", "This is no number. Was zero multiplied by infinity?"));
    let (name, advice) = rival.map(|(_, mistake)| *mistake).or(nan).or(gray).unwrap_or(general);
    let (tried, got, expected) = (wrong.words.clone(), words::color(got), words::color(right));
    Err(Finding { tried, got, expected, advice: advice.into() }.named(name))
}

fn coefficient(answer: fn(Rgb) -> Rgb) -> Verdict {
    let ask = |color: Rgb| {
        let words = format!("`coefficient` of the color {}", words::triple(color));
        let got = trying(|| words.clone(), || answer(color));
        Answered { words, asked: color.to_array().map(f64::from), got }
    };
    let mut dice = Dice::new(32);
    let fixed = [Rgb::new(0.9, 0.5, 0.1), Rgb::new(0.2, 0.7, 0.4), Rgb::ONE];
    let many: Vec<_> = (0..100).map(|_| Rgb::from_array([(); 3].map(|()| dice.number(0.01, 1.0)))).collect();
    let answers: Vec<_> = fixed.into_iter().chain(many).map(ask).collect();
    let logarithm = ("exp-not-ln", "Solving color = e^(−σ) for σ takes a logarithm, the inverse of `exp`.");
    let rivals: [Rival<'_, f64>; 8] = [
        (&|_| 0.0, ("coefficient-not-started", "`coefficient` returns zero. Solve color = e^(−σ · 1) for σ.")),
        (&ln, ("coefficient-sign", "The sign is wrong: a logarithm of less than 1 is negative, and σ is positive.")),
        (
            &|x| 1.0 - x,
            ("linear", "1 − color is what is lost after one unit, but σ tells how fast. Solve color = e^(−σ) for σ."),
        ),
        (&exp, logarithm),
        (&|x| exp(-x), logarithm),
        (&|x| 1.0 / x, ("reciprocal", "Solve color = e^(−σ) for σ: not by a division, but by a logarithm.")),
        (
            &|x| -ln(x) / std::f64::consts::LN_2,
            ("wrong-logarithm", "This is the logarithm to base 2. The inverse of `exp` is the natural one, `ln`."),
        ),
        (
            &|x| -ln(x) / std::f64::consts::LN_10,
            ("wrong-logarithm", "This is the logarithm to base 10. The inverse of `exp` is the natural one, `ln`."),
        ),
    ];
    let general = ("wrong-coefficient", "After one unit this color must be left: solve color = e^(−σ) for σ.");
    judge(&answers, &|x| -ln(x), &rivals, general)?;
    // Nearly opaque.
    let dark = [Rgb::new(0.005, 0.5, 0.002), Rgb::new(0.001, 1e-6, 1e-10)].map(ask);
    let advice = "With brighter colors your σ is right, but not with such dark ones. Each channel may be anything above 0: is it \
                  kept from being small?";
    judge(&dark, &|x| -ln(x), &[], ("dark-colors", advice))
}

/// σ of one channel, and the length of the way.
type Stretch = (f64, f64);

fn transmittance(answer: fn(Rgb, f32) -> Rgb) -> Verdict {
    let ask = |(sigma, length): (Rgb, f32)| {
        let way = if length.is_finite() { format!("{length} units") } else { "an infinite way".into() };
        let words = format!("`transmittance` of σ = {} over {way}", words::triple(sigma));
        let got = trying(|| words.clone(), || answer(sigma, length));
        Answered { words, asked: sigma.to_array().map(|sigma| (f64::from(sigma), f64::from(length))), got }
    };
    let right = |(x, s): Stretch| if x == 0.0 { 1.0 } else { exp(-x * s) };
    let mut dice = Dice::new(33);
    let sigma = Rgb::new(0.5, 1.5, 0.25);
    let mut questions = vec![(sigma, 2.0), (sigma, 0.5), (sigma, 0.0), (sigma, 1000.0)];
    questions.extend((0..200).map(|_| (dice.point(2.0).abs(), dice.number(0.0, 4.0))));
    let answers: Vec<_> = questions.into_iter().map(ask).collect();
    let lost = (
        "lost-not-left",
        "This is the share that is lost. The transmittance is the share that is left: 1 before the first step.",
    );
    let linear = (
        "linear",
        "This is 1 − σ s, which holds for very short ways only and is below zero for long ones: after half of the light is \
         lost, the next stretch takes half of the rest. e^(−σ s).",
    );
    let rounded = (
        "length-rounded",
        "For lengths that are whole numbers this is right, for others it is not: the length has been rounded.",
    );
    let rivals: [Rival<'_, Stretch>; 18] = [
        (&|_| 1.0, ("transmittance-not-started", "`transmittance` returns one: nothing is absorbed.")),
        (
            &|(x, s)| exp(x * s),
            ("light-grows", "There is more light after the way than before: the sign of the exponent."),
        ),
        (&|(x, s)| 1.0 - exp(-x * s), lost),
        (&|(x, s)| 1.0 - x * s, linear),
        (&|(x, s)| (1.0 - x * s).max(0.0), linear),
        (&|(x, s)| (1.0 - x * s).clamp(0.0, 1.0), linear),
        (&|(x, s)| 1.0 / (1.0 + x * s), ("not-exponential", "This falls with the way, but too slowly: e^(−σ s).")),
        (&|(x, _)| exp(-x), ("length-ignored", "This is what is left after one unit, whatever the length of the way.")),
        (
            &|(_, s)| exp(-s),
            ("sigma-ignored", "This is e^(−s), whatever the color of the glass: σ is missing in the exponent."),
        ),
        (&|(x, s)| exp(-x * s.ceil()), rounded),
        (&|(x, s)| exp(-x * s.floor()), rounded),
        (&|(x, s)| exp(-x * s.round()), rounded),
        (
            &|(x, s)| exp(-x * s * std::f64::consts::LN_2),
            ("not-base-e", "This is 2^(−σ s). The power is one of e: `common::float::exp`."),
        ),
        (
            &|(x, s)| exp(-x * s * std::f64::consts::LN_10),
            ("not-base-e", "This is 10^(−σ s). The power is one of e: `common::float::exp`."),
        ),
        (&|(x, s)| exp(-x * s * s), ("length-squared", "The length is in the exponent once, not squared.")),
        (
            &|(x, s)| exp(-x * s / 2.0),
            ("half-way", "This is what is left after half the way: the whole length counts."),
        ),
        (
            &|(x, s)| exp(-x * s * 2.0),
            ("twice-the-way", "This is what is left after twice the way: the ray goes it once."),
        ),
        (&|(x, s)| exp(-x * s) / 2.0, ("halved", "This is half of what is left. Without a way all of it is left: 1.")),
    ];
    let general = ("wrong-transmittance", "Work this out on paper, one channel after the other: e^(−σ s).");
    judge(&answers, &right, &rivals, general)?;
    let long = [ask((Rgb::new(0.004, 0.001, 0.0), 1500.0))];
    let advice =
        "For shorter ways this is right. Nothing is too long a way in pale glass: is the length kept within bounds?";
    judge(&long, &right, &[], ("long-ways", advice))?;
    let infinite = [ask((Rgb::new(0.0, 0.5, 2.0), f32::INFINITY))];
    let advice = "After an infinite way nothing is left, but where σ is zero all is left. In floating point 0 · ∞ is a NaN, \
                  so ask first whether σ is zero.";
    let ignored = (
        "infinite-way-ignored",
        "All of the light is left after an infinite way. That is so only where σ is zero: in each other channel nothing is \
         left. Ask whether σ is zero, not whether the way is infinite.",
    );
    let mistake = if infinite[0].got == Rgb::ONE { ignored } else { ("zero-times-infinity", advice) };
    judge(&infinite, &right, &[], mistake)
}

fn way(answer: fn(&Branch, Option<&Hit>) -> f32) -> Verdict {
    let ray = Ray::new(Vec3::new(0.0, 0.0, 5.0), -Vec3::Z);
    let hit = Hit::new(&ray, 4.0, Vec3::Z);
    let branch =
        |min, max| Branch { kind: Kind::Refracted, ray, range: Interval::new(min, max), share: Rgb::splat(0.5) };
    let origin_counts = "The ray's origin lies before the surface where the way begins: hits count from t = range.min, and so \
                         does the way.";
    const ENDLESS: f32 = f32::INFINITY;
    for (min, max, hit, right) in [
        (0.0, ENDLESS, Some(&hit), 4.0),
        (0.0, ENDLESS, None, ENDLESS),
        (1.5, ENDLESS, Some(&hit), 2.5),
        (3.0, ENDLESS, None, ENDLESS),
        (0.0, 100.0, None, ENDLESS),
        (1.5, 100.0, None, ENDLESS),
    ] {
        let what = hit.map_or("no hit".into(), |hit| format!("a hit at t = {}", hit.t));
        let until = if max == ENDLESS { String::new() } else { format!(" to t = {max}") };
        let tried = format!("`way` of a ray whose hits count from t = {min}{until}, and {what}");
        let got = trying(|| tried.clone(), || answer(&branch(min, max), hit));
        if got == right || (got - right).abs() < 1e-5 {
            continue;
        }
        let (name, advice) = match hit {
            None if max < ENDLESS && got > 0.0 => (
                "range-end",
                "Where hits cease to count, the ray does not end: without a hit its way is infinite, `f32::INFINITY`.",
            ),
            _ if got == 0.0 => ("way-not-started", "`way` returns 0. Where does the ray end?"),
            None => {
                ("infinite-way", "A ray that hits nothing travels without end: its way is infinite, `f32::INFINITY`.")
            }
            Some(hit) if got == hit.t => ("way-from-origin", origin_counts),
            Some(hit) if got == min - hit.t || got == -hit.t => ("negative-way", "The way has the wrong sign."),
            Some(_) => ("wrong-way", "The way goes from t = range.min to the hit's t."),
        };
        let told = |x: f32| if x == f32::INFINITY { "∞".into() } else { words::number(f64::from(x)) };
        let (got, expected) = (told(got), told(right));
        return Err(Finding { tried, got, expected, advice: advice.into() }.named(name));
    }
    Ok(())
}

/// σ of what a ray travels through, by its kind, the side that was hit, and σ here and inside.
fn right_medium(kind: Kind, side: Side, here: Rgb, inside: Rgb) -> Rgb {
    match (kind, side) {
        (Kind::Refracted, Side::Outside) => inside,
        (Kind::Refracted, Side::Inside) => Rgb::ZERO,
        _ => here,
    }
}

fn medium(answer: fn(&Branch, Side, Rgb, Rgb) -> Rgb) -> Verdict {
    let (glass, other) = (Rgb::new(0.5, 1.5, 0.25), Rgb::new(3.0, 2.0, 1.0));
    let air = Rgb::ZERO;
    let ray = Ray::new(Vec3::ZERO, Vec3::Y);
    let cases = [
        (
            (Kind::Refracted, Side::Outside, air, glass),
            "never-inside",
            "A refracted ray goes to the other side. From Side::Outside this is the inside.",
        ),
        (
            (Kind::Refracted, Side::Inside, glass, glass),
            "never-leaves",
            "A refracted ray goes to the other side. From Side::Inside this is the air, with σ zero.",
        ),
        (
            (Kind::Reflected, Side::Outside, air, glass),
            "reflection-enters",
            "A ray that is reflected on the outside never gets in. It stays where the old ray was, in the air.",
        ),
        (
            (Kind::Reflected, Side::Inside, glass, glass),
            "reflection-leaves",
            "A ray that is reflected inside stays inside: its way through the glass counts again.",
        ),
        (
            (Kind::Reflected, Side::Outside, glass, other),
            "reflection-not-here",
            "Something that lies in the glass reflects this ray on its own outside. The ray is still in the glass, where the \
             old one was: `here`.",
        ),
    ];
    let tried = |(kind, side, here, inside): (Kind, Side, Rgb, Rgb)| {
        let [here, inside] = [here, inside].map(words::triple);
        let side = words::side(side);
        format!("`medium` of a ray with Kind::{kind:?}, the surface hit from {side}, σ here {here}, σ inside {inside}")
    };
    let ask = |case: (Kind, Side, Rgb, Rgb)| {
        let (kind, side, here, inside) = case;
        let branch = Branch { kind, ray, range: Interval::POSITIVE, share: Rgb::splat(0.5) };
        trying(|| tried(case), || answer(&branch, side, here, inside))
    };
    let right = |(kind, side, here, inside)| right_medium(kind, side, here, inside);
    // The same right table, read in the wrong row or column.
    let other_kind = |kind| if kind == Kind::Refracted { Kind::Reflected } else { Kind::Refracted };
    let other_side = |side| if side == Side::Inside { Side::Outside } else { Side::Inside };
    let is_like = |mistaken: &dyn Fn(Kind, Side, Rgb, Rgb) -> Rgb| {
        cases.iter().all(|(case, ..)| ask(*case) == mistaken(case.0, case.1, case.2, case.3))
    };
    let swapped = if is_like(&|kind, side, here, inside| right_medium(other_kind(kind), side, here, inside)) {
        Some(("kinds-swapped", "What you do to a reflected ray is right for a refracted one, and the other way round."))
    } else if is_like(&|kind, side, here, inside| right_medium(kind, other_side(side), here, inside)) {
        Some(("sides-swapped", "What you do on Side::Outside is right on Side::Inside, and the other way round."))
    } else {
        None
    };
    for (case, name, advice) in cases {
        let (got, right) = (ask(case), right(case));
        // Any other color than the right one is this mistake.
        if got != right {
            let (name, advice) = swapped.unwrap_or((name, advice));
            let (got, expected) = (words::color(got), words::color(right));
            return Err(Finding { tried: tried(case), got, expected, advice: advice.into() }.named(name));
        }
    }
    Ok(())
}

/// A ball of glass, looked at through its center under an even sky: what is reflected to and fro sums to a geometric
/// series.
fn together(answer: Answer) -> Verdict {
    for (index, radius) in [(1.0, 1.0), (1.5, 1.0), (2.4, 0.25), (1.5, 3.0)] {
        let sigma = Rgb::new(0.1, 0.5, 1.5);
        let mut scene = Scene::new();
        scene.surround(Rgb::ONE);
        scene.add(
            "ball",
            Sphere::new(Vec3::ZERO, radius),
            Glass { surface: Material::glass(index), absorption: sigma },
        );
        let camera = Camera::new(Vec3::Z * 9.0, Vec3::ZERO, Vec3::Y, 30.0);
        let Ok(camera) = camera else { return Ok(()) };
        let tracer = Tracer { scene, camera, optics: answer, max_depth: 20, min_weight: 1e-4 };
        let tried = format!(
            "a glass ball of index {index}, radius {radius}, σ = {}, seen through its center under a sky of radiance 1",
            words::triple(sigma)
        );
        let got = trying(|| tried.clone(), || tracer.radiance(Ray::new(Vec3::Z * 9.0, -Vec3::Z)));
        let f = f64::from((index - 1.0) / (index + 1.0)).abs();
        let f = f * f;
        let diameter = f64::from(2.0 * radius);
        let right = each(sigma, |sigma| {
            let left = exp(-sigma * diameter);
            f + (1.0 - f) * (1.0 - f) * left / (1.0 - f * left)
        });
        if (got - right).abs().max_element() > 5e-3 {
            let (got, expected) = (words::color(got), words::color(right));
            let advice = "Each of your functions is right in what was asked so far, but not all of them together.";
            return Err(Finding { tried, got, expected, advice: advice.into() }.named("together"));
        }
    }
    Ok(())
}
