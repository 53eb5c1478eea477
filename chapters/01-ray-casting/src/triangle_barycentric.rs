//! Ray and triangle, the second way: barycentric coordinates.
//!
//! Source: Woop, Benthin, Wald, *Watertight Ray/Triangle Intersection*, JCGT 2(1), 2013.

use common::{Interval, Vec3};

use crate::{
    hit::Hit,
    ray::Ray,
    shape::Shape,
    triangle::{Triangle, TriangleHit},
};

// ANCHOR: shear
/// The view along one ray: the ray starts in the origin and runs along the third axis with unit speed.
#[derive(Clone, Copy, Debug)]
pub struct Shear {
    /// Where the ray starts.
    pub origin: Vec3,
    /// The axis along which the ray runs fastest.
    main: Axis,
    /// For each unit of the way along that axis: how far the ray runs along the two others, and one over its speed.
    pub slope: Vec3,
}

/// One of the three axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    /// The same vector with this axis as the last one. The three axes only turn, so right-handed stays right-handed.
    #[inline(always)]
    fn last(self, v: Vec3) -> Vec3 {
        match self {
            Axis::X => Vec3::new(v.y, v.z, v.x),
            Axis::Y => Vec3::new(v.z, v.x, v.y),
            Axis::Z => v,
        }
    }
}

impl Shear {
    /// The view along `ray`.
    #[must_use]
    #[inline]
    pub fn along(ray: &Ray) -> Self {
        // The third axis is the one along which the ray runs fastest: nothing is divided by a small number.
        let size = ray.direction.abs();
        let main = if size.x >= size.y && size.x >= size.z {
            Axis::X
        } else if size.y >= size.z {
            Axis::Y
        } else {
            Axis::Z
        };
        let d = main.last(ray.direction);
        let third = 1.0 / d.z;
        Self { origin: ray.origin, main, slope: Vec3::new(third * d.x, third * d.y, third) }
    }

    /// The numbers of the axes of the scene that become the first, the second and the third.
    #[must_use]
    #[inline]
    pub fn axes(&self) -> [usize; 3] {
        match self.main {
            Axis::X => [1, 2, 0],
            Axis::Y => [2, 0, 1],
            Axis::Z => [0, 1, 2],
        }
    }

    /// A point as it looks along the ray.
    #[must_use]
    #[inline(always)]
    pub fn view(&self, point: Vec3) -> Vec3 {
        let Vec3 { x, y, z } = self.main.last(point - self.origin);
        // Take away what the ray moves sideways meanwhile, and scale the third coordinate to its speed.
        Vec3::new(x - self.slope.x * z, y - self.slope.y * z, self.slope.z * z)
    }
}
// ANCHOR_END: shear

// ANCHOR: barycentric
impl Triangle {
    /// The hit by barycentric coordinates, solved in the view along the ray.
    ///
    /// Two triangles with a common edge see the same two points there, and the sign of each weight is never wrong. So no
    /// ray slips through between them: the method is watertight. And the hit is right to the last digits for corners that
    /// are seen a hair beside their places, however thin the triangle. A triangle whose corners lie in one line is at
    /// most as wide as the rounding of its corners.
    // Two loops call it. If it stayed a call, both would be three times as slow.
    #[must_use]
    #[inline(always)]
    pub fn hit_by_barycentric(&self, along: &Shear, range: Interval) -> Option<TriangleHit> {
        let [a, b, c] = self.corners.map(|corner| along.view(corner));
        // All corners on one side of the ray: it passes by.
        if is_beside(a.x, b.x, c.x) || is_beside(a.y, b.y, c.y) {
            return None;
        }
        // In this view the ray is the point (0, 0): each weight is twice the area of the triangle that the opposite
        // edge spans with it. Inside means: no two weights of different sign.
        if signs_differ([area(c, b), area(a, c), area(b, a)]) {
            return None;
        }
        hit_by_exact_weights([a, b, c], range)
    }

    /// The same without the quick ways to say no: for a triangle that is hit most likely.
    #[must_use]
    #[inline(always)]
    pub fn hit_by_exact_weights(&self, along: &Shear, range: Interval) -> Option<TriangleHit> {
        hit_by_exact_weights(self.corners.map(|corner| along.view(corner)), range)
    }
}

/// The hit of a triangle whose corners are seen like this.
#[inline(always)]
fn hit_by_exact_weights([a, b, c]: [Vec3; 3], range: Interval) -> Option<TriangleHit> {
    // Here, areas may have been rounded to zero, and those of a thin triangle to little more than noise.
    let [wa, wb, wc] = [exact_area(c, b), exact_area(a, c), exact_area(b, a)];
    // Here the answer is mostly no: to ask all six, without a branch after each, is faster.
    if ((wa < 0.0) | (wb < 0.0) | (wc < 0.0)) & ((wa > 0.0) | (wb > 0.0) | (wc > 0.0)) {
        return None;
    }
    // Make them sum to one. Corners in one place, and a triangle seen along its plane, have sum zero: t is no number.
    let sum = wa + wb + wc;
    let weights = [wa / sum, wb / sum, wc / sum];
    let t = rounded(weights[0] * f64::from(a.z) + weights[1] * f64::from(b.z) + weights[2] * f64::from(c.z));
    range.contains(t).then_some(TriangleHit { t, weights: weights.map(rounded) })
}

/// Whether three numbers all have the same sign, and none is zero.
#[inline]
fn is_beside(a: f32, b: f32, c: f32) -> bool {
    (a > 0.0 && b > 0.0 && c > 0.0) || (a < 0.0 && b < 0.0 && c < 0.0)
}

/// Whether one of three numbers is less than zero and another one greater.
#[inline(always)]
fn signs_differ([a, b, c]: [f32; 3]) -> bool {
    (a < 0.0 || b < 0.0 || c < 0.0) && (a > 0.0 || b > 0.0 || c > 0.0)
}

/// Twice the signed area of the triangle (0, 0), `p`, `q`.
///
/// Rounding keeps order, so the sign is never wrong; the result may be rounded to zero.
#[must_use]
#[inline(always)]
pub fn area(p: Vec3, q: Vec3) -> f32 {
    p.x * q.y - p.y * q.x
}

/// The same, right to 53 bits: a product of two numbers of 24 bits has at most 48, so only the difference is rounded.
#[inline]
fn exact_area(p: Vec3, q: Vec3) -> f64 {
    f64::from(p.x) * f64::from(q.y) - f64::from(p.y) * f64::from(q.x)
}

/// The nearest `f32`.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "that is what it is for")]
fn rounded(x: f64) -> f32 {
    x as f32
}
// ANCHOR_END: barycentric

impl Shape for Triangle {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let hit = self.hit_by_barycentric(&Shear::along(ray), range)?;
        Some(Hit::new(ray, hit.t, self.normal()).among(self.farthest()))
    }
}
