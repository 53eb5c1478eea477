//! Checks exercise 3.3, dispersion.

use common::{
    Rgb, Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use ray_casting::{
    hit::{Hit, Side},
    material::Phong,
    ray::Ray,
};
use whitted::{branches::Branch, probe::Kind};

use super::{
    tracer::{Follow, Next, Optics},
    words,
};

/// What the student writes.
#[derive(Clone, Copy)]
pub(crate) struct Answer {
    /// The index, by A, B and the wavelength in nanometers.
    pub(crate) cauchy: fn(f32, f32, f32) -> f32,
    /// The rays that a surface sends on.
    pub(crate) branches: fn(&Ray, &Hit, Rgb) -> [Option<Branch>; 4],
}

/// Wavelengths that stand for red, green and blue, in nanometers.
pub(crate) const WAVELENGTHS: [f32; 3] = [650.0, 550.0, 450.0];

/// A surface of the pictures.
#[derive(Clone, Copy)]
pub(crate) enum Surface {
    /// Scatters light.
    Rough(Phong),
    /// Lets it through, with an index for each channel.
    Clear(Rgb),
}

impl Optics for Answer {
    type Material = Surface;
    type Medium = ();
    const AIR: () = ();

    fn rough(&self, material: &Surface, _hit: &Hit) -> Option<Phong> {
        if let Surface::Rough(phong) = material { Some(*phong) } else { None }
    }

    fn branches(&self, (branch, ()): Follow<'_, ()>, hit: &Hit, material: &Surface) -> Next<()> {
        match material {
            Surface::Rough(_) => [None; 4],
            // A ray of one channel goes on as one.
            Surface::Clear(index) => {
                let next = (self.branches)(&branch.ray, hit, *index);
                next.map(|b| b.filter(|b| b.share * branch.share != Rgb::ZERO).map(|b| (b, ())))
            }
        }
    }

    fn shines_through(&self, material: &Surface, ray: &Ray, hit: &Hit, _way: f32) -> Rgb {
        match material {
            Surface::Rough(_) => Rgb::ZERO,
            Surface::Clear(_) => Rgb::splat(0.7 * ray.direction.dot(hit.geometric_normal).abs()),
        }
    }
}

/// Accept dispersion, or name what is wrong with it.
pub(crate) fn check(answer: Answer) -> Verdict {
    // Steep enough to be refracted even by a mistaken 1/n.
    let steep = Vec3::new(0.28, -0.96, 0.0);
    let outside = Question::of(steep, Vec3::new(1.0, 2.0, 3.0), Vec3::Y, Side::Outside, FLINT);
    let is_empty = outside.ask(&answer).iter().all(Option::is_none);
    if is_empty && (answer.cauchy)(1.5, 0.005, 500.0) == 1.0 {
        return Err(Diagnosis::not_started("`cauchy` always answers 1, and `branches` sends no rays."));
    }
    cauchy(answer.cauchy)?;
    if is_empty {
        let message = "`cauchy` is right. Now for `branches`, which sends no rays.";
        return Err(Diagnosis::new("branches-not-started", message));
    }
    for question in [
        outside,
        Question::new(0.0, Side::Outside, FLINT),
        Question::new(45.0, Side::Outside, FLINT),
        Question::new(80.0, Side::Outside, FLINT),
        Question::new(20.0, Side::Inside, FLINT),
        // Blue is totally reflected, then green too, then all.
        Question::new(PARTLY[0], Side::Inside, WIDE),
        Question::new(PARTLY[1], Side::Inside, WIDE),
        Question::new(60.0, Side::Inside, WIDE),
    ] {
        question.check(&answer)?;
    }
    let mut dice = Dice::new(34);
    for _ in 0..1000 {
        let side = dice.choice([Side::Outside, Side::Inside]);
        let index = dice.choice([FLINT, WIDE, Rgb::new(1.33, 1.34, 1.345)]);
        let question = Question::random(&mut dice, side, index);
        if question.is_fair() {
            question.check(&answer)?;
        }
    }
    Ok(())
}

fn cauchy(answer: fn(f32, f32, f32) -> f32) -> Verdict {
    for (a, b, nanometers) in [
        (1.728, 0.01342, 550.0),
        (1.5046, 0.0042, 450.0),
        (1.458, 0.00354, 650.0),
        (2.378, 0.0121, 400.0),
        (1.6, 0.0, 500.0),
    ] {
        let tried = format!("`cauchy` with A = {a}, B = {b} µm², λ = {nanometers} nm");
        let got = f64::from(trying(|| tried.clone(), || answer(a, b, nanometers)));
        let [a, b, nm] = [a, b, nanometers].map(f64::from);
        let micro = nm / 1000.0;
        let right = a + b / (micro * micro);
        if (got - right).abs() < 1e-5 {
            continue;
        }
        let is = |x: f64| (got - x).abs() < 1e-5 * x.abs().max(1.0);
        let (name, advice) = if got == 1.0 {
            ("cauchy-not-started", "`cauchy` answers 1, which is the index of empty space.")
        } else if is(a + b / (nm * nm)) {
            (
                "nanometers",
                "This is next to A alone. B counts in µm², but the wavelength came in nanometers: divide it by 1000 before you square \
                 it. Or is B missing?",
            )
        } else if is(a + b * 1e3 / (nm * nm)) || is(a + b / (micro * nm)) {
            ("nanometers", "The wavelength is squared after it was turned into micrometers, not before.")
        } else if is(a + b / micro) {
            ("not-squared", "Divide by the square of the wavelength.")
        } else if is(a + b * micro * micro) {
            (
                "multiplied",
                "Divide B by the square of the wavelength: blue light, of short waves, is bent more than red.",
            )
        } else if is(a - b / (micro * micro)) {
            ("minus", "Add the second term: the shorter the wave, the greater the index.")
        } else if is(b + a / (micro * micro)) {
            ("swapped", "A and B have changed places.")
        } else {
            ("wrong-index", "Work this out on paper: λ in micrometers, then A + B / λ².")
        };
        let (got, expected) = (words::number(got), words::number(right));
        return Err(Finding { tried, got, expected, advice: advice.into() }.named(name));
    }
    Ok(())
}

/// Dense flint glass.
const FLINT: Rgb = Rgb::new(1.7598, 1.7724, 1.7943);
/// No real glass: indices far apart, so that everything shows.
const WIDE: Rgb = Rgb::new(1.4, 1.6, 1.9);
/// Angles in degrees beyond the critical angle of blue only (31.8°), and of blue and green (38.7°), in that glass.
const PARTLY: [f64; 2] = [35.0, 42.0];

/// A ray that meets a surface.
struct Question {
    ray: Ray,
    hit: Hit,
    index: Rgb,
}

impl Question {
    /// At an angle in degrees from the normal.
    #[allow(clippy::disallowed_methods, clippy::cast_possible_truncation, reason = "nearly the angle is near enough")]
    fn new(degrees: f64, side: Side, index: Rgb) -> Self {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let direction = Vec3::new(sin as f32, -cos as f32, 0.0);
        Self::of(direction, Vec3::new(1.0, 2.0, 3.0), Vec3::Y, side, index)
    }

    fn random(dice: &mut Dice, side: Side, index: Rgb) -> Self {
        let normal = dice.direction().normalize();
        let direction = dice.direction().normalize();
        let direction = if direction.dot(normal) > 0.0 { -direction } else { direction };
        Self::of(direction, dice.point(5.0), normal, side, index)
    }

    /// `normal` faces the ray.
    fn of(direction: Vec3, position: Vec3, normal: Vec3, side: Side, index: Rgb) -> Self {
        let ray = Ray::new(position - 2.0 * direction, direction);
        let outward = if side == Side::Inside { -normal } else { normal };
        Self { ray, hit: Hit { side, ..Hit::new(&ray, 2.0, outward) }, index }
    }

    /// The index behind divided by that before, for a channel.
    fn relative(&self, channel: usize) -> f64 {
        let n = f64::from(self.index[channel]);
        if self.hit.side == Side::Inside { 1.0 / n } else { n }
    }

    fn cosine(&self) -> f64 {
        -self.ray.direction.as_dvec3().dot(self.hit.geometric_normal.as_dvec3())
    }

    /// The square of the cosine behind the surface; negative beyond the critical angle.
    fn behind(&self, n: f64) -> f64 {
        1.0 - (1.0 - self.cosine() * self.cosine()) / (n * n)
    }

    /// Whether rounding decides nothing: away from the critical angles and from the surface itself.
    fn is_fair(&self) -> bool {
        self.cosine() > 0.05 && (0..3).all(|c| self.behind(self.relative(c)).abs() > 0.02)
    }

    /// Fresnel's reflectance, as the mean of the squares of two ratios.
    fn reflectance(&self, n: f64) -> f64 {
        let (before, behind) = (self.cosine(), self.behind(n));
        if behind < 0.0 {
            return 1.0;
        }
        let behind = behind.sqrt();
        let along = (n * before - behind) / (n * before + behind);
        let across = (before - n * behind) / (before + n * behind);
        (along * along + across * across) / 2.0
    }

    /// The refracted direction.
    #[expect(clippy::cast_possible_truncation, reason = "to be compared with f32")]
    fn refracted(&self, n: f64) -> Option<Vec3> {
        let behind = self.behind(n);
        let (d, normal) = (self.ray.direction.as_dvec3(), self.hit.geometric_normal.as_dvec3());
        // The part along the surface shrinks by n, the rest follows from the length.
        let along = (d + normal * self.cosine()) / n;
        let v = along - normal * behind.max(0.0).sqrt();
        (behind >= 0.0).then(|| Vec3::new(v.x as f32, v.y as f32, v.z as f32))
    }

    fn ask(&self, answer: &Answer) -> [Option<Branch>; 4] {
        trying(|| self.words(), || (answer.branches)(&self.ray, &self.hit, self.index))
    }

    fn words(&self) -> String {
        format!(
            "`branches` of a ray with direction {} and {}, with the indices {}",
            words::triple(self.ray.direction),
            words::hit(&self.hit),
            words::triple(self.index)
        )
    }

    fn finding(
        &self,
        got: impl Into<String>,
        expected: impl Into<String>,
        name: &'static str,
        advice: &str,
    ) -> Verdict {
        let (tried, got, expected) = (self.words(), got.into(), expected.into());
        Err(Finding { tried, got, expected, advice: advice.into() }.named(name))
    }

    fn check(&self, answer: &Answer) -> Verdict {
        let rays: Vec<_> = self.ask(answer).into_iter().flatten().collect();
        for Branch { ray, share, kind, .. } in &rays {
            let got = format!("a ray in direction {}, share {}", words::color(ray.direction), words::color(*share));
            if !(ray.direction.is_finite() && share.is_finite() && ray.origin.is_finite()) {
                let advice =
                    "Something is no number. Was there no refracted direction, and was one computed all the same?";
                return self.finding(got, "numbers", "not-a-number", advice);
            }
            if (ray.direction.length() - 1.0).abs() > 1e-4 {
                return self.finding(
                    got,
                    "a unit direction",
                    "not-unit",
                    "Directions have length 1; `refract` sees to that.",
                );
            }
            if *kind == Kind::Camera {
                let advice = "A new ray is of `Kind::Reflected` or of `Kind::Refracted`.";
                return self.finding("Kind::Camera", "another kind", "wrong-kind", advice);
            }
        }
        let (reflected, refracted): (Vec<_>, Vec<_>) = rays.into_iter().partition(|b| b.kind == Kind::Reflected);
        self.check_reflected(&reflected)?;
        self.check_channels(&refracted)?;
        self.check_shares(&reflected, &refracted)?;
        self.check_origins(&reflected, 1.0)?;
        self.check_origins(&refracted, -1.0)
    }

    fn check_reflected(&self, reflected: &[Branch]) -> Verdict {
        let (d, n) = (self.ray.direction, self.hit.geometric_normal);
        let right = d - 2.0 * n * d.dot(n);
        let expected = format!("one reflected ray, in direction {}", words::color(right));
        match reflected {
            [] => self.finding(
                "no reflected ray",
                expected,
                "no-reflection",
                "Smooth glass reflects a share of all light.",
            ),
            [one] if !one.ray.direction.abs_diff_eq(right, 1e-4) => {
                let got = format!("a reflected ray in direction {}", words::color(one.ray.direction));
                self.finding(
                    got,
                    expected,
                    "wrong-reflection",
                    "`whitted::reflection::reflect` knows the mirror direction.",
                )
            }
            [_] => Ok(()),
            many => {
                let advice = "A mirror sends all colors the same way: one ray is enough for all three channels.";
                self.finding(format!("{} reflected rays", many.len()), expected, "reflected-thrice", advice)
            }
        }
    }

    /// Each channel goes its own way, or none.
    fn check_channels(&self, refracted: &[Branch]) -> Verdict {
        const NAMES: [&str; 3] = ["red", "green", "blue"];
        let carries = |b: &Branch, c: usize| b.share[c].abs() > 1e-6;
        let directions = [0, 1, 2].map(|c| self.refracted(self.relative(c)));
        let is_partly_total = directions.iter().any(Option::is_none);
        for c in 0..3 {
            let name = NAMES[c];
            let carriers: Vec<_> = refracted.iter().filter(|b| carries(b, c)).collect();
            let got = match carriers[..] {
                [] => format!("no refracted ray for {name}"),
                [one] => {
                    let (direction, share) = (words::color(one.ray.direction), words::color(one.share));
                    format!("for {name} a refracted ray in direction {direction}, with the share {share}")
                }
                _ => format!("{} refracted rays that carry {name}", carriers.len()),
            };
            let Some(right) = directions[c] else {
                if !carriers.is_empty() {
                    let advice = "This channel is beyond its critical angle: nothing of it is refracted. `refract` answers \
                                  `None`, and there is no other direction to take instead.";
                    return self.finding(got, format!("none for {name}"), "invented-direction", advice);
                }
                continue;
            };
            let expected = format!("one for {name} alone, in direction {}", words::color(right));
            let Some(one) = carriers.first() else {
                let (mistake, advice) = if is_partly_total {
                    (
                        "all-or-nothing",
                        "Another channel is totally reflected here, but this one is not. Each has its own critical angle.",
                    )
                } else {
                    ("channel-missing", "Each channel sends a refracted ray of its own.")
                };
                return self.finding(got, expected, mistake, advice);
            };
            if refracted.len() == 1 && !is_partly_total {
                let advice = "There is one refracted ray for all channels. Send three, each bent by its own index, and each \
                              with a share for its own channel only.";
                return self.finding(got, expected, "not-split", advice);
            }
            if carriers.len() > 1 || (0..3).any(|other| other != c && carries(one, other)) {
                let advice = "Three rays, but each of them carries more than its own channel. Multiply the share by \
                              (1, 0, 0) for red, (0, 1, 0) for green, (0, 0, 1) for blue.";
                return self.finding(got, expected, "channels-not-parted", advice);
            }
            let direction = one.ray.direction;
            if direction.abs_diff_eq(right, 1e-4) {
                continue;
            }
            let is = |n: f64| self.refracted(n).is_some_and(|d| direction.abs_diff_eq(d, 1e-4));
            let (mistake, advice) = if self.hit.side == Side::Inside && is(1.0 / self.relative(c)) {
                ("index-from-inside", "From Side::Inside the ray leaves the glass: the relative index is 1/n.")
            } else if self.hit.side == Side::Outside && is(1.0 / self.relative(c)) {
                ("index-reversed", "From Side::Outside the ray enters the glass: the relative index is n, and not 1/n.")
            } else if (0..3).any(|other| is(self.relative(other))) {
                ("wrong-channel", "This is the direction of another channel. Each one is bent by its own index.")
            } else if direction.abs_diff_eq(self.ray.direction, 1e-4) {
                ("not-bent", "This ray goes straight on. Snell's law bends it: `whitted::refraction::refract`.")
            } else {
                (
                    "wrong-direction",
                    "By Snell's law another direction comes out. `whitted::refraction::refract` knows it.",
                )
            };
            return self.finding(got, expected, mistake, advice);
        }
        Ok(())
    }

    #[expect(clippy::cast_possible_truncation, reason = "to be compared with f32")]
    fn check_shares(&self, reflected: &[Branch], refracted: &[Branch]) -> Verdict {
        let of = |f: &dyn Fn(usize) -> f64| Rgb::new(f(0) as f32, f(1) as f32, f(2) as f32);
        let right = of(&|c| self.reflectance(self.relative(c)));
        let got: Rgb = reflected.iter().map(|b| b.share).sum();
        let (got_words, expected) = (format!("the reflected share {}", words::color(got)), words::color(right));
        let is = |color: Rgb| got.abs_diff_eq(color, 2e-4);
        if !is(right) {
            let schlick = |c: usize| {
                let n = self.relative(c);
                let f0 = ((n - 1.0) / (n + 1.0)) * ((n - 1.0) / (n + 1.0));
                let cosine = if n >= 1.0 { self.cosine() } else { self.behind(n).max(0.0).sqrt() };
                let away = 1.0 - cosine;
                f0 + (1.0 - f0) * away * away * away * away * away
            };
            let total = [0, 1, 2].map(|c| self.behind(self.relative(c)) < 0.0);
            let loses = (0..3).any(|c| total[c] && got[c] < 0.999);
            let (name, advice) = if loses {
                (
                    "total-reflection-dimmed",
                    "Where nothing is refracted, everything is reflected: F is 1 in that channel.",
                )
            } else if (0..3).any(|c| is(of(&|_| self.reflectance(self.relative(c))))) {
                ("one-reflectance", "All three channels have the reflectance of one of them. Each has its own index.")
            } else if is(Rgb::ONE) {
                ("shares-missing", "The reflected ray brings only a share of the light: F.")
            } else if is(Rgb::ONE - right) {
                ("shares-swapped", "F is the share that is reflected, and 1 − F the share that is refracted.")
            } else if is(of(&|c| self.reflectance(1.0 / self.relative(c)))) {
                (
                    "index-from-inside",
                    "This F belongs to a ray from the other side: from Side::Inside the index is 1/n.",
                )
            } else if is(of(&schlick)) {
                (
                    "approximated",
                    "This is Schlick's approximation. Here Fresnel's own equations are asked for: `fresnel::exact`.",
                )
            } else {
                (
                    "wrong-reflectance",
                    "F comes from Fresnel's equations: `fresnel::exact(cosine, n, 0.0)`, for each channel.",
                )
            };
            return self.finding(got_words, expected, name, advice);
        }
        let got: Rgb = refracted.iter().map(|b| b.share).sum();
        let right = Rgb::ONE - right;
        if !got.abs_diff_eq(right, 2e-4) {
            let (got, expected) = (words::color(got), words::color(right));
            let advice = "What is not reflected is refracted: in each channel both shares sum to 1.";
            return self.finding(format!("the refracted shares {got}"), expected, "energy", advice);
        }
        Ok(())
    }

    /// `side` is 1 for rays before the surface and −1 behind it.
    fn check_origins(&self, branches: &[Branch], side: f32) -> Verdict {
        for branch in branches {
            let above = side * (branch.ray.origin - self.hit.position).dot(self.hit.geometric_normal);
            let got = format!("a {:?} ray that starts {above:.1e} units above its side of the surface", branch.kind);
            let expected = "a little more than nothing";
            if above < 0.0 {
                let advice = "A reflected ray starts on the side to which `geometric_normal` points, a refracted one on the \
                              other side. Starting on the wrong side, it hits the same surface again.";
                return self.finding(got, expected, "starts-on-the-wrong-side", advice);
            }
            if above == 0.0 || above > 1e-2 {
                let advice = "Start rays at `Offset::Following.origin(hit, normal)`: so little above the surface that nothing \
                              is passed over, and enough not to hit it again.";
                return self.finding(got, expected, "wrong-offset", advice);
            }
            if branch.range != common::Interval::POSITIVE {
                let got = format!("{:?} with {}", branch.kind, common::exercise::words::range(branch.range));
                return self.finding(got, "range 0 < t < ∞", "wrong-range", "The new ray counts from its origin on.");
            }
        }
        Ok(())
    }
}
