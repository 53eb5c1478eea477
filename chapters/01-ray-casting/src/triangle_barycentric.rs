//! Ray and triangle, the second way: barycentric coordinates.
//!
//! Source: Woop, Benthin, Wald, *Watertight Ray/Triangle Intersection*, JCGT 2(1), 2013.

use common::{Interval, Mat3, Vec3};

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
    origin: Vec3,
    matrix: Mat3,
}

impl Shear {
    /// The view along `ray`.
    #[must_use]
    pub fn along(ray: &Ray) -> Self {
        // The third axis is the one along which the ray runs fastest: nothing is divided by a small number.
        let d = ray.direction;
        let size = d.abs();
        let (x, y, z) = if size.x >= size.y && size.x >= size.z {
            (Vec3::Y, Vec3::Z, Vec3::X)
        } else if size.y >= size.z {
            (Vec3::Z, Vec3::X, Vec3::Y)
        } else {
            (Vec3::X, Vec3::Y, Vec3::Z)
        };
        // Scale the third coordinate to the ray's speed, and take away what the ray moves sideways meanwhile.
        let third = z / d.dot(z);
        let rows = Mat3::from_cols(x - third * d.dot(x), y - third * d.dot(y), third);
        Self { origin: ray.origin, matrix: rows.transpose() }
    }

    /// A point as it looks along the ray.
    #[must_use]
    #[inline]
    pub fn view(&self, point: Vec3) -> Vec3 {
        self.matrix * (point - self.origin)
    }
}
// ANCHOR_END: shear

// ANCHOR: barycentric
impl Triangle {
    /// The hit by barycentric coordinates, solved in the view along the ray.
    ///
    /// Two triangles with a common edge see the same two points there, and the sign of each weight is never wrong. So no
    /// ray slips through between them: the method is watertight. A triangle whose corners lie in one line is at most as
    /// wide as the rounding of its corners.
    // Two loops call it. If it stayed a call, both would be three times as slow.
    #[must_use]
    #[inline(always)]
    pub fn hit_by_barycentric(&self, along: &Shear, range: Interval) -> Option<TriangleHit> {
        let [r1, r2, r3] = self.corners;
        let (a, b, c) = (along.view(r1), along.view(r2), along.view(r3));
        // In this view the ray is the point (0, 0): each weight is twice the area of the triangle that the opposite
        // edge spans with it.
        let (wa, wb, wc) = (area(c, b), area(a, c), area(b, a));
        // Inside means: no two weights of different sign.
        if (wa < 0.0 || wb < 0.0 || wc < 0.0) && (wa > 0.0 || wb > 0.0 || wc > 0.0) {
            return None;
        }
        // Make them sum to one. Corners in one place, and a triangle seen along its plane, have sum zero: t is no number.
        let sum = wa + wb + wc;
        let weights = [wa / sum, wb / sum, wc / sum];
        let t = weights[0] * a.z + weights[1] * b.z + weights[2] * c.z;
        range.contains(t).then_some(TriangleHit { t, weights })
    }
}

/// Twice the signed area of the triangle (0, 0), `p`, `q`.
///
/// Rounding keeps order, so the sign is never wrong; the result may be rounded to zero, which counts as inside.
#[inline]
fn area(p: Vec3, q: Vec3) -> f32 {
    p.x * q.y - p.y * q.x
}
// ANCHOR_END: barycentric

impl Shape for Triangle {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let hit = self.hit_by_barycentric(&Shear::along(ray), range)?;
        Some(Hit::new(ray, hit.t, self.normal()).among(self.farthest()))
    }
}
