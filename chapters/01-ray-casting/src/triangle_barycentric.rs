//! Ray and triangle, the second way: barycentric coordinates.
//!
//! Source: Woop, Benthin, Wald, *Watertight Ray/Triangle Intersection*, JCGT 2(1), 2013.

use common::{Interval, Vec3};

use crate::{
    ray::Ray,
    triangle::{Triangle, TriangleHit},
};

// ANCHOR: shear
/// The view along one ray: the ray starts in the origin and runs along the third axis with unit speed.
#[derive(Clone, Copy, Debug)]
pub struct Shear {
    origin: Vec3,
    /// Which coordinates become the first, the second and the third.
    axes: [usize; 3],
    /// How much of the third coordinate is taken away from the first and the second, and its scale.
    amount: [f32; 3],
}

impl Shear {
    /// The view along `ray`.
    #[must_use]
    pub fn along(ray: &Ray) -> Self {
        // The third axis is the one along which the ray runs fastest: nothing is divided by a small number.
        let d = ray.direction.to_array();
        let size = ray.direction.abs();
        let z = if size.x > size.y && size.x > size.z { 0 } else { 1 + usize::from(size.z >= size.y) };
        // The other two follow in cyclic order; swapped if the ray runs backwards, so that left stays left.
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let (x, y) = if d[z] < 0.0 { (y, x) } else { (x, y) };
        Self { origin: ray.origin, axes: [x, y, z], amount: [d[x] / d[z], d[y] / d[z], 1.0 / d[z]] }
    }

    /// A point as it looks along the ray.
    #[must_use]
    pub fn view(&self, point: Vec3) -> Vec3 {
        let p = (point - self.origin).to_array();
        let [x, y, z] = self.axes.map(|axis| p[axis]);
        Vec3::new(x - self.amount[0] * z, y - self.amount[1] * z, self.amount[2] * z)
    }
}
// ANCHOR_END: shear

// ANCHOR: barycentric
impl Triangle {
    /// The hit by barycentric coordinates, solved in the view along the ray.
    ///
    /// Two triangles with a common edge see the same two points there, and the sign of each weight is exact. So no ray
    /// slips through between them: the method is watertight.
    #[must_use]
    pub fn hit_by_barycentric(&self, along: &Shear, range: Interval) -> Option<TriangleHit> {
        let [a, b, c] = self.corners.map(|corner| along.view(corner));
        // In this view the ray is the point (0, 0): each weight is twice the area of the triangle that the opposite
        // edge spans with it.
        let mut weights = [area(c, b), area(a, c), area(b, a)];
        // A weight of zero may be a rounded one: ask again with enough digits.
        if weights.contains(&0.0) {
            weights = [exact_area(c, b), exact_area(a, c), exact_area(b, a)];
        }
        // Inside means: no two weights of different sign.
        let [wa, wb, wc] = weights;
        if (wa < 0.0 || wb < 0.0 || wc < 0.0) && (wa > 0.0 || wb > 0.0 || wc > 0.0) {
            return None;
        }
        // Make them sum to one. A triangle without area, or seen along its plane, has sum zero, and t is no number.
        let sum = wa + wb + wc;
        let weights = [wa / sum, wb / sum, wc / sum];
        let t = weights[0] * a.z + weights[1] * b.z + weights[2] * c.z;
        range.contains(t).then_some(TriangleHit { t, weights })
    }
}

/// Twice the signed area of the triangle (0, 0), `p`, `q`.
///
/// Rounding keeps order: the sign is never wrong, but the result may be rounded to zero.
fn area(p: Vec3, q: Vec3) -> f32 {
    p.x * q.y - p.y * q.x
}

/// The same with 53 binary digits, enough for a product of two f32 to be exact.
#[expect(clippy::cast_possible_truncation, reason = "only sign and size matter from here on")]
fn exact_area(p: Vec3, q: Vec3) -> f32 {
    let [px, py, qx, qy] = [p.x, p.y, q.x, q.y].map(f64::from);
    (px * qy - py * qx) as f32
}
// ANCHOR_END: barycentric
