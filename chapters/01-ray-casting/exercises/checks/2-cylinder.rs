//! Checks exercise 1.2, a capped cylinder.

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

/// The cylinder as it should be: what an endless tube and a slab have in common.
struct Ideal {
    base: Vec3,
    radius: f32,
    height: f32,
}

impl Reference for Ideal {
    fn crossings(&self, ray: &Ray) -> Option<Vec<Crossing>> {
        let (origin, d) = line(ray);
        let o = origin - self.base.as_dvec3();
        let (tube, slab) = (self.tube(o, d)?, self.slab(o, d)?);
        // The ray is inside the cylinder while it is inside both. One that meets a rim is no fair question.
        let is_near = |a: f64, b: f64| (a - b).abs() * d.length() < 0.02;
        let (enter, leave) = (tube[0].t.max(slab[0].t), tube[1].t.min(slab[1].t));
        let is_rim = is_near(enter, leave) || is_near(tube[0].t, slab[0].t) || is_near(tube[1].t, slab[1].t);
        if is_rim {
            return None;
        }
        if enter > leave {
            return Some(Vec::new());
        }
        let pick = |t: f64| tube.into_iter().chain(slab).find(|c| c.t == t);
        Some([pick(enter)?, pick(leave)?].to_vec())
    }

    fn words(&self) -> String {
        let Self { base, radius, height } = self;
        format!("the cylinder on {} with radius {radius} and height {height}", words::triple(*base))
    }

    fn outward_normal(&self) -> &'static str {
        "of the tube points away from the axis, that of the bottom cap down, that of the top cap up"
    }
}

impl Ideal {
    /// Where the ray enters and leaves the endless tube, never if need be; `None` if it only just touches it.
    fn tube(&self, o: DVec3, d: DVec3) -> Option<[Crossing; 2]> {
        let radius = f64::from(self.radius);
        let [o, d] = [o.with_y(0.0), d.with_y(0.0)];
        let wall = |t: f64| Crossing { t, outward: (o + d * t) / radius, part: "the tube" };
        let a = d.dot(d);
        // Half of the chord that the ray cuts, and how far it passes from the axis.
        let nearest = if a == 0.0 { 0.0 } else { -o.dot(d) / a };
        let away = (o + d * nearest).length();
        if (away - radius).abs() < 0.02 * radius || (a != 0.0 && a < 1e-5) {
            return None;
        }
        let half = if away > radius { f64::NAN } else { ((radius - away) * (radius + away) / a).sqrt() };
        Some(if half.is_nan() {
            [wall(f64::INFINITY), wall(f64::NEG_INFINITY)]
        } else {
            [wall(nearest - half), wall(nearest + half)]
        })
    }

    /// Where the ray enters and leaves the slab between the two planes; `None` if it runs along one of them.
    fn slab(&self, o: DVec3, d: DVec3) -> Option<[Crossing; 2]> {
        let height = f64::from(self.height);
        let bottom = Crossing { t: -o.y / d.y, outward: DVec3::NEG_Y, part: "the bottom cap" };
        let top = Crossing { t: (height - o.y) / d.y, outward: DVec3::Y, part: "the top cap" };
        if d.y != 0.0 {
            return Some(if d.y > 0.0 { [bottom, top] } else { [top, bottom] });
        }
        let (inside, middle) = ((0.0..=height).contains(&o.y), height / 2.0);
        let is_fair = ((o.y - middle).abs() - middle).abs() > 1e-3;
        let (enter, leave) =
            if inside { (f64::NEG_INFINITY, f64::INFINITY) } else { (f64::INFINITY, f64::NEG_INFINITY) };
        is_fair.then_some([Crossing { t: enter, ..bottom }, Crossing { t: leave, ..top }])
    }
}

/// Accept a capped cylinder, or name what is wrong with it. `make` takes the middle of the base, the radius and the
/// height.
pub(crate) fn check<S: Shape>(make: impl Fn(Vec3, f32, f32) -> S) -> Verdict {
    let trial = |base, radius, height| Trial {
        shape: make(base, radius, height),
        ideal: Ideal { base, radius, height },
        slack: Slack { t: 3e-3, normal: 1e-2 },
    };
    let drum = trial(Vec3::ZERO, 1.0, 2.0);
    let across = Ray::new(Vec3::new(0.25, 1.0, 5.0), -Vec3::Z);
    let down = Ray::new(Vec3::new(0.5, 5.0, 0.25), -Vec3::Y);
    if drum.is_never_hit(&[across, down]) {
        return Err(Diagnosis::not_started("Your cylinder is never hit: `intersect` returns `None` for every ray."));
    }
    tube(&drum, &across)?;
    caps(&drum, &down)?;
    both(&drum)?;
    trial(Vec3::new(2.0, -1.0, 1.0), 0.5, 3.0).probe(
        &Ray::new(Vec3::new(2.0, 1.0, 6.0), -Vec3::Z),
        Interval::POSITIVE,
        "base-ignored",
        "This cylinder does not stand in the origin. Subtract `base` from the ray's origin first.",
    )?;

    // Many rays at many cylinders.
    let mut dice = Dice::new(12);
    for _ in 0..200 {
        let cylinder = trial(dice.point(2.0), dice.number(0.5, 2.0), dice.number(0.5, 4.0));
        for _ in 0..20 {
            cylinder.compare(&dice::ray(&mut dice, 8.0, cylinder.ideal.base, 2.5))?;
        }
    }
    Ok(())
}

/// Rays for the mistakes one can make with the tube.
fn tube<S: Shape>(drum: &Trial<S, Ideal>, across: &Ray) -> Verdict {
    drum.probe(
        across,
        Interval::POSITIVE,
        "no-tube",
        "This ray meets the round wall half-way up. Only x and z stand in the tube's equation.",
    )?;
    for y in [2.5, -0.5] {
        let above = Ray::new(across.origin.with_y(y), across.direction);
        drum.probe(
            &above,
            Interval::POSITIVE,
            "endless-tube",
            "The tube ends: the hit's y must lie between 0 and height.",
        )?;
    }
    drum.probe(
        &Ray::new(Vec3::Y, Vec3::X),
        Interval::POSITIVE,
        "no-hit-from-inside",
        "This ray starts inside. The first root is behind it, so the second one counts.",
    )
}

/// Rays for the mistakes one can make with the caps.
fn caps<S: Shape>(drum: &Trial<S, Ideal>, down: &Ray) -> Verdict {
    let up = Ray::new(Vec3::new(0.5, -5.0, 0.25), Vec3::Y);
    let nearly_down = Ray::new(down.origin, down.direction.with_x(0.01));
    // The ranges end before the far cap.
    let near = Interval::new(0.0, 4.0);
    for (ray, range, name) in [
        (down, near, "no-top-cap"),
        (&nearly_down, near, "no-top-cap"),
        (&up, Interval::new(0.0, 6.0), "no-bottom-cap"),
    ] {
        drum.probe(
            ray,
            range,
            name,
            "This ray runs along the axis, or nearly, and meets a cap. A cap is the part of a plane whose points lie at most \
             `radius` from the axis; the caps' outward normals point down and up.",
        )?;
    }
    for origin in [down.origin.with_x(1.5), down.origin.with_x(-0.9).with_z(0.9)] {
        drum.probe(
            &Ray::new(origin, down.direction),
            Interval::POSITIVE,
            "cap-too-wide",
            "This ray passes beside the cylinder. A cap is a disc: its points lie at most `radius` from the axis, and \
             neither a square nor the whole plane.",
        )?;
    }
    Ok(())
}

/// Rays that meet the tube and a cap.
fn both<S: Shape>(drum: &Trial<S, Ideal>) -> Verdict {
    // From above onto the top cap, then out through the wall.
    let slanting = Ray::new(Vec3::new(-2.0, 4.0, 0.0), Vec3::new(1.0, -1.0, 0.0));
    let slower = Ray::new(Vec3::new(-1.5, 4.0, 0.0), Vec3::new(1.0, -2.0, 0.0));
    for ray in [&slanting, &slower] {
        drum.probe(
            ray,
            Interval::POSITIVE,
            "not-nearest",
            "This ray meets several parts. Collect the hits of the tube and of both caps, and of those in the range \
             take the one with the least `t`.",
        )?;
    }
    drum.probe(
        &Ray::new(Vec3::new(-0.5, 2.5, 0.0), Vec3::new(1.0, -1.0, 0.0)),
        Interval::new(1.0, 100.0),
        "far-root-forgotten",
        "The first root of the tube lies above the top and does not count. The second one does: try both.",
    )
}
