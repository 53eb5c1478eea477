//! Implicit surfaces against their functions in f64, marched in finer steps.

#![expect(clippy::disallowed_methods, reason = "f64 has digits to spare: its last bits do not matter here")]

use common::{Stream, Vec3};
use ray_casting::{
    hit::Hit,
    implicit::{Gyroid, Heart, Implicit, ImplicitSurface, Tanglecube},
    shape::Shape,
    sphere::Sphere,
};

use crate::{
    exact::{AXES, Crossing, EPSILON, Line, ROUNDINGS, Reference, Tally, V, check_normals},
    rays::{Target, in_cube},
};

/// The zeros of a function inside a ball around the origin.
pub(crate) struct Zeros {
    pub(crate) function: fn(V) -> f64,
    /// The same function with all its terms made positive: how large the numbers are that are rounded.
    pub(crate) terms: fn(V) -> f64,
    pub(crate) radius: f64,
    /// Step of the march that is judged. It may miss two zeros that are closer together.
    pub(crate) step: f64,
}

fn tanglecube(V([x, y, z]): V) -> f64 {
    x.powi(4) + y.powi(4) + z.powi(4) - 5.0 * (x * x + y * y + z * z) + 11.8
}

fn tanglecube_terms(V([x, y, z]): V) -> f64 {
    x.powi(4) + y.powi(4) + z.powi(4) + 5.0 * (x * x + y * y + z * z) + 11.8
}

fn heart(V([x, y, z]): V) -> f64 {
    (x * x + 9.0 / 4.0 * z * z + y * y - 1.0).powi(3) - x * x * y.powi(3) - 9.0 / 80.0 * z * z * y.powi(3)
}

fn heart_terms(V([x, y, z]): V) -> f64 {
    // The cube's base is rounded before it is raised: three times its square times the terms of the base.
    let squares = x * x + 9.0 / 4.0 * z * z + y * y;
    let base = squares - 1.0;
    base.abs().powi(3) + 3.0 * base * base * (squares + 1.0) + (x * x + 9.0 / 80.0 * z * z) * y.abs().powi(3)
}

/// A gyroid of frequency 5.
fn gyroid(p: V) -> f64 {
    let [(sx, cx), (sy, cy), (sz, cz)] = p.0.map(|x| (5.0 * x).sin_cos());
    sx * cy + sy * cz + sz * cx
}

fn gyroid_terms(_: V) -> f64 {
    3.0
}

pub(crate) const TANGLECUBE: Zeros = Zeros { function: tanglecube, terms: tanglecube_terms, radius: 3.4, step: 0.04 };
pub(crate) const HEART: Zeros = Zeros { function: heart, terms: heart_terms, radius: 1.6, step: 0.02 };
pub(crate) const GYROID: Zeros = Zeros { function: gyroid, terms: gyroid_terms, radius: 1.5, step: 0.02 };

impl Zeros {
    /// The gradient by central differences.
    pub(crate) fn gradient(&self, p: V) -> V {
        const STEP: f64 = 1e-5;
        let slope = |axis: V| ((self.function)(p + axis * STEP) - (self.function)(p - axis * STEP)) / (2.0 * STEP);
        V(AXES.map(slope))
    }

    /// How fast the gradient changes.
    pub(crate) fn bend(&self, p: V) -> f64 {
        const STEP: f64 = 1e-4;
        let change = |axis: V| (self.gradient(p + axis * STEP) - self.gradient(p)).length() / STEP;
        AXES.map(change).into_iter().fold(0.0, f64::max)
    }

    /// How far from its place a ray may seem to be after rounding.
    fn blur(&self, line: &Line) -> f64 {
        ROUNDINGS * EPSILON * (line.origin.length() + self.radius)
    }

    /// How far the computed value may be from the true one.
    fn error(&self, line: &Line, p: V) -> f64 {
        self.gradient(p).length() * self.blur(line) + ROUNDINGS * EPSILON * (self.terms)(p)
    }

    /// The crossing where the function changes its sign between two distances.
    fn crossing(&self, line: &Line, mut low: f64, mut high: f64, sure: [f64; 2]) -> Crossing {
        let is_negative = |distance: f64| (self.function)(line.at(distance)) < 0.0;
        let before = is_negative(low);
        for _ in 0..45 {
            let middle = (low + high) / 2.0;
            *if is_negative(middle) == before { &mut low } else { &mut high } = middle;
        }
        self.judged(line, low, sure)
    }

    /// A zero, or nearly a zero, and how far an f32 may be from it.
    fn judged(&self, line: &Line, distance: f64, sure: [f64; 2]) -> Crossing {
        const STEP: f64 = 1e-5;
        let value = |distance: f64| (self.function)(line.at(distance));
        let [before, here, after] = [distance - STEP, distance, distance + STEP].map(value);
        let (slope, curve) = ((after - before) / (2.0 * STEP), (after + before - 2.0 * here) / (STEP * STEP));
        // Where the line grazes the surface, the function curves more than it falls.
        let error = self.error(line, line.at(distance));
        let grazes = slope * slope < 8.0 * error * curve.abs();
        let width = if grazes { (8.0 * error / curve.abs()).sqrt() } else { 1.5 * error / slope.abs() };
        let tolerance = width + self.blur(line);
        let is_inside = distance > sure[0] + tolerance && distance < sure[1] - tolerance;
        Crossing { distance, tolerance, certain: !grazes && is_inside }
    }

    /// A random point of the surface with its normal.
    fn random_point(&self, random: &mut Stream) -> (V, V) {
        loop {
            let mut p = V::from(in_cube(random)) * self.radius;
            for _ in 0..30 {
                let gradient = self.gradient(p);
                p = p - gradient * ((self.function)(p) / gradient.dot(gradient));
            }
            if p.length() < self.radius && (self.function)(p).abs() < 1e-9 {
                return (p, self.gradient(p).unit());
            }
        }
    }
}

impl Reference for Zeros {
    fn crossings(&self, line: &Line) -> Vec<Crossing> {
        // Find the part of the line that is inside the ball; surely, and perhaps.
        let middle = -line.origin.dot(line.direction);
        let aside2 = line.at(middle).dot(line.at(middle));
        let slack = 2.0 * self.radius * self.blur(line);
        let [sure, perhaps] = [-slack, slack].map(|slack| (self.radius * self.radius - aside2 + slack).max(0.0).sqrt());
        let sure = [middle - sure, middle + sure];
        // March through it in half steps.
        let value = |distance: f64| (self.function)(line.at(distance));
        let steps = (4.0 * perhaps / self.step).ceil() as usize;
        let step = 2.0 * perhaps / steps as f64;
        let at = |i: usize| middle - perhaps + i as f64 * step;
        let values: Vec<f64> = (0..=steps).map(|i| value(at(i))).collect();
        let mut crossings = Vec::new();
        for i in 1..=steps {
            // Between two half steps the function may come near zero, or pass it twice.
            if let [a, b, c] = values[i - 1..values.len().min(i + 2)]
                && b.abs() < a.abs().min(c.abs())
                && (a < 0.0) == (b < 0.0)
                && (b < 0.0) == (c < 0.0)
            {
                let (lowest, least) = least(|d| value(d) * b.signum(), at(i - 1), at(i + 1));
                if least < 0.0 {
                    crossings.push(self.crossing(line, at(i - 1), lowest, sure));
                    crossings.push(self.crossing(line, lowest, at(i + 1), sure));
                } else if least < self.error(line, line.at(lowest)) {
                    crossings.push(Crossing { certain: false, ..self.judged(line, lowest, sure) });
                }
            }
            if (values[i - 1] < 0.0) != (values[i] < 0.0) {
                crossings.push(self.crossing(line, at(i - 1), at(i), sure));
            }
        }
        crossings.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        // Two zeros within one step may be missed both.
        for i in 1..crossings.len() {
            if crossings[i].distance - crossings[i - 1].distance < 1.01 * self.step {
                crossings[i - 1].certain = false;
                crossings[i].certain = false;
            }
        }
        crossings
    }

    fn check_hit(&self, line: &Line, hit: &Hit, crossing: &Crossing) -> Result<(), String> {
        let position = V::from(hit.position);
        let away = (position - line.at(crossing.distance)).length();
        if away > crossing.tolerance + self.blur(line) {
            return Err(format!("{hit:?} is {away} away from its place"));
        }
        let gradient = self.gradient(position);
        let rounded = self.bend(position) * self.radius + (self.terms)(position);
        let tolerance = ROUNDINGS * EPSILON * rounded / gradient.length();
        if !crossing.certain || tolerance > 0.1 {
            return Ok(());
        }
        check_normals(line, hit, gradient, tolerance)
    }
}

/// Where a function with one valley is least, by ternary search, and its value there.
fn least(function: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> (f64, f64) {
    for _ in 0..50 {
        let (left, right) = ((2.0 * low + high) / 3.0, (low + 2.0 * high) / 3.0);
        if function(left) < function(right) { high = right } else { low = left }
    }
    (low, function(low))
}

/// Ask a shape about many random rays; tell the first wrong answer.
fn judge(shape: &dyn Shape, zeros: &Zeros, rays: u32, seed: u64) -> Result<Tally, String> {
    let (mut random, mut tally) = (Stream::new(seed, 0, 0), Tally::default());
    let surface = |random: &mut Stream| zeros.random_point(random);
    let target = Target { center: Vec3::ZERO, size: zeros.radius as f32, farthest: 1e3, surface: &surface };
    for i in 0..rays {
        let ray = target.ray(i, &mut random);
        let range = target.range(&ray, &mut random);
        zeros.check(shape, &ray, range, &mut tally)?;
    }
    Ok(tally)
}

/// The shape whose zeros these should be.
fn shape<F: Implicit>(function: F, zeros: &Zeros) -> ImplicitSurface<F> {
    let bound = Sphere::new(Vec3::ZERO, zeros.radius as f32);
    ImplicitSurface { function, bound, step: zeros.step as f32 }
}

#[test]
fn the_tanglecube_is_hit_where_its_function_is_zero() {
    let tally = judge(&shape(Tanglecube, &TANGLECUBE), &TANGLECUBE, 50_000, 201);
    tally.unwrap().assert_fair(50_000, 0.3, 0.02);
}

#[test]
fn the_heart_is_hit_where_its_function_is_zero() {
    judge(&shape(Heart, &HEART), &HEART, 45_000, 202).unwrap().assert_fair(45_000, 0.3, 0.02);
}

#[test]
fn the_gyroid_is_hit_where_its_function_is_zero() {
    let tally = judge(&shape(Gyroid { frequency: 5.0 }, &GYROID), &GYROID, 6_000, 203);
    tally.unwrap().assert_fair(6_000, 0.3, 0.02);
}

/// A tanglecube with mistakes.
struct Mistaken {
    value: fn(Vec3) -> f32,
    gradient: fn(Vec3) -> Vec3,
}

impl Implicit for Mistaken {
    fn value(&self, p: Vec3) -> f32 {
        (self.value)(p)
    }

    fn gradient(&self, p: Vec3) -> Vec3 {
        (self.gradient)(p)
    }
}

#[test]
fn mistakes_in_implicit_surfaces_are_found() {
    let right = Mistaken { value: |p| Tanglecube.value(p), gradient: |p| Tanglecube.gradient(p) };
    let off = Mistaken { value: |p| Tanglecube.value(p) + 3e-4, ..right };
    let askew = Mistaken { gradient: |p| Tanglecube.gradient(p) + Vec3::X * 3e-4, ..right };
    let inward = Mistaken { gradient: |p| -Tanglecube.gradient(p), ..right };
    let ask = |shape: &dyn Shape| judge(shape, &TANGLECUBE, 9_000, 204).map(drop);
    assert_eq!(ask(&shape(right, &TANGLECUBE)), Ok(()));
    for (what, mistaken) in [("value off", off), ("gradient askew", askew), ("gradient inward", inward)] {
        assert!(ask(&shape(mistaken, &TANGLECUBE)).is_err(), "{what}");
    }
    let coarse = ImplicitSurface { step: 0.12, ..shape(Tanglecube, &TANGLECUBE) };
    assert!(ask(&coarse).is_err(), "three times the step");
}
