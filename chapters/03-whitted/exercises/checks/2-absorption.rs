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

/// Accept one value, or give the mistake its name: the first of the rivals that would come out like that.
fn compare(tried: String, got: Rgb, right: Rgb, rivals: &[(Rgb, Mistake)], general: Mistake) -> Verdict {
    if words::is_near(got, right, 1e-4) {
        return Ok(());
    }
    let rival = rivals.iter().find(|(value, _)| words::is_near(got, *value, 1e-4));
    let gray = (got.max_element() - got.min_element() < 1e-6
        && got.is_finite()
        && right.max_element() != right.min_element())
    .then_some(("one-channel", "Your three channels are equal, but they should not be: compute each one by itself."));
    let nan = got.is_nan().then_some(("not-a-number", "This is no number. Was zero multiplied by infinity?"));
    let (name, advice) = rival.map(|(_, mistake)| *mistake).or(nan).or(gray).unwrap_or(general);
    let (got, expected) = (words::color(got), words::color(right));
    Err(Finding { tried, got, expected, advice: advice.into() }.named(name))
}

fn coefficient(answer: fn(Rgb) -> Rgb) -> Verdict {
    let mut dice = Dice::new(32);
    let fixed = [Rgb::new(0.9, 0.5, 0.1), Rgb::new(0.2, 0.7, 0.4), Rgb::ONE];
    let many: Vec<_> = (0..100).map(|_| Rgb::from_array([(); 3].map(|()| dice.number(0.01, 1.0)))).collect();
    for color in fixed.into_iter().chain(many) {
        let of = |f: &dyn Fn(f64) -> f64| each(color, f);
        let tried = format!("`coefficient` of the color {}", words::triple(color));
        let got = trying(|| tried.clone(), || answer(color));
        let rivals = [
            (Rgb::ZERO, ("coefficient-not-started", "`coefficient` returns zero. Solve color = e^(−σ · 1) for σ.")),
            (
                of(&ln),
                ("coefficient-sign", "The sign is wrong: a logarithm of less than 1 is negative, and σ is positive."),
            ),
            (
                of(&|x| 1.0 - x),
                (
                    "linear",
                    "1 − color is what is lost after one unit, but σ tells how fast. Solve color = e^(−σ) for σ.",
                ),
            ),
            (of(&exp), ("exp-not-ln", "Solving color = e^(−σ) for σ takes a logarithm, the inverse of `exp`.")),
            (of(&|x| exp(-x)), ("exp-not-ln", "Solving color = e^(−σ) for σ takes a logarithm, the inverse of `exp`.")),
            (of(&|x| 1.0 / x), ("reciprocal", "Solve color = e^(−σ) for σ: not by a division, but by a logarithm.")),
            (
                of(&|x| -ln(x) / std::f64::consts::LN_2),
                ("wrong-logarithm", "This is the logarithm to base 2. The inverse of `exp` is the natural one, `ln`."),
            ),
            (
                of(&|x| -ln(x) / std::f64::consts::LN_10),
                ("wrong-logarithm", "This is the logarithm to base 10. The inverse of `exp` is the natural one, `ln`."),
            ),
        ];
        let general = ("wrong-coefficient", "After one unit this color must be left: solve color = e^(−σ) for σ.");
        compare(tried, got, of(&|x| -ln(x)), &rivals, general)?;
    }
    Ok(())
}

fn transmittance(answer: fn(Rgb, f32) -> Rgb) -> Verdict {
    let mut dice = Dice::new(33);
    let sigma = Rgb::new(0.5, 1.5, 0.25);
    let mut questions = vec![(sigma, 2.0), (sigma, 0.5), (sigma, 0.0), (sigma, 1000.0)];
    questions.extend((0..200).map(|_| (dice.point(2.0).abs(), dice.number(0.0, 4.0))));
    for (sigma, length) in questions {
        let s = f64::from(length);
        let of = |f: &dyn Fn(f64) -> f64| each(sigma, f);
        let tried = format!("`transmittance` of σ = {} over {length} units", words::triple(sigma));
        let got = trying(|| tried.clone(), || answer(sigma, length));
        let lost = (
            "lost-not-left",
            "This is the share that is lost. The transmittance is the share that is left: 1 before the first step.",
        );
        let linear = (
            "linear",
            "This is 1 − σ s, which holds for very short ways only and is below zero for long ones: after half of the light \
             is lost, the next stretch takes half of the rest. e^(−σ s).",
        );
        let rivals = [
            (Rgb::ONE, ("transmittance-not-started", "`transmittance` returns one: nothing is absorbed.")),
            (
                of(&|x| exp(x * s)),
                ("light-grows", "There is more light after the way than before: the sign of the exponent."),
            ),
            (of(&|x| 1.0 - exp(-x * s)), lost),
            (of(&|x| 1.0 - x * s), linear),
            (of(&|x| (1.0 - x * s).max(0.0)), linear),
            (of(&|x| (1.0 - x * s).clamp(0.0, 1.0)), linear),
            (of(&|x| 1.0 / (1.0 + x * s)), ("not-exponential", "This falls with the way, but too slowly: e^(−σ s).")),
            (
                of(&|x| exp(-x)),
                ("length-ignored", "This is what is left after one unit, whatever the length of the way."),
            ),
            (
                of(&|x| exp(-x * s * std::f64::consts::LN_2)),
                ("not-base-e", "This is 2^(−σ s). The power is one of e: `common::float::exp`."),
            ),
            (of(&|x| exp(-x * s * s)), ("length-squared", "The length is in the exponent once, not squared.")),
            (
                of(&|x| exp(-x * s / 2.0)),
                ("half-way", "This is what is left after half the way: the whole length counts."),
            ),
            (
                of(&|x| exp(-x * s * 2.0)),
                ("twice-the-way", "This is what is left after twice the way: the ray goes it once."),
            ),
        ];
        // Without a way nothing can be told apart.
        let rivals = if length == 0.0 { &rivals[2..3] } else { &rivals[..] };
        let general = ("wrong-transmittance", "Work this out on paper, one channel after the other: e^(−σ s).");
        compare(tried, got, of(&|x| exp(-x * s)), rivals, general)?;
    }
    let sigma = Rgb::new(0.0, 0.5, 2.0);
    let tried = format!("`transmittance` of σ = {} over an infinite way", words::triple(sigma));
    let got = trying(|| tried.clone(), || answer(sigma, f32::INFINITY));
    let advice = "After an infinite way nothing is left, but where σ is zero all is left. In floating point 0 · ∞ is a NaN, \
                  so ask first whether σ is zero.";
    let mistake = ("zero-times-infinity", advice);
    let is_nan = got.is_nan().then_some(got);
    match is_nan {
        Some(_) => {
            let (got, expected) = (words::color(got), words::color(Rgb::X));
            Err(Finding { tried, got, expected, advice: advice.into() }.named(mistake.0))
        }
        None => compare(tried, got, Rgb::X, &[(Rgb::ZERO, mistake)], mistake),
    }
}

fn way(answer: fn(&Branch, Option<&Hit>) -> f32) -> Verdict {
    let ray = Ray::new(Vec3::new(0.0, 0.0, 5.0), -Vec3::Z);
    let hit = Hit::new(&ray, 4.0, Vec3::Z);
    let branch =
        |min| Branch { kind: Kind::Refracted, ray, range: Interval::new(min, f32::INFINITY), share: Rgb::splat(0.5) };
    let origin_counts = "The ray's origin lies before the surface where the way begins: hits count from t = range.min, and so \
                         does the way.";
    for (min, hit, right) in
        [(0.0, Some(&hit), 4.0), (0.0, None, f32::INFINITY), (1.5, Some(&hit), 2.5), (3.0, None, f32::INFINITY)]
    {
        let what = hit.map_or("no hit".into(), |hit| format!("a hit at t = {}", hit.t));
        let tried = format!("`way` of a ray whose hits count from t = {min}, and {what}");
        let got = trying(|| tried.clone(), || answer(&branch(min), hit));
        if got == right || (got - right).abs() < 1e-5 {
            continue;
        }
        let (name, advice) = match hit {
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

fn medium(answer: fn(&Branch, Side, Rgb, Rgb) -> Rgb) -> Verdict {
    let (glass, other) = (Rgb::new(0.5, 1.5, 0.25), Rgb::new(3.0, 2.0, 1.0));
    let air = Rgb::ZERO;
    let ray = Ray::new(Vec3::ZERO, Vec3::Y);
    for (kind, side, here, inside, right, name, advice) in [
        (
            Kind::Refracted,
            Side::Outside,
            air,
            glass,
            glass,
            "never-inside",
            "A refracted ray goes to the other side. From Side::Outside this is the inside.",
        ),
        (
            Kind::Refracted,
            Side::Inside,
            glass,
            glass,
            air,
            "never-leaves",
            "A refracted ray goes to the other side. From Side::Inside this is the air, with σ zero.",
        ),
        (
            Kind::Reflected,
            Side::Outside,
            air,
            glass,
            air,
            "reflection-enters",
            "A ray that is reflected on the outside never gets in. It stays where the old ray was, in the air.",
        ),
        (
            Kind::Reflected,
            Side::Inside,
            glass,
            glass,
            glass,
            "reflection-leaves",
            "A ray that is reflected inside stays inside: its way through the glass counts again.",
        ),
        (
            Kind::Reflected,
            Side::Outside,
            glass,
            other,
            glass,
            "reflection-not-here",
            "Something that lies in the glass reflects this ray on its own outside. The ray is still in the glass, where the \
             old one was: `here`.",
        ),
    ] {
        let branch = Branch { kind, ray, range: Interval::POSITIVE, share: Rgb::splat(0.5) };
        let [here_words, inside_words] = [here, inside].map(words::triple);
        let side_words = words::side(side);
        let tried = format!(
            "`medium` of a ray with Kind::{kind:?}, the surface hit from {side_words}, σ here {here_words}, σ inside \
             {inside_words}"
        );
        let got = trying(|| tried.clone(), || answer(&branch, side, here, inside));
        // Any other color than the right one is this mistake.
        if got != right {
            let (got, expected) = (words::color(got), words::color(right));
            return Err(Finding { tried, got, expected, advice: advice.into() }.named(name));
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
