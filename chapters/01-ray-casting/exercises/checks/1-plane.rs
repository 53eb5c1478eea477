//! Checks exercise 1.1, a plane.

use common::{
    Interval, Vec3,
    exercise::{Diagnosis, Verdict},
};
use ray_casting::{ray::Ray, shape::Shape};

use super::{
    crossing::{Crossing, Reference, line},
    dice::Dice,
    judge::{Slack, compare, probe},
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
        // Nearly along the plane, rounding moves the hit far away. Those rays are probed one by one.
        let is_fair = speed.abs() > 0.02 * direction.length();
        is_fair.then(|| vec![Crossing { t: -height / speed, outward, part: "the plane" }])
    }

    fn words(&self) -> String {
        format!("the plane through {} with normal {}", words::triple(self.point), words::triple(self.normal))
    }
}

const SLACK: Slack = Slack { t: 2e-3, normal: 1e-4 };

/// Accept a plane, or name what is wrong with it. `make` takes the point and the normal.
pub(crate) fn check<S: Shape>(make: impl Fn(Vec3, Vec3) -> S) -> Verdict {
    let pair = |point: Vec3, normal: Vec3| (make(point, normal), Ideal { point, normal });
    let (floor, ideal) = pair(Vec3::ZERO, Vec3::Y);
    let down = Ray::new(Vec3::new(0.0, 3.0, 0.0), -Vec3::Y);
    let both_ways = Interval::new(-10.0, 10.0);
    if [down, Ray::new(-down.origin, Vec3::Y)].iter().all(|ray| floor.intersect(ray, both_ways).is_none()) {
        return Err(Diagnosis::not_started("Your plane is never hit: `intersect` returns `None` for every ray."));
    }

    // One ray for each likely mistake.
    let sign = ("wrong-sign", "Look at the signs: which of the two points is subtracted from which?");
    if floor.intersect(&down, both_ways).is_some_and(|hit| hit.t == -3.0) {
        probe(&floor, &ideal, (&down, both_ways), sign, SLACK)?;
    }
    let (raised, ideal_raised) = pair(Vec3::Y, Vec3::Y);
    let point = ("point-ignored", "This plane does not go through the origin. Does your formula use its `point`?");
    probe(&floor, &ideal, (&down, Interval::POSITIVE), ("wrong-t", "Work this ray out on paper first."), SLACK)?;
    probe(&raised, &ideal_raised, (&down, Interval::POSITIVE), point, SLACK)?;
    let behind = ("hits-behind", "The plane lies behind this ray, at a negative `t`. Ask `range.contains(t)`.");
    probe(&floor, &ideal, (&Ray::new(down.origin, Vec3::Y), Interval::POSITIVE), behind, SLACK)?;
    let one_sided = ("one-sided", "A plane is hit from both sides. `Hit::new` turns the normal and notes the side.");
    probe(&floor, &ideal, (&Ray::new(-down.origin, Vec3::Y), Interval::POSITIVE), one_sided, SLACK)?;
    let parallel = ("parallel", "A ray along the plane never meets it, and a ray inside it has no first hit.");
    for origin in [down.origin, -down.origin, Vec3::ZERO] {
        for range in [Interval::POSITIVE, both_ways] {
            probe(&floor, &ideal, (&Ray::new(origin, Vec3::X), range), parallel, SLACK)?;
        }
    }
    let epsilon = ("fixed-epsilon", "The direction is short, but not parallel. Only a product of exactly 0 is parallel.");
    probe(&floor, &ideal, (&Ray::new(down.origin, -Vec3::Y * 1e-5), Interval::POSITIVE), epsilon, SLACK)?;
    let open = ("range-not-open", "The range is open: its ends do not count. `range.contains(t)` knows that.");
    for range in [Interval::new(0.0, 3.0), Interval::new(3.0, 10.0)] {
        if let Some(hit) = floor.intersect(&down, range) {
            return Err(super::judge::Question { target: &ideal.words(), ray: &down, range }.mistake(
                open.0,
                words::answer(Some(hit)),
                "no hit".into(),
                open.1,
            ));
        }
    }

    // Many rays at many planes.
    let mut dice = Dice::new(11);
    for _ in 0..300 {
        let (plane, ideal) = pair(dice.point(4.0), dice.direction() * dice.choice([0.5, 1.0, 8.0]));
        for _ in 0..10 {
            compare(&plane, &ideal, &dice.ray(8.0, ideal.point, 3.0), SLACK)?;
        }
    }
    Ok(())
}
