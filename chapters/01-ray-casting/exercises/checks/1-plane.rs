//! Checks exercise 1.1, a plane.

use common::{
    Interval, Vec3,
    exercise::{Diagnosis, Verdict, dice::Dice},
};
use ray_casting::{ray::Ray, shape::Shape};

use super::{
    crossing::{Crossing, Reference, line},
    dice,
    judge::{Slack, Trial},
    words,
};

/// The plane as it should be.
struct Ideal {
    point: Vec3,
    normal: Vec3,
}

impl Reference for Ideal {
    fn crossings(&self, ray: &Ray) -> Option<Vec<Crossing>> {
        let (origin, direction) = line(ray);
        let outward = self.normal.as_dvec3().normalize();
        let speed = direction.dot(outward);
        if speed == 0.0 {
            return Some(Vec::new());
        }
        let height = (origin - self.point.as_dvec3()).dot(outward);
        // Nearly along the plane, rounding moves the hit far away.
        let is_fair = speed.abs() > 0.02 * direction.length();
        is_fair.then(|| vec![Crossing { t: -height / speed, outward, part: "the plane" }])
    }

    fn words(&self) -> String {
        format!("the plane through {} with normal {}", words::triple(self.point), words::triple(self.normal))
    }

    fn outward_normal(&self) -> &'static str {
        "is the plane's own"
    }
}

/// Accept a plane, or name what is wrong with it. `make` takes the point and the normal.
pub(crate) fn check<S: Shape>(make: impl Fn(Vec3, Vec3) -> S) -> Verdict {
    let trial = |point, normal| Trial {
        shape: make(point, normal),
        ideal: Ideal { point, normal },
        slack: Slack { t: 2e-3, normal: 1e-4 },
    };
    let floor = trial(Vec3::ZERO, Vec3::Y);
    let high = Vec3::new(0.0, 3.0, 0.0);
    let [down, up] = [Ray::new(high, -Vec3::Y), Ray::new(high, Vec3::Y)];
    if floor.is_never_hit(&[down, up]) {
        return Err(Diagnosis::not_started("Your plane is never hit: `intersect` returns `None` for every ray."));
    }
    one_ray_for_each_mistake(&floor, &trial(Vec3::Y, Vec3::Y), &down, &up)?;

    // Many rays at many planes.
    let mut dice = Dice::new(11);
    for _ in 0..300 {
        let plane = trial(dice.point(4.0), dice.direction() * dice.choice([0.5, 1.0, 8.0]));
        for _ in 0..10 {
            plane.compare(&dice::ray(&mut dice, 8.0, plane.ideal.point, 3.0))?;
        }
    }
    Ok(())
}

/// The likely mistakes, each by the plainest ray that shows it.
fn one_ray_for_each_mistake<S: Shape>(
    floor: &Trial<S, Ideal>,
    raised: &Trial<S, Ideal>,
    down: &Ray,
    up: &Ray,
) -> Verdict {
    const BOTH_WAYS: Interval = Interval::new(-10.0, 10.0);
    if floor.shape.intersect(down, BOTH_WAYS).is_some_and(|hit| hit.t < 0.0) {
        let advice = "The sign of `t` is wrong: which of the two points is subtracted from which?";
        floor.probe(down, BOTH_WAYS, "wrong-sign", advice)?;
    }
    let advice = "The plane lies behind this ray, at a negative `t`. Ask `range.contains(t)`.";
    floor.probe(up, Interval::POSITIVE, "hits-behind", advice)?;
    floor.ask(down, Interval::POSITIVE)?;
    let advice = "This plane does not go through the origin of space. Does your formula use its `point`?";
    raised.probe(down, Interval::POSITIVE, "point-ignored", advice)?;
    let from_below = Ray::new(-down.origin, Vec3::Y);
    let advice = "This ray comes from below. A plane is hit from both sides; `Hit::new` turns the normal and notes the \
                  side.";
    floor.probe(&from_below, Interval::POSITIVE, "one-sided", advice)?;
    let advice = "Only what lies inside the range counts, and its ends do not. `range.contains(t)` knows that.";
    for range in [Interval::new(0.0, 3.0), Interval::new(3.0, 10.0)] {
        floor.probe(down, range, "range-not-open", advice)?;
    }

    let advice = "A ray along the plane never meets it, and a ray inside the plane has no first hit. What does your \
                  division give here?";
    for origin in [down.origin, -down.origin, Vec3::ZERO] {
        for range in [Interval::POSITIVE, BOTH_WAYS] {
            floor.probe(&Ray::new(origin, Vec3::X), range, "parallel", advice)?;
        }
    }
    let advice = "This direction is short, but not parallel to the plane. Directions may have any length: only a \
                  product of exactly 0 is parallel.";
    floor.probe(&Ray::new(down.origin, -Vec3::Y * 1e-5), Interval::POSITIVE, "fixed-epsilon", advice)?;
    Ok(())
}
