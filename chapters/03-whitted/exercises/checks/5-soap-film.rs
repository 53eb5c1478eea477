//! Checks exercise 3.5, soap bubbles.

use common::{
    Interval, Rgb, Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying, words::range},
};
use ray_casting::{
    hit::{Hit, Side},
    material::Phong,
    ray::Ray,
};
use shadows::offset::Offset;
use whitted::{branches::Branch, probe::Kind};

use super::{
    dispersion::WAVELENGTHS,
    film::Question,
    film_mistakes::{Answered, is_near, named},
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
    let ask = |question: Question| {
        let q = question;
        #[expect(clippy::cast_possible_truncation, reason = "short numbers")]
        let [cosine, index, thickness, wavelength] = [q.cosine, q.index, q.thickness, q.wavelength].map(|x| x as f32);
        let got = f64::from(trying(|| q.words(), || answer(cosine, index, thickness, wavelength)));
        Answered { question, got }
    };
    let answers: Vec<_> = questions.into_iter().map(ask).collect();
    let Some(Answered { question, got }) = answers.iter().find(|a| !is_near(a.got, a.question.right())) else {
        return Ok(());
    };
    let (name, advice) = named(&answers, question, *got);
    let (got, expected) = (words::number(*got), words::number(question.right()));
    Err(Finding { tried: question.words(), got, expected, advice }.named(name))
}

fn branches(answer: fn(&Ray, &Hit, Rgb) -> [Option<Branch>; 2]) -> Verdict {
    // Plain numbers first.
    let ray = Ray::new(Vec3::ZERO, Vec3::new(0.6, 0.0, -0.8));
    let hit = Hit::new(&ray, 2.0, Vec3::Z);
    let color = Rgb::new(0.25, 0.125, 0.0);
    judge(&ray, &hit, color, answer)?;
    // As on a smooth mesh.
    judge(&ray, &hit.shaded_with(Vec3::new(0.28, 0.0, 0.96)), color, answer)?;
    let mut dice = Dice::new(38);
    for _ in 0..200 {
        let side = dice.choice([Side::Outside, Side::Inside]);
        let (direction, normal) = (dice.direction().normalize(), dice.direction().normalize());
        let normal = if direction.dot(normal) > 0.0 { -normal } else { normal };
        let ray = Ray::new(dice.point(4.0), direction);
        let hit = Hit { side, ..Hit::new(&ray, 2.0, normal) };
        // Not so much that the reflected ray would go through the film.
        let shading_normal = (normal + dice.choice([0.0, 0.2]) * dice.direction()).normalize();
        let mirrored = direction - 2.0 * shading_normal * direction.dot(shading_normal);
        let hit = if mirrored.dot(normal) > 0.05 { Hit { shading_normal, ..hit } } else { hit };
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
        let shading = words::triple(hit.shading_normal);
        let is_bent = hit.shading_normal != hit.geometric_normal;
        let shading = if is_bent { format!(", shading normal {shading}") } else { String::new() };
        let hit = words::hit(hit);
        format!("`branches` of a ray in direction {direction}, with {hit}{shading}, at t = 2, reflectance {color}")
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
        let kinds: Vec<_> = rays.iter().map(|b| format!("Kind::{:?}", b.kind)).collect();
        let expected = "one of Kind::Reflected and one of Kind::Refracted".into();
        if rays.len() > 1 {
            let advice =
                "The mirrored ray is of `Kind::Reflected`, the one that goes straight on of `Kind::Refracted`.";
            return finding(format!("two rays, of {}", kinds.join(" and ")), expected, "wrong-kind", advice);
        }
        let advice = "A film always sends on two rays, from either side: total reflection does not happen to what ends in air \
                      again.";
        return finding(format!("one ray, of {}", kinds.join("")), expected, "ray-missing", advice);
    };
    let direction = |b: &Branch| words::color(b.ray.direction);
    let mirrored_at = |normal: Vec3| ray.direction - 2.0 * normal * ray.direction.dot(normal);
    let mirrored = mirrored_at(hit.shading_normal);
    if reflected.ray.direction.abs_diff_eq(ray.direction, 1e-5) && straight.ray.direction.abs_diff_eq(mirrored, 1e-4) {
        let got = "the mirrored ray of Kind::Refracted, the straight one of Kind::Reflected".into();
        let advice = "The mirrored ray is of `Kind::Reflected`, the one that goes straight on of `Kind::Refracted`.";
        return finding(got, "the other way round".into(), "wrong-kind", advice);
    }
    if !reflected.ray.direction.abs_diff_eq(mirrored, 1e-4) {
        let is_flat = reflected.ray.direction.abs_diff_eq(mirrored_at(hit.geometric_normal), 1e-4);
        let (name, advice) = if is_flat {
            (
                "geometric-normal",
                "This is the mirror direction at `geometric_normal`. A smooth mesh mirrors at the `shading_normal`.",
            )
        } else {
            ("wrong-reflection", "`whitted::reflection::reflect` knows the mirror direction, at the `shading_normal`.")
        };
        return finding(direction(reflected), words::color(mirrored), name, advice);
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
    let origin = |normal: Vec3| Offset::Following.origin(hit, normal);
    // A few roundings, much less than the offset.
    let is_at = |ray: &Ray, place: Vec3| ray.origin.abs_diff_eq(place, 2.0 * f32::EPSILON * hit.magnitude);
    if !is_at(&reflected.ray, origin(hit.geometric_normal)) || reflected.range != Interval::POSITIVE {
        let above = (reflected.ray.origin - hit.position).dot(hit.geometric_normal);
        let place = match above {
            0.0 => "on the film itself".into(),
            x if x > 0.0 => format!("{x:.8} units before the film"),
            x => format!("{:.8} units behind the film", x.abs()),
        };
        let got = format!("the reflected ray begins {place}, {}", range(reflected.range));
        let distance = (origin(hit.geometric_normal) - hit.position).dot(hit.geometric_normal);
        let (name, advice) = if is_at(&reflected.ray, origin(hit.shading_normal)) {
            (
                "offset-by-shading-normal",
                "Where before and behind the film is, `geometric_normal` says: start from there, not from `shading_normal`.",
            )
        } else {
            (
                "wrong-start",
                "It starts at `Offset::Following.origin(hit, hit.geometric_normal)` and counts from there on.",
            )
        };
        return finding(got, format!("{distance:.8} units before it, range 0 < t < ∞"), name, advice);
    }
    // The other one: the old ray that counts from the hit on, or a new one that starts behind the film.
    let is_old = straight.ray == *ray && straight.range == Interval::new(hit.t, f32::INFINITY);
    let beyond = -(straight.ray.origin - hit.position).dot(hit.geometric_normal);
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
