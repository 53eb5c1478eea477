//! Checks exercise 3.3, dispersion.

use common::{
    Rgb, Vec3,
    exercise::{Diagnosis, Verdict, dice::Dice},
};
use ray_casting::{
    hit::{Hit, Side},
    material::Phong,
    ray::Ray,
};
use shadows::offset::Offset;
use whitted::{branches::Branch, probe::Kind};

use super::{
    cauchy::cauchy,
    prism::{FLINT, PARTLY, Question, WIDE},
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
        // As on a smooth mesh: brightness and directions by another normal than that of the surface itself.
        Question::new(45.0, Side::Outside, FLINT).shaded_with(Vec3::new(0.28, 0.96, 0.0)),
        Question::new(20.0, Side::Inside, FLINT).shaded_with(Vec3::new(0.0, -0.96, 0.28)),
    ] {
        question.check(&answer)?;
    }
    let mut dice = Dice::new(34);
    for _ in 0..1000 {
        let side = dice.choice([Side::Outside, Side::Inside]);
        let index = dice.choice([FLINT, WIDE, Rgb::new(1.33, 1.34, 1.345)]);
        let question = Question::random(&mut dice, side, index);
        let bent = dice.choice([0.0, 0.3]) * dice.direction();
        let outward = if side == Side::Inside { -1.0 } else { 1.0 } * question.hit.geometric_normal;
        let question = question.shaded_with(outward + bent);
        if question.is_fair() {
            question.check(&answer)?;
        }
    }
    Ok(())
}

impl Question {
    fn check(&self, answer: &Answer) -> Verdict {
        let rays: Vec<_> = self.ask(answer).into_iter().flatten().collect();
        for Branch { ray, share, kind, .. } in &rays {
            let got = format!("a ray in direction {}, share {}", words::color(ray.direction), words::color(*share));
            let is_number = [ray.direction, *share, ray.origin].map(Vec3::is_finite);
            if is_number != [true; 3] {
                let advice = match is_number {
                    [false, ..] => "The direction is no number. Was there none, and was one computed all the same?",
                    [_, false, _] => {
                        "The direction consists of numbers, but the share does not. `exact` always \
                                      answers one for a cosine and an index that are numbers."
                    }
                    _ => "The origin is no number.",
                };
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
        self.check_kinds(&rays)?;
        let (reflected, refracted): (Vec<_>, Vec<_>) = rays.into_iter().partition(|b| b.kind == Kind::Reflected);
        self.check_reflected(&reflected)?;
        self.check_channels(&refracted)?;
        self.check_shares(&reflected, &refracted)?;
        self.check_origins(&reflected, 1.0)?;
        self.check_origins(&refracted, -1.0)
    }

    /// Rays that go where they should, but are told to be of the other kind.
    fn check_kinds(&self, rays: &[Branch]) -> Verdict {
        let mirrored = self.mirrored();
        let is_mirrored = |b: &Branch| b.ray.direction.abs_diff_eq(mirrored, 1e-4);
        let refracted = [0, 1, 2].map(|c| self.refracted(self.relative(c)));
        let is_refracted =
            |b: &Branch| refracted.iter().flatten().any(|right| b.ray.direction.abs_diff_eq(*right, 1e-4));
        let has_mirrored = rays.iter().any(|b| b.kind == Kind::Reflected && is_mirrored(b));
        for branch in rays {
            let right = match branch.kind {
                Kind::Reflected if is_refracted(branch) => "Refracted",
                Kind::Refracted if is_mirrored(branch) && !has_mirrored => "Reflected",
                _ => continue,
            };
            let got = format!("in direction {} a ray of Kind::{:?}", words::color(branch.ray.direction), branch.kind);
            let advice = "The direction is right, but the kind is not: `Kind::Reflected` is for the mirror direction, \
                          `Kind::Refracted` for what goes on behind the surface.";
            return self.finding(got, format!("a ray of Kind::{right}"), "wrong-kind", advice);
        }
        Ok(())
    }

    fn check_reflected(&self, reflected: &[Branch]) -> Verdict {
        let right = self.mirrored();
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
                if one.ray.direction.abs_diff_eq(self.flat().mirrored(), 1e-4) {
                    return self.finding(got, expected, "geometric-normal", BENT);
                }
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
        let count = directions.iter().flatten().count();
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
                let is_there =
                    refracted.len() >= count && refracted.iter().any(|b| b.share.abs().max_element() <= 1e-6);
                if is_there {
                    let got = format!("{} refracted rays, but with the share 0 for {name}", refracted.len());
                    let advice = "1 − F is 0 here, so F came out as 1. That is what `exact` answers for a cosine of zero or \
                                  less. The cosine is −d·N, and N faces the ray already: has a sign been lost, or has the \
                                  normal been turned once more because of the side?";
                    return self.finding(got, expected, "nothing-refracted", advice);
                }
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
            let flat = self.flat().refracted(self.relative(c));
            if flat.is_some_and(|flat| direction.abs_diff_eq(flat, 1e-4)) {
                return self.finding(got, expected, "geometric-normal", BENT);
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
        if refracted.len() > count {
            let got = format!("{} refracted rays", refracted.len());
            let advice = "A channel beyond its critical angle sends no refracted ray, not even one with a share of zero: there \
                          is no direction for it.";
            return self.finding(got, count.to_string(), "invented-direction", advice);
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
            let mean = (right.element_sum() / 3.0) * Rgb::ONE;
            let missing = (0..3).any(|c| got[c] == 0.0 && is(right * (Rgb::ONE - Rgb::AXES[c])));
            let flat = self.flat();
            let (name, advice) = if is(of(&|c| flat.reflectance(flat.relative(c)))) {
                ("geometric-normal", BENT)
            } else if is(mean) {
                ("mean-reflectance", "This is the mean of F over the three channels. Each channel has its own share.")
            } else if missing {
                ("channel-missing", "One channel of the reflected share is zero. The reflected ray carries all three.")
            } else if is(right / 2.0) || is(right / 3.0) {
                (
                    "share-divided",
                    "This is a part of F only. The reflected ray is the only one of its kind: its share is all of F.",
                )
            } else if loses {
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
                    "F is `exact(cosine, n, 0.0)` for each channel, and nothing else. With which cosine and which n was it called \
                     here, and what was done to its answer?",
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
        let hit = &self.hit;
        let origin = |offset: Offset, normal| offset.origin(hit, side * normal);
        let right = origin(Offset::Following, hit.geometric_normal);
        // A few roundings, much less than the offset.
        let is = |a: Vec3, b: Vec3| a.abs_diff_eq(b, 2.0 * f32::EPSILON * hit.magnitude);
        for branch in branches {
            let start = branch.ray.origin;
            let above = (start - hit.position).dot(hit.geometric_normal);
            if !is(start, right) {
                let place = match above {
                    0.0 => "on the surface itself".into(),
                    x if x > 0.0 => format!("{x:.8} units before the surface"),
                    x => format!("{:.8} units behind the surface", x.abs()),
                };
                let (name, advice) = if is(start, origin(Offset::Bits, hit.geometric_normal)) {
                    ("offset-by-bits", "This is `Offset::Bits`. `Offset::Following` is asked for.")
                } else if is(start, origin(Offset::Following, hit.shading_normal)) {
                    (
                        "offset-by-shading-normal",
                        "The shading normal only says how a surface shines and where rays turn. Where before and behind \
                         it is, `geometric_normal` says.",
                    )
                } else if side * above < 0.0 {
                    (
                        "starts-on-the-wrong-side",
                        "A reflected ray starts on the side to which `geometric_normal` points, a refracted one on the \
                         other side. Starting on the wrong side, it hits the same surface again.",
                    )
                } else {
                    (
                        "wrong-offset",
                        "Start rays at `Offset::Following.origin(hit, normal)`: so little away from the surface that nothing \
                         is passed over, and enough not to hit it again.",
                    )
                };
                let got = format!("a {:?} ray that starts {place}", branch.kind);
                let side = if side > 0.0 { "before" } else { "behind" };
                let distance = (right - hit.position).dot(hit.geometric_normal).abs();
                return self.finding(got, format!("{distance:.8} units {side} it"), name, advice);
            }
            if branch.range != common::Interval::POSITIVE {
                let got = format!("{:?} with {}", branch.kind, common::exercise::words::range(branch.range));
                return self.finding(got, "range 0 < t < ∞", "wrong-range", "The new ray counts from its origin on.");
            }
        }
        Ok(())
    }
}

/// What to say where the surface's own normal was taken for the one to shade with.
const BENT: &str = "This belongs to `geometric_normal`. Directions and F come from `shading_normal`, which differs from it on smooth \
                    meshes.";
