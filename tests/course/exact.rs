//! A second opinion in f64, and how to judge an answer in f32 by it.
//!
//! No formula of the course is used here, so that both cannot be wrong in the same way.

use std::ops::{Add, Mul, Neg, Sub};

use common::{Interval, Vec3};
use ray_casting::{
    hit::{Hit, Side},
    ray::Ray,
    shape::Shape,
};

/// Distance from 1 to the next f32: twice the greatest relative error of one operation.
pub(crate) const EPSILON: f64 = f32::EPSILON as f64;

/// How many roundings of its largest number an honest computation may add up. All shapes get along with 2; some room is
/// left for other honest ways to write the same formula.
pub(crate) const ROUNDINGS: f64 = 4.0;

/// A vector of f64.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct V(pub(crate) [f64; 3]);

/// The unit vectors along x, y and z.
pub(crate) const AXES: [V; 3] = [V([1.0, 0.0, 0.0]), V([0.0, 1.0, 0.0]), V([0.0, 0.0, 1.0])];

impl V {
    pub(crate) const ZERO: V = V([0.0; 3]);

    pub(crate) fn dot(self, V([x, y, z]): V) -> f64 {
        self.0[0] * x + self.0[1] * y + self.0[2] * z
    }

    pub(crate) fn cross(self, V([x, y, z]): V) -> V {
        let [a, b, c] = self.0;
        V([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    pub(crate) fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    pub(crate) fn unit(self) -> V {
        self * (1.0 / self.length())
    }

    /// Rounded to f32.
    pub(crate) fn to_f32(self) -> Vec3 {
        Vec3::from_array(self.0.map(|x| x as f32))
    }
}

impl From<Vec3> for V {
    fn from(v: Vec3) -> V {
        V(v.to_array().map(f64::from))
    }
}

impl Add for V {
    type Output = V;
    fn add(self, V([x, y, z]): V) -> V {
        V([self.0[0] + x, self.0[1] + y, self.0[2] + z])
    }
}

impl Sub for V {
    type Output = V;
    fn sub(self, other: V) -> V {
        self + -other
    }
}

impl Neg for V {
    type Output = V;
    fn neg(self) -> V {
        self * -1.0
    }
}

impl Mul<f64> for V {
    type Output = V;
    fn mul(self, factor: f64) -> V {
        V(self.0.map(|x| x * factor))
    }
}

/// A ray of f32 taken exactly, its direction made unit: `t` is a distance here.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    pub(crate) origin: V,
    pub(crate) direction: V,
    /// Length that the direction had: distance = `t` times speed.
    pub(crate) speed: f64,
}

impl Line {
    pub(crate) fn of(ray: &Ray) -> Line {
        let direction = V::from(ray.direction);
        Line { origin: V::from(ray.origin), direction: direction.unit(), speed: direction.length() }
    }

    pub(crate) fn at(&self, distance: f64) -> V {
        self.origin + self.direction * distance
    }
}

/// A place where a line meets a surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossing {
    /// How far along the line.
    pub(crate) distance: f64,
    /// By how much an honest f32 computation may differ.
    pub(crate) tolerance: f64,
    /// Whether f32 can be sure of it: no outline and no rim is nearer than rounding errors.
    pub(crate) certain: bool,
}

/// All answers that an honest f32 computation may give: usually one, near an outline several.
#[derive(Debug)]
pub(crate) struct Answers {
    pub(crate) hits: Vec<Crossing>,
    pub(crate) may_miss: bool,
}

impl Answers {
    /// The answers for a line with these crossings, in ascending order.
    pub(crate) fn new(line: &Line, crossings: &[Crossing], range: Interval) -> Answers {
        let (min, max) = (f64::from(range.min) * line.speed, f64::from(range.max) * line.speed);
        let mut hits = Vec::new();
        for &crossing in crossings {
            let Crossing { distance, tolerance, certain } = crossing;
            if distance <= min - tolerance || distance >= max + tolerance {
                continue;
            }
            hits.push(crossing);
            if certain && distance > min + tolerance && distance < max - tolerance {
                return Answers { hits, may_miss: false };
            }
        }
        Answers { hits, may_miss: true }
    }

    /// Whether an outline or a rim is so near that more than one answer is right.
    pub(crate) fn is_close(&self) -> bool {
        self.hits.iter().any(|hit| !hit.certain)
    }

    /// Whether the answer `t` is right; a wrong one is told.
    pub(crate) fn check(&self, line: &Line, t: Option<f32>) -> Result<Option<Crossing>, String> {
        let Some(t) = t else {
            return if self.may_miss { Ok(None) } else { Err(format!("a miss instead of {:?}", self.hits)) };
        };
        let distance = f64::from(t) * line.speed;
        let right = self.hits.iter().find(|hit| (hit.distance - distance).abs() <= hit.tolerance);
        right.copied().map(Some).ok_or_else(|| format!("a hit at {distance} instead of {self:?}"))
    }
}

/// The surface of a shape, known by other means than the shape's own code.
pub(crate) trait Reference {
    /// Where a line meets the surface, in ascending order.
    fn crossings(&self, line: &Line) -> Vec<Crossing>;

    /// Judge position, normals and side of a hit at a crossing.
    fn check_hit(&self, line: &Line, hit: &Hit, crossing: &Crossing) -> Result<(), String>;

    /// Judge what a shape answers: inside the range, and when it is asked again before and behind the hit.
    fn check(&self, shape: &dyn Shape, ray: &Ray, range: Interval, tally: &mut Tally) -> Result<(), String> {
        let line = Line::of(ray);
        let crossings = self.crossings(&line);
        let ask = |range: Interval| {
            let answers = Answers::new(&line, &crossings, range);
            let hit = shape.intersect(ray, range);
            let wrong = |error| format!("{ray:?} {range:?}: {error}");
            if hit.is_some_and(|hit| !range.contains(hit.t)) {
                return Err(wrong(format!("{hit:?} lies outside")));
            }
            let crossing = answers.check(&line, hit.map(|h| h.t)).map_err(wrong)?;
            if let Some((hit, crossing)) = hit.zip(crossing) {
                self.check_hit(&line, &hit, &crossing).map_err(wrong)?;
            }
            Ok((hit, answers))
        };
        let (hit, answers) = ask(range)?;
        tally.count(&answers, hit.is_some());
        if let Some(hit) = hit {
            ask(Interval::new(hit.t, range.max))?;
            ask(Interval::new(range.min, hit.t))?;
        }
        Ok(())
    }
}

/// Judge the normals and the side of a hit where the surface's outward normal has the direction of `outward`.
pub(crate) fn check_normals(line: &Line, hit: &Hit, outward: V, tolerance: f64) -> Result<(), String> {
    let leaves = outward.dot(line.direction) > 0.0;
    let expected = outward.unit() * if leaves { -1.0 } else { 1.0 };
    let error = (V::from(hit.geometric_normal) - expected).length();
    if error > tolerance || hit.shading_normal != hit.geometric_normal {
        return Err(format!("normals of {hit:?} are {error} away from {expected:?}, allowed {tolerance}"));
    }
    let side = if leaves { Side::Inside } else { Side::Outside };
    if hit.side == side { Ok(()) } else { Err(format!("{hit:?} should be on the side {side:?}")) }
}

/// How many rays have been judged, and how many of them were close.
#[derive(Debug, Default)]
pub(crate) struct Tally {
    pub(crate) rays: u32,
    pub(crate) hits: u32,
    pub(crate) close: u32,
}

impl Tally {
    pub(crate) fn count(&mut self, answers: &Answers, hit: bool) {
        self.rays += 1;
        self.hits += u32::from(hit);
        self.close += u32::from(answers.is_close());
    }

    /// Assert that the test was a test: enough rays, hits among them, and few that could be judged either way.
    pub(crate) fn assert_fair(&self, rays: u32, share_of_hits: f64, share_close: f64) {
        assert!(self.rays >= rays, "{self:?}");
        assert!(f64::from(self.hits) > share_of_hits * f64::from(self.rays), "{self:?}");
        assert!(f64::from(self.close) < share_close * f64::from(self.rays), "{self:?}");
    }
}
