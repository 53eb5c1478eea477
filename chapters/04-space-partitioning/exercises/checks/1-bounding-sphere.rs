//! Checks exercise 4.1, a bounding sphere.

use common::{
    Interval, Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use glam::DVec3;
use ray_casting::ray::Ray;

use super::words;

/// A ball around a part of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ball {
    /// Center, in scene units.
    pub(crate) center: Vec3,
    /// Radius, in scene units.
    pub(crate) radius: f32,
}

/// Accept two functions, or name what is wrong with them.
pub(crate) fn check(around: impl Fn(&[Vec3]) -> Ball, may_hit: impl Fn(&Ball, &Ray, Interval) -> bool) -> Verdict {
    // Behind references: so all answers share one copy of the steps.
    steps(&around, &may_hit)
}

/// The steps of the check.
fn steps(around: &dyn Fn(&[Vec3]) -> Ball, may_hit: &dyn Fn(&Ball, &Ray, Interval) -> bool) -> Verdict {
    let toward = Ray::new(Vec3::Z * 3.0, -Vec3::Z);
    let unit = Ball { center: Vec3::ZERO, radius: 1.0 };
    let pair = [Vec3::ZERO, Vec3::X * 2.0];
    let beside = Ray::new(Vec3::new(5.0, 0.0, 3.0), -Vec3::Z);
    let says_yes = [&toward, &beside].map(|ray| answer(&may_hit, &unit, ray, Interval::POSITIVE)) == [true; 2];
    if says_yes && made(&around, &pair) == (Ball { center: Vec3::ZERO, radius: 0.0 }) {
        return Err(Diagnosis::not_started(
            "`around` returns a ball without size, and `may_hit` returns `true` for every ray, so that nothing is saved.",
        ));
    }
    balls(&around)?;
    answers(&may_hit)?;
    let mut dice = Dice::new(41);
    for _ in 0..200 {
        together(&around, &may_hit, &mut dice)?;
    }
    Ok(())
}

fn cloud_words(points: &[Vec3]) -> String {
    let some: Vec<_> = points.iter().take(8).map(|p| words::triple(*p)).collect();
    let more = if points.len() > 8 { format!(" and {} more", points.len() - 8) } else { String::new() };
    format!("a ball around the points {}{more}", some.join(", "))
}

fn made(around: &impl Fn(&[Vec3]) -> Ball, points: &[Vec3]) -> Ball {
    trying(|| cloud_words(points), || around(points))
}

fn answer(may_hit: &impl Fn(&Ball, &Ray, Interval) -> bool, ball: &Ball, ray: &Ray, range: Interval) -> bool {
    trying(|| tried(ball, ray, range), || may_hit(ball, ray, range))
}

fn ball_words(ball: &Ball) -> String {
    format!("the ball around {} with radius {}", words::triple(ball.center), ball.radius)
}

fn tried(ball: &Ball, ray: &Ray, range: Interval) -> String {
    format!("{}, {}, at {}", words::ray(ray), words::range(range), ball_words(ball))
}

// `around`.

/// Clouds of points.
fn balls(around: &impl Fn(&[Vec3]) -> Ball) -> Verdict {
    let cube: Vec<_> = (0..8).map(|i| Vec3::new((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2) as f32) * 2.0).collect();
    cloud(around, &[Vec3::ZERO, Vec3::X * 2.0])?;
    cloud(around, &[Vec3::new(1.0, 2.0, 3.0), Vec3::new(1.0, -4.0, 3.0), Vec3::new(1.0, 0.0, 3.0)])?;
    cloud(around, &cube)?;
    // Most of the points at one end.
    let comet: Vec<_> =
        cube.iter().map(|p| *p * 0.1).chain([Vec3::new(6.0, 1.0, 0.0), Vec3::new(3.0, 0.3, 0.0)]).collect();
    cloud(around, &comet)?;
    let mut dice = Dice::new(411);
    for _ in 0..200 {
        let (place, size) = (dice.point(1.0) * dice.choice([0.0, 3.0, 90.0]), dice.choice([0.2, 1.0, 7.0]));
        let stretched = Vec3::new(1.0, dice.choice([1.0, 0.1]), 1.0);
        let count = dice.choice([2, 3, 12, 60]);
        let points: Vec<_> =
            (0..count).map(|i| place + (dice.point(1.0) + Vec3::X * (i % 2) as f32) * stretched * size).collect();
        cloud(around, &points)?;
    }
    Ok(())
}

/// The ball around one cloud.
fn cloud(around: &impl Fn(&[Vec3]) -> Ball, points: &[Vec3]) -> Verdict {
    let ball = made(around, points);
    let min = points.iter().copied().fold(Vec3::INFINITY, Vec3::min).as_dvec3();
    let max = points.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max).as_dvec3();
    let middle = (min + max) / 2.0;
    let reach = |center: DVec3| points.iter().map(|point| point.as_dvec3().distance(center)).fold(0.0_f64, f64::max);
    let (enough, center, radius) = (reach(middle), ball.center.as_dvec3(), f64::from(ball.radius));
    let fault = |name, advice: &str| {
        let expected = format!(
            "a ball that holds all points, and of radius {} at most: {} is enough around {}",
            words::number(enough * 1.01),
            words::number(enough),
            words::triple(middle.as_vec3())
        );
        Err(Finding { tried: cloud_words(points), got: ball_words(&ball), expected, advice: advice.into() }.named(name))
    };
    if !(ball.center.is_finite() && ball.radius.is_finite()) {
        return fault("not-a-number", "A ball needs a finite center and a finite radius. What was divided by zero?");
    }
    let needed = reach(center);
    if needed > radius {
        let advice = "All points are inside but for rounding. A point on the rim must not be lost: make the radius larger by \
                      one thousandth of itself.";
        if needed < radius * 1.0001 {
            return fault("no-room", advice);
        }
        let advice = "A point lies outside of this ball. The radius is the greatest distance from the center to any of the \
                      points; half of the longest side of the box is less.";
        return fault("point-outside", advice);
    }
    if radius > 1.01 * enough {
        let mean = points.iter().map(|p| p.as_dvec3()).sum::<DVec3>() / points.len() as f64;
        if (needed - radius).abs() < 0.011 * radius && center.distance(mean) < 1e-3 * radius {
            let advice = "The mean of all points lies where most of them are, and that is not the middle. Take the center of \
                          the smallest box around them.";
            return fault("mean-center", advice);
        }
        let diagonal = (max - min).length();
        if (radius - diagonal / 2.0).abs() < 0.011 * radius {
            let advice = "This is the ball around the box around the points. The corners of the box are no points: the radius \
                          is the greatest distance to one of the points themselves.";
            return fault("around-the-box", advice);
        }
        return fault("too-large", "This ball is larger than it must be, so rays are tested in vain.");
    }
    Ok(())
}

// `may_hit`.

/// The least distance of a way from the center of a ball, and the distance of the whole line.
fn distances(ball: &Ball, ray: &Ray, range: Interval) -> [f64; 2] {
    let (direction, to_center) = (ray.direction.as_dvec3(), ball.center.as_dvec3() - ray.origin.as_dvec3());
    let middle = to_center.dot(direction) / direction.length_squared();
    let on_way = middle.clamp(f64::from(range.min), f64::from(range.max));
    [on_way, middle].map(|t| (to_center - direction * t).length())
}

/// Name and advice.
type Mistake<'a> = (&'static str, &'a str);

/// The mistake, if the answer is wrong. Ways for which rounding decides are passed over.
fn probe(
    may_hit: &impl Fn(&Ball, &Ray, Interval) -> bool,
    ball: &Ball,
    ray: &Ray,
    range: Interval,
    (name, advice): Mistake,
) -> Verdict {
    let [distance, _] = distances(ball, ray, range);
    let radius = f64::from(ball.radius);
    let got = answer(may_hit, ball, ray, range);
    if (distance - radius).abs() < 0.002 * radius || got == (distance < radius) {
        return Ok(());
    }
    let expected = format!("{}: the way comes as near as {} to the center", !got, words::number(distance));
    Err(Finding { tried: tried(ball, ray, range), got: got.to_string(), expected, advice: advice.into() }.named(name))
}

/// Balls and ways of all kinds.
fn answers(may_hit: &impl Fn(&Ball, &Ray, Interval) -> bool) -> Verdict {
    let unit = Ball { center: Vec3::ZERO, radius: 1.0 };
    let toward = Ray::new(Vec3::Z * 3.0, -Vec3::Z);
    let at_unit =
        |ray: &Ray, (min, max): (f32, f32), mistake| probe(may_hit, &unit, ray, Interval::new(min, max), mistake);
    const FAR: f32 = f32::INFINITY;
    let advice = "This ray goes straight through the ball.";
    for range in [(0.0, 9.0), (0.0, FAR)] {
        at_unit(&toward, range, ("missed", advice))?;
    }
    let advice = "This ray passes the ball by: its nearest point to the center lies outside.";
    for range in [(0.0, 9.0), (0.0, FAR)] {
        at_unit(&Ray::new(Vec3::new(1.5, 0.0, 3.0), -Vec3::Z), range, ("hit-beside", advice))?;
    }
    let advice = "The ball is solid. This way begins and ends inside, and what the ball holds may be there. This is not the \
                  question of a shadow ray at a surface.";
    for range in [(2.2, 3.8), (2.2, 2.8), (3.2, 3.8)] {
        at_unit(&toward, range, ("hollow-ball", advice))?;
    }
    let advice = "This way ends inside the ball, before it comes to the point that is nearest to the center.";
    for end in [2.3, 2.8] {
        at_unit(&toward, (0.0, end), ("ends-inside", advice))?;
    }
    let advice = "This way begins inside the ball, behind the point that is nearest to the center.";
    for begin in [3.2, 3.8] {
        at_unit(&toward, (begin, 9.0), ("begins-inside", advice))?;
    }
    at_unit(&Ray::new(Vec3::Z * 0.5, Vec3::Z), (0.0, FAR), ("begins-inside", advice))?;
    let advice = "The range ends in front of the ball. Of the whole line, only what lies in the range counts.";
    at_unit(&toward, (0.0, 1.5), ("beyond-the-end", advice))?;
    let advice = "The range begins behind the ball. Of the whole line, only what lies in the range counts.";
    at_unit(&toward, (5.0, 9.0), ("before-the-begin", advice))?;
    at_unit(&Ray::new(Vec3::Z * 3.0, Vec3::Z), (0.0, FAR), ("before-the-begin", advice))?;
    let advice = "This range begins before the ray's origin. The range says what counts, not `t > 0`.";
    at_unit(&Ray::new(Vec3::Z * 3.0, Vec3::Z), (-9.0, 1.0), ("only-positive", advice))?;
    at_unit(&Ray::new(Vec3::Z * 3.0, Vec3::Z), (-2.5, FAR), ("only-positive", advice))?;
    lengths(may_hit)?;
    let advice = "This ball does not stand in the origin of space, or its radius is not 1. A squared distance is compared with the \
                  squared radius.";
    for (center, radius) in [(Vec3::new(2.0, 0.0, -1.0), 1.0), (Vec3::ZERO, 2.0), (Vec3::ZERO, 0.5)] {
        for x in [0.0, 0.3, 0.6, 1.7, 2.4] {
            let ball = Ball { center, radius };
            let ray = Ray::new(Vec3::new(x, 0.0, 3.0), -Vec3::Z);
            probe(may_hit, &ball, &ray, Interval::POSITIVE, ("center-or-radius", advice))?;
        }
    }
    let mut dice = Dice::new(412);
    for _ in 0..4000 {
        let ball = Ball { center: dice.point(4.0), radius: dice.choice([0.1, 0.5, 1.0, 3.0]) };
        let (origin, aim) = (dice.point(6.0), ball.center + dice.point(1.4 * ball.radius));
        let ray = Ray::new(origin, (aim - origin + Vec3::splat(0.001)) * dice.choice([0.25, 1.0, 4.0]));
        let (min, length) = (dice.number(-1.0, 2.0), dice.number(0.01, 3.0));
        for range in [Interval::POSITIVE, Interval::new(min, min + length)] {
            let advice =
                "Of all points of the way, which one is nearest to the center? Draw the ball and the way on paper.";
            probe(may_hit, &ball, &ray, range, ("wrong-answer", advice))?;
        }
    }
    far_balls(may_hit, &mut dice)
}

/// Directions that are not of unit length.
fn lengths(may_hit: &impl Fn(&Ball, &Ray, Interval) -> bool) -> Verdict {
    let unit = Ball { center: Vec3::ZERO, radius: 1.0 };
    for length in [0.25, 4.0] {
        let ray = Ray::new(Vec3::Z * 3.0, -Vec3::Z * length);
        let advice = "`t` counts lengths of the ray's direction, and this direction is not of unit length. For the nearest point, \
                      divide by the square of that length. Leave the direction as it is: with a unit vector, `t` would have \
                      another unit.";
        for (min, max) in [(0.0, 1.5), (0.0, 2.5), (1.5, 2.2), (3.5, 3.8), (4.5, 9.0), (0.0, f32::INFINITY)] {
            let range = Interval::new(min / length, max / length);
            probe(may_hit, &unit, &ray, range, ("unit-direction", advice))?;
        }
        let beside = Ray::new(Vec3::new(0.0, 1.5, 3.0), ray.direction);
        probe(may_hit, &unit, &beside, Interval::POSITIVE, ("unit-direction", advice))?;
    }
    Ok(())
}

/// Small balls far away.
fn far_balls(may_hit: &impl Fn(&Ball, &Ray, Interval) -> bool, dice: &mut Dice) -> Verdict {
    let advice = "This ball is small and far away. If you compute h² − a·c: that is the small difference of two great numbers, and \
                  rounding eats it. Ask how far the nearest point of the ray is from the center: that is a small number from \
                  the beginning.";
    for _ in 0..200 {
        let ball = Ball { center: dice.direction().normalize() * 100.0, radius: 0.1 };
        let origin = dice.point(1.0);
        for aside in [0.2, 0.9, 1.1, 4.0] {
            let toward = (ball.center - origin).normalize();
            let aim = ball.center + toward.any_orthonormal_vector() * aside * ball.radius;
            probe(may_hit, &ball, &Ray::new(origin, aim - origin), Interval::POSITIVE, ("far-ball", advice))?;
        }
    }
    Ok(())
}

/// Both functions: no ray to a point of a cloud may be lost.
fn together(
    around: &impl Fn(&[Vec3]) -> Ball,
    may_hit: &impl Fn(&Ball, &Ray, Interval) -> bool,
    dice: &mut Dice,
) -> Verdict {
    let (place, size) = (dice.point(20.0), dice.choice([0.1, 1.0, 4.0]));
    let points: Vec<_> = (0..12).map(|_| place + dice.point(1.0) * size).collect();
    let ball = made(around, &points);
    for &point in &points {
        let origin = dice.point(30.0);
        if origin == point {
            continue;
        }
        let (ray, range) = (Ray::new(origin, point - origin), Interval::new(0.999, 1.001));
        if !answer(may_hit, &ball, &ray, range) {
            return Err(Finding {
                tried: format!("{}, which your `around` made", tried(&ball, &ray, range)),
                got: "false".into(),
                expected: format!(
                    "true: the ray comes to the point {} that the ball was made for",
                    words::triple(point)
                ),
                advice: "A ray to a point in the ball was lost. Is there room for rounding?".into(),
            }
            .named("lost-point"));
        }
    }
    Ok(())
}
