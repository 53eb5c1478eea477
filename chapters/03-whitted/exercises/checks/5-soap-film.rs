//! Checks exercise 3.5, soap bubbles.

use std::f64::consts::PI;

use common::{
    Interval, Rgb, Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying, words::range},
};
use ray_casting::{
    hit::{Hit, Side},
    material::Phong,
    ray::Ray,
};
use whitted::{branches::Branch, probe::Kind};

use super::{
    dispersion::WAVELENGTHS,
    tracer::{Follow, Next, Optics},
    words,
};

/// What the student writes.
#[derive(Clone, Copy)]
pub(crate) struct Answer {
    /// By cosine, index, thickness and wavelength.
    pub(crate) reflectance: fn(f32, f32, f32, f32) -> f32,
    /// The rays that a film sends on.
    pub(crate) branches: fn(&Ray, &Hit, Rgb) -> [Option<Branch>; 2],
}

/// Refractive index of water.
pub(crate) const WATER: f32 = 1.33;

/// A film, by its thickness in nanometers at a point.
pub(crate) type Film = Box<dyn Fn(Vec3) -> f32 + Send + Sync>;

impl Optics for Answer {
    type Material = Film;
    type Medium = ();
    const AIR: () = ();

    fn rough(&self, _film: &Film, _hit: &Hit) -> Option<Phong> {
        None
    }

    fn branches(&self, (branch, ()): Follow<'_, ()>, hit: &Hit, film: &Film) -> Next<()> {
        let cosine = -branch.ray.direction.dot(hit.shading_normal);
        let thickness = film(hit.position);
        let color = WAVELENGTHS.map(|wavelength| (self.reflectance)(cosine, WATER, thickness, wavelength));
        let [a, b] = (self.branches)(&branch.ray, hit, Rgb::from_array(color)).map(|b| b.map(|b| (b, ())));
        [a, b, None, None]
    }

    fn shines_through(&self, _film: &Film, _ray: &Ray, _hit: &Hit, _way: f32) -> Rgb {
        Rgb::ONE
    }
}

/// Accept a soap film, or name what is wrong with it.
pub(crate) fn check(answer: Answer) -> Verdict {
    // At a quarter of the wavelength in the film, all waves but the first are in step with it.
    if (answer.reflectance)(1.0, 1.5, 100.0, 600.0) == 0.0 && (answer.reflectance)(0.8, 1.5, 150.0, 500.0) == 0.0 {
        return Err(Diagnosis::not_started("Your film reflects nothing: `reflectance` is always 0."));
    }
    reflectance(answer.reflectance)?;
    branches(answer.branches)
}

/// A film and the light that meets it.
#[derive(Clone, Copy)]
struct Question {
    cosine: f64,
    index: f64,
    thickness: f64,
    wavelength: f64,
}

#[allow(clippy::disallowed_methods, reason = "the platform's functions are the second opinion here")]
fn cos(x: f64) -> f64 {
    x.cos()
}

#[allow(clippy::disallowed_methods, reason = "the platform's functions are the second opinion here")]
fn sin(x: f64) -> f64 {
    x.sin()
}

impl Question {
    fn inside(&self) -> f64 {
        (1.0 - (1.0 - self.cosine * self.cosine) / (self.index * self.index)).sqrt()
    }

    fn phase(&self) -> f64 {
        4.0 * PI * self.index * self.thickness * self.inside() / self.wavelength
    }

    /// Amplitudes across and along.
    fn amplitudes(&self) -> [f64; 2] {
        let (c, i, n) = (self.cosine, self.inside(), self.index);
        [(c - n * i) / (c + n * i), (n * c - i) / (n * c + i)]
    }

    /// The mean over both polarizations.
    fn mean(&self, one: impl Fn(f64) -> f64) -> f64 {
        self.amplitudes().map(one).iter().sum::<f64>() / 2.0
    }

    /// The right reflectance, wave by wave instead of by a formula.
    fn right(&self) -> f64 {
        self.with(self.phase())
    }

    fn with(&self, phase: f64) -> f64 {
        self.mean(|r| waves(r, phase, 400))
    }

    fn words(&self) -> String {
        let Self { cosine, index, thickness, wavelength } = self;
        let [cosine, index] = [cosine, index].map(|x| words::number(*x));
        format!("`reflectance` with cos θ = {cosine}, n = {index}, d = {thickness} nm, λ = {wavelength} nm")
    }
}

/// The squared magnitude of the sum of the first reflection and of `count` later ones.
fn waves(r: f64, phase: f64, count: u32) -> f64 {
    let (mut re, mut im) = (r, 0.0);
    let (mut size, mut angle) = ((1.0 - r * r) * r, phase);
    for _ in 0..count {
        re -= size * cos(angle);
        im -= size * sin(angle);
        size *= r * r;
        angle += phase;
    }
    re * re + im * im
}

/// By Airy's formula, with another sign before the cosine.
fn airy(r2: f64, cos: f64) -> f64 {
    2.0 * r2 * (1.0 - cos) / (1.0 + r2 * r2 - 2.0 * r2 * cos)
}

fn reflectance(answer: fn(f32, f32, f32, f32) -> f32) -> Verdict {
    let question = |cosine, index, thickness, wavelength| Question { cosine, index, thickness, wavelength };
    let mut questions = vec![
        question(0.75, 1.5, 150.0, 600.0),
        question(0.25, 2.0, 430.0, 550.0),
        question(1.0, 1.5, 100.0, 600.0),
        question(1.0, 1.33, 0.0, 550.0),
        question(0.5, 1.33, 0.0, 550.0),
    ];
    let mut dice = Dice::new(37);
    for _ in 0..500 {
        let [cosine, index] = [(0.05, 1.0), (1.1, 2.5)].map(|(min, max)| f64::from(dice.number(min, max)));
        let [thickness, wavelength] =
            [(0.0, 1500.0), (400.0, 700.0)].map(|(min, max)| f64::from(dice.number(min, max).round()));
        questions.push(question(cosine, index, thickness, wavelength));
    }
    for q in questions {
        #[expect(clippy::cast_possible_truncation, reason = "short numbers")]
        let [cosine, index, thickness, wavelength] = [q.cosine, q.index, q.thickness, q.wavelength].map(|x| x as f32);
        let got = f64::from(trying(|| q.words(), || answer(cosine, index, thickness, wavelength)));
        let right = q.right();
        if (got - right).abs() < 3e-4 {
            continue;
        }
        let (name, advice) = named(&q, got);
        let (got, expected) = (words::number(got), words::number(right));
        return Err(Finding { tried: q.words(), got, expected, advice: advice.into() }.named(name));
    }
    Ok(())
}

/// The likely mistake behind a wrong reflectance.
fn named(q: &Question, got: f64) -> (&'static str, &'static str) {
    let is = |x: f64| (got - x).abs() < 2e-5;
    let phase = q.phase();
    let cosine = cos(phase);
    let [across, along] = q.amplitudes();
    let fresnel = q.mean(|r| r * r);
    let mean_amplitude = f64::midpoint(across, along);
    if got.is_nan() {
        ("not-a-number", "This is no number: was a root taken of something negative?")
    } else if is(q.mean(|r| airy(r * r, -cosine))) {
        (
            "flip-forgotten",
            "The front reflects r from outside, but −r from inside: between the first wave and the others is a minus. With it a \
             film without thickness is black, without it such a film would be bright.",
        )
    } else if is(q.with(phase / 2.0)) {
        ("one-way", "The waves cross the film to and fro, twice its thickness: 4π, not 2π.")
    } else if is(q.with(phase / q.index)) {
        ("index-forgotten", "In the film waves are shorter by n, so that the phase grows n times as fast.")
    } else if is(q.with(phase / q.inside())) {
        ("cosine-forgotten", "The phase depends on the angle as well: δ = 4π n d cos θ_t / λ.")
    } else if is(q.with(phase / q.inside() * q.cosine)) {
        ("cosine-outside", "The cosine in the phase is that inside the film, θ_t.")
    } else if is(q.with(phase / (q.inside() * q.inside()))) {
        (
            "cosine-divides",
            "At an angle the way through the film is longer, but the first wave travels farther, too, until both come together. \
             What is left is cos θ_t as a factor.",
        )
    } else if is(q.mean(|r| waves(r, phase, 1))) || is(q.mean(|r| 2.0 * r * r * (1.0 - cosine))) {
        ("two-waves", "These are the first two waves only. Sum the whole series: 1 + q + q² + … = 1 / (1 − q).")
    } else if is(fresnel) {
        ("no-interference", "This is the reflectance of the front alone. The other waves come on top.")
    } else if is(q.mean(|r| 2.0 * r * r / (1.0 + r * r))) {
        ("no-interference", "Here the waves' powers are added. Add their amplitudes, with phases, and square the sum.")
    } else if is(airy(across * across, cosine)) || is(airy(along * along, cosine)) {
        ("one-polarization", "This is one of the two polarizations. Take the mean of both.")
    } else if is(airy(fresnel, cosine)) || is(airy(mean_amplitude * mean_amplitude, cosine)) {
        ("mean-too-early", "Take the mean over the two polarizations in the end: each of them interferes by itself.")
    } else if is(2.0 * q.right()) {
        ("sum-not-mean", "Unpolarized light is half and half: take the mean of across and along, not their sum.")
    } else if is(q.mean(|r| waves(r, phase, 400).sqrt())) {
        ("not-squared", "This is the magnitude of the amplitude. The reflectance is its square.")
    } else if is(q.mean(|r| airy(r.abs(), cosine))) {
        ("amplitude-for-its-square", "In the formula stands r², the square of the amplitude.")
    } else if is(1.0 - q.right()) {
        ("transmitted", "This is what goes through. The reflectance is the rest.")
    } else {
        (
            "wrong-reflectance",
            "Work this out step by step: cos θ_t, both r, δ; then r (1 − e^(iδ)) / (1 − r² e^(iδ)), squared in magnitude.",
        )
    }
}

fn branches(answer: fn(&Ray, &Hit, Rgb) -> [Option<Branch>; 2]) -> Verdict {
    // Plain numbers first.
    let ray = Ray::new(Vec3::ZERO, Vec3::new(0.6, 0.0, -0.8));
    judge(&ray, &Hit::new(&ray, 2.0, Vec3::Z), Rgb::new(0.25, 0.125, 0.0), answer)?;
    let mut dice = Dice::new(38);
    for _ in 0..200 {
        let side = dice.choice([Side::Outside, Side::Inside]);
        let (direction, normal) = (dice.direction().normalize(), dice.direction().normalize());
        let normal = if direction.dot(normal) > 0.0 { -normal } else { normal };
        let ray = Ray::new(dice.point(4.0), direction);
        let hit = Hit { side, ..Hit::new(&ray, 2.0, normal) };
        let color = Rgb::from_array([(); 3].map(|()| dice.number(0.0, 0.5)));
        if direction.dot(normal) < -0.05 {
            judge(&ray, &hit, color, answer)?;
        }
    }
    Ok(())
}

fn judge(ray: &Ray, hit: &Hit, color: Rgb, answer: fn(&Ray, &Hit, Rgb) -> [Option<Branch>; 2]) -> Verdict {
    let tried = || {
        let (direction, color) = (words::triple(ray.direction), words::triple(color));
        format!("`branches` of a ray in direction {direction}, with {}, at t = 2, reflectance {color}", words::hit(hit))
    };
    let rays: Vec<_> = trying(tried, || answer(ray, hit, color)).into_iter().flatten().collect();
    let finding = |got: String, expected: String, name, advice: &str| {
        Err(Finding { tried: tried(), got, expected, advice: advice.into() }.named(name))
    };
    if rays.is_empty() {
        let advice = "`reflectance` is right. Now for the rays.";
        return finding("no rays".into(), "two rays".into(), "branches-not-started", advice);
    }
    let of = |kind| rays.iter().find(|b: &&Branch| b.kind == kind);
    let (Some(reflected), Some(straight)) = (of(Kind::Reflected), of(Kind::Refracted)) else {
        let got = format!("{} ray, {:?}", rays.len(), rays[0].kind);
        let advice = "A film always sends on two rays, from either side: total reflection does not happen to what ends in air \
                      again.";
        return finding(got, "one Kind::Reflected and one Kind::Refracted".into(), "ray-missing", advice);
    };
    let direction = |b: &Branch| words::color(b.ray.direction);
    let normal = hit.geometric_normal;
    let mirrored = ray.direction - 2.0 * normal * ray.direction.dot(normal);
    if !reflected.ray.direction.abs_diff_eq(mirrored, 1e-4) {
        let advice = "`whitted::reflection::reflect` knows the mirror direction.";
        return finding(direction(reflected), words::color(mirrored), "wrong-reflection", advice);
    }
    if !straight.ray.direction.abs_diff_eq(ray.direction, 1e-5) {
        let advice = "The film is bounded by air on both sides and much thinner than anything else: what it bends on entry it \
                      bends back on leaving, so the ray goes straight on.";
        return finding(direction(straight), words::color(ray.direction), "bent", advice);
    }
    for (branch, share) in [(reflected, color), (straight, Rgb::ONE - color)] {
        if !branch.share.abs_diff_eq(share, 1e-5) {
            let is_swapped = branch.share.abs_diff_eq(Rgb::ONE - share, 1e-5);
            let (name, advice) = if is_swapped && reflected.share != straight.share {
                ("shares-swapped", "The reflected ray has the reflectance as its share, the other one the rest.")
            } else {
                ("wrong-share", "The reflected ray has the reflectance as its share, the other one the rest: 1 − R.")
            };
            let told = |share| format!("{:?} with a share of {}", branch.kind, words::color(share));
            return finding(told(branch.share), told(share), name, advice);
        }
    }
    // Where the reflected ray begins to count.
    let above = (reflected.ray.origin - hit.position).dot(normal);
    if above <= 0.0 || above > 1e-2 || reflected.range != Interval::POSITIVE {
        let got = format!("the reflected ray begins {above} units before the film, {}", range(reflected.range));
        let advice = "It starts at `Offset::Following.origin(hit, hit.geometric_normal)` and counts from there on.";
        return finding(got, "a little before it, range 0 < t < ∞".into(), "wrong-start", advice);
    }
    // The other one: the old ray that counts from the hit on, or a new one that starts behind the film.
    let is_old = straight.ray == *ray && straight.range == Interval::new(hit.t, f32::INFINITY);
    let beyond = -(straight.ray.origin - hit.position).dot(normal);
    let is_new = beyond > 0.0 && beyond < 1e-2 && straight.range == Interval::POSITIVE;
    if is_old || is_new {
        return Ok(());
    }
    let got = format!("{} from {}", range(straight.range), words::triple(straight.ray.origin));
    let (name, advice) = if straight.ray == *ray {
        ("hits-again", "This is the old ray, and it meets the same film again: let hits count from `hit.t` on.")
    } else {
        ("wrong-start", "Go on with the same ray, `*ray`, and let hits count from `hit.t` on.")
    };
    finding(
        got,
        format!("{} from {}", range(Interval::new(hit.t, f32::INFINITY)), words::triple(ray.origin)),
        name,
        advice,
    )
}
