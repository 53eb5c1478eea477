//! Checks exercise 2.1, any hit will do.

use common::{
    Interval, Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use ray_casting::{ray::Ray, shape::Shape};

use super::words;

/// A ball under test.
struct Trial<S> {
    shape: S,
    center: Vec3,
    radius: f32,
}

/// Name and advice.
type Mistake<'a> = (&'static str, &'a str);

impl<S: Shape> Trial<S> {
    fn new(make: impl Fn(Vec3, f32) -> S, center: Vec3, radius: f32) -> Self {
        Self { shape: trying(|| words::sphere(center, radius), || make(center, radius)), center, radius }
    }

    /// The ray parameters of entry and exit; `None` where the ray grazes the ball, so that rounding decides. A ray that
    /// passes by has none.
    fn crossings(&self, ray: &Ray) -> Option<Vec<f64>> {
        let (direction, radius) = (ray.direction.as_dvec3(), f64::from(self.radius));
        let to_center = self.center.as_dvec3() - ray.origin.as_dvec3();
        let middle = to_center.dot(direction) / direction.length_squared();
        let depth = radius * radius - (to_center - direction * middle).length_squared();
        if depth.abs() < 0.01 * radius * radius {
            return None;
        }
        let half = depth.sqrt() / direction.length();
        Some(if depth > 0.0 { vec![middle - half, middle + half] } else { Vec::new() })
    }

    /// Whether anything is hit; `None` if rounding decides.
    fn expected(&self, ray: &Ray, range: Interval) -> Option<bool> {
        let crossings = self.crossings(ray)?;
        let (min, max) = (f64::from(range.min), f64::from(range.max));
        let length = f64::from(ray.direction.length());
        let is_near = |end: f64| crossings.iter().any(|t| (t - end).abs() * length < 0.01 * f64::from(self.radius));
        let is_fair = !is_near(min) && !is_near(max);
        is_fair.then(|| crossings.iter().any(|t| min < *t && *t < max))
    }

    fn tried(&self, ray: &Ray, range: Interval) -> String {
        let (ray, range) = (words::ray(ray), words::range(range));
        format!("{ray}, {range}, at {}", words::sphere(self.center, self.radius))
    }

    /// The answer under test.
    fn answer(&self, ray: &Ray, range: Interval) -> bool {
        trying(|| self.tried(ray, range), || self.shape.occluded(ray, range))
    }

    /// The mistake, if the answer is wrong. Rays for which rounding decides are passed over.
    fn probe(&self, ray: &Ray, range: Interval, (name, advice): Mistake) -> Verdict {
        let got = self.answer(ray, range);
        let Some(expected) = self.expected(ray, range).filter(|expected| *expected != got) else { return Ok(()) };
        // All is well with an end that is far away: then it is infinity that does harm.
        let far = range.up_to(1e4);
        let is_infinity = range.max == f32::INFINITY && self.answer(ray, far) == expected;
        let (name, advice) = if is_infinity { INFINITE_END } else { (name, advice) };
        Err(Finding {
            tried: self.tried(ray, range),
            got: got.to_string(),
            expected: format!("{expected}: {}", self.why(ray)),
            advice: advice.into(),
        }
        .named(name))
    }

    /// Where the ray meets the surface.
    fn why(&self, ray: &Ray) -> String {
        match self.crossings(ray).as_deref() {
            Some([entry, exit]) => {
                let [entry, exit] = [entry, exit].map(|t| words::number(*t));
                format!("the line of the ray meets the surface at t = {entry} and t = {exit}")
            }
            _ => "the ray passes by".into(),
        }
    }
}

const INFINITE_END: Mistake = (
    "infinite-end",
    "With a range that ends far away your answer is right, but not with one that ends at infinity. There `ray.at` gives \
     0·∞, which is a NaN, and every comparison with a NaN is false. Infinity is outside every ball: ask 'is it inside?' \
     by `<`, so that a NaN means no.",
);

/// Accept a ball, or name what is wrong with it. `make` takes the center and the radius.
pub(crate) fn check<S: Shape>(make: impl Fn(Vec3, f32) -> S) -> Verdict {
    let ball = Trial::new(&make, Vec3::ZERO, 1.0);
    let toward = Ray::new(Vec3::Z * 3.0, -Vec3::Z);
    // Hits, misses, ways inside the ball and empty ranges: the stub says no to all, a mistake hardly.
    let ends =
        [(0.0, f32::INFINITY), (0.0, 3.0), (3.0, 9.0), (0.0, 1.0), (5.0, 9.0), (2.5, 3.5), (3.0, 0.0), (9.0, 0.0)];
    let beside = Ray::new(Vec3::new(2.0, 0.0, 3.0), -Vec3::Z);
    let says_no = |ray: &Ray| ends.iter().all(|(min, max)| !ball.answer(ray, Interval::new(*min, *max)));
    if says_no(&toward) && says_no(&beside) {
        return Err(Diagnosis::not_started("Your ball casts no shadow: `occluded` returns `false` for every ray."));
    }
    outside(&ball, &toward)?;
    inside(&ball, &toward)?;
    lengths(&ball)?;
    other_balls(&make)?;
    far_balls(&make)?;
    for range in [Interval::new(3.0, 0.0), Interval::new(9.0, 3.0), Interval::new(3.0, 3.0)] {
        let advice = "This range is empty, because its end does not come after its beginning. A light that stands closer than \
                      the offset makes such a range. Ask `range.is_empty()` first.";
        ball.probe(&toward, range, ("empty-range", advice))?;
    }

    // Many rays at many balls.
    let mut dice = Dice::new(21);
    for _ in 0..4000 {
        let ball = Trial::new(&make, dice.point(4.0), dice.choice([0.1, 0.5, 1.0, 3.0]));
        let origin = dice.point(6.0);
        let aim = ball.center + dice.point(1.2 * ball.radius);
        let direction = if dice.happens(0.3) { dice.direction() } else { aim - origin };
        let ray = Ray::new(origin, direction * dice.choice([0.25, 1.0, 4.0]));
        let (near, max) = (dice.number(0.0, 2.0), dice.number(0.0, 3.0));
        let min = dice.choice([0.0, near, -3.0]);
        for range in [Interval::POSITIVE, Interval::new(min, max), Interval::new(max, f32::INFINITY)] {
            let advice =
                "Draw the ball and the string on paper: where do its ends lie, and where is it nearest to the center?";
            if direction.length_squared() > 0.01 {
                ball.probe(&ray, range, ("wrong-answer", advice))?;
            }
        }
    }
    Ok(())
}

/// Both ends outside.
fn outside<S: Shape>(ball: &Trial<S>, toward: &Ray) -> Verdict {
    let advice = "This ray passes the ball by. Its nearest point to the center lies outside the ball.";
    for range in [Interval::new(0.0, 100.0), Interval::POSITIVE] {
        ball.probe(&Ray::new(Vec3::new(2.0, 0.0, 3.0), -Vec3::Z), range, ("hit-beside", advice))?;
    }
    let advice = "The range ends in front of the ball: the light stands there, and what lies beyond it casts no shadow here. \
                  The nearest point to the center must lie inside the range.";
    ball.probe(toward, Interval::new(0.0, 1.5), ("beyond-the-light", advice))?;
    let advice =
        "The ball lies behind this ray, at negative `t`. The nearest point to the center must lie inside the range.";
    ball.probe(&Ray::new(Vec3::Z * 3.0, Vec3::Z), Interval::POSITIVE, ("ball-behind", advice))?;
    let advice = "This range begins beyond the ball. The way begins at `range.min`, and not at the ray's origin.";
    ball.probe(toward, Interval::new(5.0, 9.0), ("range-min-ignored", advice))?;
    let advice = "Both ends of this way lie outside the ball, and the point nearest to the center, at t = 3, is the center itself. \
                  (The nearest point is not the middle of the range.)";
    for range in [Interval::new(0.0, 9.0), Interval::POSITIVE] {
        ball.probe(toward, range, ("missed", advice))?;
    }
    let advice = "This range begins before the ray's origin. The range says what counts, not `t > 0`.";
    ball.probe(&Ray::new(Vec3::Z * 3.0, Vec3::Z), Interval::new(-9.0, 1.0), ("only-positive", advice))
}

/// At least one end inside.
fn inside<S: Shape>(ball: &Trial<S>, toward: &Ray) -> Verdict {
    let advice = "The way begins inside the ball and ends outside. It must pass through the surface.";
    for start in [0.0, 0.5, -0.5] {
        for range in [Interval::new(0.0, 9.0), Interval::POSITIVE] {
            ball.probe(&Ray::new(Vec3::X * start, Vec3::X), range, ("begins-inside", advice))?;
        }
    }
    let advice = "The way begins outside the ball and ends inside, like a lamp with a round shade. It must pass through the \
                  surface.";
    for end in [2.3, 3.0, 3.5] {
        ball.probe(toward, Interval::new(0.0, end), ("ends-inside", advice))?;
    }
    let advice = "This range begins inside the ball, at t = 3, and ends outside. What the ray meets before that does not count, but \
                  it comes out again. The way begins at `range.min`, and not at the ray's origin.";
    ball.probe(toward, Interval::new(3.0, 9.0), ("range-min-ignored", advice))?;
    let advice = "Both ends of this way lie inside the ball. The ball is hollow: only its surface can be hit, and the way does \
                  not reach it.";
    for range in [Interval::new(2.2, 3.8), Interval::new(2.2, 2.8), Interval::new(3.2, 3.8)] {
        ball.probe(toward, range, ("solid-ball", advice))?;
    }
    Ok(())
}

/// Directions that are not of unit length.
fn lengths<S: Shape>(ball: &Trial<S>) -> Verdict {
    // One end outside, one inside: the nearest point is not asked for.
    let advice = "`t` counts lengths of the ray's direction, and this direction is not of unit length. The range ends inside the ball, \
                  but with a direction that is made a unit vector it would end elsewhere: `t` would have another unit. Leave the \
                  direction as it is.";
    for (length, end) in [(4.0, 0.75), (0.25, 12.0)] {
        let ray = Ray::new(Vec3::Z * 3.0, -Vec3::Z * length);
        ball.probe(&ray, Interval::new(0.0, end), ("normalized", advice))?;
    }
    let advice = "`t` counts lengths of the ray's direction, and this direction is not of unit length. For the nearest point, \
                  divide by the square of that length.";
    for (length, ends) in [(4.0, [0.4, 0.9, 2.0]), (0.25, [7.0, 10.0, 30.0])] {
        let ray = Ray::new(Vec3::Z * 3.0, -Vec3::Z * length);
        for end in ends {
            ball.probe(&ray, Interval::new(0.0, end), ("unit-direction", advice))?;
        }
        ball.probe(&ray, Interval::POSITIVE, ("unit-direction", advice))?;
        let beside = Ray::new(Vec3::new(0.0, 1.5, 3.0), ray.direction);
        ball.probe(&beside, Interval::POSITIVE, ("unit-direction", advice))?;
    }
    Ok(())
}

/// Balls of other sizes in other places.
fn other_balls<S: Shape>(make: &impl Fn(Vec3, f32) -> S) -> Verdict {
    let ball = |center, radius| Trial::new(make, center, radius);
    let past = |x: f32| Ray::new(Vec3::new(x, 0.0, 3.0), -Vec3::Z);
    let advice = "This ball does not stand in the origin of space. Does your formula use its `center` everywhere?";
    let elsewhere = ball(Vec3::new(2.0, 0.0, -1.0), 1.0);
    for (x, range) in [(2.0, Interval::new(0.0, 9.0)), (0.0, Interval::new(0.0, 9.0)), (2.0, Interval::new(0.0, 2.5))] {
        elsewhere.probe(&past(x), range, ("center-ignored", advice))?;
    }
    elsewhere.probe(&Ray::new(elsewhere.center, Vec3::X), Interval::new(0.0, 9.0), ("center-ignored", advice))?;
    let advice = "The radius of this ball is not 1. A squared distance is compared with the squared radius, and a distance \
                  with the radius itself.";
    for (radius, x) in [(2.0, 1.7), (2.0, 2.5), (0.5, 0.3), (0.5, 0.6)] {
        ball(Vec3::ZERO, radius).probe(&past(x), Interval::new(0.0, 9.0), ("wrong-radius", advice))?;
    }
    let advice = "This ball is tiny, but it is there. Do not compare with fixed small numbers such as `1e-4`: compare with \
                  the radius.";
    let grain = ball(Vec3::ZERO, 0.001);
    for x in [0.0, 0.0005, 0.002] {
        let ray = Ray::new(Vec3::new(x, 0.0, 0.003), -Vec3::Z);
        for end in [0.001, 0.003, 0.009] {
            grain.probe(&ray, Interval::new(0.0, end), ("fixed-epsilon", advice))?;
        }
    }
    Ok(())
}

/// Small balls far away.
fn far_balls<S: Shape>(make: &impl Fn(Vec3, f32) -> S) -> Verdict {
    let advice = "This ball is small and far away. If you compute h² − a·c: that is the small difference of two great numbers, and \
                  rounding eats it (chapter 1 shows it). Ask how far the nearest point of the ray is from the center: that is a small \
                  number from the beginning.";
    let mut dice = Dice::new(121);
    for _ in 0..100 {
        let ball = Trial::new(make, dice.direction().normalize() * 100.0, 0.01);
        let origin = dice.point(1.0);
        for aside in [0.2, 4.0] {
            let aim = ball.center + dice.direction().normalize() * aside * ball.radius;
            ball.probe(&Ray::new(origin, aim - origin), Interval::new(0.0, 9.0), ("far-ball", advice))?;
        }
    }
    Ok(())
}
