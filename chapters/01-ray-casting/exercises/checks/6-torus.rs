//! Checks exercise 1.6, a torus.

use common::{
    Interval, Vec3,
    exercise::{Diagnosis, Verdict, dice::Dice},
};
use glam::DVec3;
use ray_casting::{ray::Ray, shape::Shape};

use super::{
    crossing::{Crossing, Reference, line},
    dice,
    judge::{Slack, Trial},
    words,
};

/// The torus as it should be, found by walking along the ray in small steps.
struct Ideal {
    center: Vec3,
    major: f32,
    minor: f32,
}

impl Ideal {
    /// Steps of the walk across the sphere around the torus.
    const STEPS: u32 = 1500;

    /// Square of the distance from the circle in the middle of the tube, less that of the surface; and its gradient.
    fn value(&self, p: DVec3) -> f64 {
        let (major, minor) = (f64::from(self.major), f64::from(self.minor));
        let across = (p.x * p.x + p.z * p.z).sqrt() - major;
        across * across + p.y * p.y - minor * minor
    }

    /// From the nearest point of that circle to `p`, made a unit vector.
    fn outward(&self, p: DVec3) -> DVec3 {
        let middle = p.with_y(0.0).normalize_or_zero() * f64::from(self.major);
        (p - middle).normalize_or_zero()
    }
}

impl Reference for Ideal {
    fn crossings(&self, ray: &Ray) -> Option<Vec<Crossing>> {
        let (origin, d) = line(ray);
        let o = origin - self.center.as_dvec3();
        let shift = -o.dot(d) / d.dot(d);
        let nearest = o + d * shift;
        let (bound, minor) = (f64::from(self.major) + f64::from(self.minor), f64::from(self.minor));
        if nearest.length() > bound {
            // Where the surface is nearest to the ray it may still touch the sphere.
            return (nearest.length() > 1.01 * bound).then(Vec::new);
        }
        // Half of the way through the sphere, and a little more, as a ray parameter.
        let half = 1.01 * ((bound * bound - nearest.length_squared()) / d.dot(d)).sqrt() + 1e-3 * bound / d.length();
        let at = |step: u32| half * (2.0 * f64::from(step) / f64::from(Self::STEPS) - 1.0);
        let value = |u: f64| self.value(nearest + d * u);
        let mut crossings = Vec::new();
        let mut before = [f64::INFINITY, value(at(0))];
        for step in 1..=Self::STEPS {
            let next = value(at(step));
            let [earlier, last] = before;
            // A value that comes near zero and turns back may hide two crossings.
            let turns = last.abs() < earlier.abs() && last.abs() < next.abs() && (last < 0.0) == (next < 0.0);
            if turns && (earlier < 0.0) == (last < 0.0) && last.abs() < 0.05 * minor * minor {
                return None;
            }
            if (last < 0.0) != (next < 0.0) {
                let u = bisect(value, at(step - 1), at(step));
                let outward = self.outward(nearest + d * u);
                crossings.push(Crossing { t: u + shift, outward, part: "the torus" });
            }
            before = [last, next];
        }
        let is_fair = crossings.iter().all(|c| c.cosine(ray).abs() > 0.05);
        is_fair.then_some(crossings)
    }

    fn words(&self) -> String {
        let Self { center, major, minor } = self;
        format!("the torus around {} with major radius {major} and minor radius {minor}", words::triple(*center))
    }

    fn outward_normal(&self) -> &'static str {
        "points from the nearest point of the circle in the middle of the tube to the hit"
    }
}

/// Where `value` changes its sign between `low` and `high`.
fn bisect(value: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let starts_negative = value(low) < 0.0;
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        if (value(middle) < 0.0) == starts_negative { low = middle } else { high = middle }
    }
    low
}

/// Accept a torus, or name what is wrong with it. `make` takes the center, the major and the minor radius.
pub(crate) fn check<S: Shape>(make: impl Fn(Vec3, f32, f32) -> S) -> Verdict {
    let trial = |center, major, minor| Trial {
        shape: make(center, major, minor),
        ideal: Ideal { center, major, minor },
        slack: Slack { t: 2e-3, normal: 1e-2 },
    };
    let ring = trial(Vec3::ZERO, 2.0, 0.5);
    let down = Ray::new(Vec3::new(2.0, 3.0, 0.0), -Vec3::Y);
    let across = Ray::new(Vec3::new(0.1, 0.05, 5.0), -Vec3::Z);
    if ring.is_never_hit(&[down, across]) {
        return Err(Diagnosis::not_started("Your torus is never hit: `intersect` returns `None` for every ray."));
    }
    four_roots(&ring, &down, &across)?;
    let away = trial(Vec3::new(3.0, -1.0, 1.0), 1.0, 0.25);
    let advice = "This torus is not around the origin of space. Subtract `center` from the ray's origin first.";
    away.probe(&Ray::new(Vec3::new(4.0, 3.0, 1.0), -Vec3::Y), Interval::POSITIVE, "center-ignored", advice)?;

    let mut dice = Dice::new(16);
    // An f32 near 1000 has steps of 6e-5, and there are several roundings.
    far(&Trial { slack: Slack { t: 2e-2, normal: 5e-2 }, ..ring }, &mut dice)?;

    // Many rays at many tori, thin and thick.
    for _ in 0..60 {
        let major = dice.number(0.5, 2.0);
        let torus = trial(dice.point(2.0), major, major * dice.choice([0.1, 0.25, 0.5, 0.9]));
        for _ in 0..20 {
            torus.compare(&dice::ray(&mut dice, 6.0, torus.ideal.center, 2.0))?;
        }
    }
    Ok(())
}

/// One ray for each likely mistake. The ray `across` meets the ring four times.
fn four_roots<S: Shape>(ring: &Trial<S, Ideal>, down: &Ray, across: &Ray) -> Verdict {
    ring.probe(
        down,
        Interval::POSITIVE,
        "wrong-first-hit",
        "This ray meets the ring from straight above. The torus lies flat: its axis is y. Put t = 2.5 into your quartic by \
         hand: it must be 0 there.",
    )?;
    let through_hole = Ray::new(Vec3::new(0.3, 3.0, 0.2), -Vec3::Y);
    let advice = "This ray goes through the hole. With no sign change and no root there is no hit.";
    ring.probe(&through_hole, Interval::POSITIVE, "hole-filled", advice)?;
    let equator = Ray::new(Vec3::X * 5.0, -Vec3::X);
    let advice = "This ray meets the ring at its outermost place. If you look for roots inside a sphere around the torus, make \
                  it a little too large: at its very edge, rounding decides which sign the quartic has.";
    ring.probe(&equator, Interval::POSITIVE, "rim-lost", advice)?;
    let advice = "This ray meets the ring four times, and the nearest hit in the range counts. Sort the roots, or look for \
                  them from the near end on.";
    ring.probe(across, Interval::POSITIVE, "not-nearest", advice)?;
    for (min, which) in [(3.0, "second"), (4.0, "third"), (7.0, "fourth")] {
        let advice = format!(
            "This range begins behind some of the four hits: the {which} one is the first that counts. All roots must be \
             found, also those after the first turn of the quartic."
        );
        ring.probe(across, Interval::new(min, 100.0), "root-lost", &advice)?;
    }
    let inside = Ray::new(Vec3::new(2.0, 0.1, 0.0), Vec3::X);
    ring.probe(
        &inside,
        Interval::POSITIVE,
        "no-hit-from-inside",
        "This ray starts inside the tube and must leave it.",
    )?;
    ring.ask(&Ray::new(Vec3::new(0.0, 0.0, 0.1), Vec3::Z), Interval::POSITIVE)
}

/// Rays from far away, where a careless quartic loses all its digits.
fn far<S: Shape>(ring: &Trial<S, Ideal>, dice: &mut Dice) -> Verdict {
    for _ in 0..300 {
        let (target, toward) = (dice.point(2.5).with_y(dice.number(-0.5, 0.5)), dice.direction().normalize());
        let from = |distance: f32| Ray::new(target + toward * distance, -toward);
        // A ray that comes in flat magnifies the errors of its own numbers.
        let is_steep =
            |ray: &Ray| ring.ideal.crossings(ray).is_some_and(|c| c.iter().all(|c| c.cosine(ray).abs() > 0.2));
        let far = from(dice.choice([30.0, 300.0, 1000.0]));
        if !is_steep(&far) {
            continue;
        }
        // What is wrong from nearby too has another reason.
        ring.ask(&from(5.0), Interval::POSITIVE)?;
        let advice = "From nearby such a ray finds its hit, from far away it does not: the quartic's numbers become so great \
                      that they cancel. Move the ray's origin to the point nearest to the center before you multiply anything, \
                      and add the way back to t.";
        ring.probe(&far, Interval::POSITIVE, "far-away", advice)?;
    }
    Ok(())
}
