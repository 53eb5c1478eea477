//! Implicit surfaces: all points `p` at which a function `f(p)` is zero.

use common::{Interval, Vec3};

use crate::{hit::Hit, ray::Ray, shape::Shape, sphere::Sphere};

// ANCHOR: implicit
/// A function of space whose zeros are a surface: negative inside, positive outside.
pub trait Implicit: Send + Sync {
    /// The function itself.
    fn value(&self, p: Vec3) -> f32;

    /// Its derivatives by x, y and z: the direction in which it grows fastest. Not of unit length.
    fn gradient(&self, p: Vec3) -> Vec3;
}
// ANCHOR_END: implicit

/// The part of an implicit surface inside a bounding sphere, found by marching along the ray.
#[derive(Clone, Copy, Debug)]
pub struct ImplicitSurface<F> {
    /// The function.
    pub function: F,
    /// Only what lies inside is looked for.
    pub bound: Sphere,
    /// Longest step of the march, in scene units. Two zeros closer together than this may be missed.
    pub step: f32,
}

// ANCHOR: march
impl<F: Implicit> Shape for ImplicitSurface<F> {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        // Look only where the ray is inside the bounding sphere.
        let inside = range.intersection(self.bound.roots(ray).span()?);
        if inside.is_empty() {
            return None;
        }
        // March until the function changes its sign: the surface lies between these two steps.
        let value = |t| self.function.value(ray.at(t));
        let step = self.step / ray.direction.length();
        let (mut t, mut before) = (inside.min, value(inside.min));
        while t < inside.max {
            let next = (t + step).min(inside.max);
            if next <= t {
                return None;
            }
            let after = value(next);
            if (before < 0.0) != (after < 0.0) {
                let t = bisect(value, t, next);
                if range.contains(t) {
                    return Some(Hit::new(ray, t, self.function.gradient(ray.at(t))).among(self.bound.center));
                }
            }
            (t, before) = (next, after);
        }
        None
    }
}

/// The place between `low` and `high` where the sign of `value` changes, to the last bits of f32.
fn bisect(value: impl Fn(f32) -> f32, mut low: f32, mut high: f32) -> f32 {
    let starts_negative = value(low) < 0.0;
    // Each round halves the interval; 24 rounds use up the digits of an f32.
    for _ in 0..24 {
        let middle = (low + high) / 2.0;
        if (value(middle) < 0.0) == starts_negative {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low + high) / 2.0
}
// ANCHOR_END: march

// ANCHOR: tanglecube
/// The tanglecube, `x⁴ + y⁴ + z⁴ − 5(x² + y² + z²) + 11.8`: a cube of tubes with a hole in every face.
#[derive(Clone, Copy, Debug)]
pub struct Tanglecube;

impl Implicit for Tanglecube {
    fn value(&self, p: Vec3) -> f32 {
        let squares = p * p;
        squares.dot(squares) - 5.0 * p.dot(p) + 11.8
    }

    fn gradient(&self, p: Vec3) -> Vec3 {
        4.0 * p * p * p - 10.0 * p
    }
}
// ANCHOR_END: tanglecube

/// Taubin's heart, `(x² + 9/4·z² + y² − 1)³ − x²y³ − 9/80·z²y³`, standing upright along y.
///
/// Source: Taubin, *Rasterizing Algebraic Curves and Surfaces*, IEEE CG&A 14(2), 1994.
#[derive(Clone, Copy, Debug)]
pub struct Heart;

impl Implicit for Heart {
    fn value(&self, p: Vec3) -> f32 {
        let (x2, y2, z2) = (p.x * p.x, p.y * p.y, p.z * p.z);
        let s = x2 + 2.25 * z2 + y2 - 1.0;
        s * s * s - (x2 + 0.1125 * z2) * y2 * p.y
    }

    fn gradient(&self, p: Vec3) -> Vec3 {
        let (x2, y2, z2) = (p.x * p.x, p.y * p.y, p.z * p.z);
        let s = x2 + 2.25 * z2 + y2 - 1.0;
        let outer = 3.0 * s * s * Vec3::new(2.0 * p.x, 2.0 * p.y, 4.5 * p.z);
        let y3 = y2 * p.y;
        outer - Vec3::new(2.0 * p.x * y3, 3.0 * (x2 + 0.1125 * z2) * y2, 0.225 * p.z * y3)
    }
}

/// A gyroid, `sin x cos y + sin y cos z + sin z cos x`, scaled by `frequency`: one endless wall that parts space in two.
#[derive(Clone, Copy, Debug)]
pub struct Gyroid {
    /// Radians per scene unit.
    pub frequency: f32,
}

impl Implicit for Gyroid {
    fn value(&self, p: Vec3) -> f32 {
        let (sin, cos) = self.sines(p);
        sin.dot(Vec3::new(cos.y, cos.z, cos.x))
    }

    fn gradient(&self, p: Vec3) -> Vec3 {
        let (sin, cos) = self.sines(p);
        self.frequency
            * Vec3::new(cos.x * cos.y - sin.z * sin.x, cos.y * cos.z - sin.x * sin.y, cos.z * cos.x - sin.y * sin.z)
    }
}

impl Gyroid {
    fn sines(&self, p: Vec3) -> (Vec3, Vec3) {
        use common::float::{cos, sin};
        let angles = (p * self.frequency).to_array();
        (Vec3::from_array(angles.map(sin)), Vec3::from_array(angles.map(cos)))
    }
}
