//! Ray and triangle, the first way: meet the plane, then ask each edge.

use common::{Interval, Vec3};

use crate::{ray::Ray, triangle::Triangle};

// ANCHOR: edges
impl Triangle {
    /// The ray parameter of the hit: first the plane of the triangle, then its three edges.
    ///
    /// Points on an edge count. A triangle without area has no plane and is never hit.
    #[must_use]
    pub fn hit_by_edges(&self, ray: &Ray, range: Interval) -> Option<f32> {
        let [r1, r2, r3] = self.corners;
        // Meet the plane; a ray along it gives an infinite t or none.
        let n = self.normal();
        let t = (r1 - ray.origin).dot(n) / ray.direction.dot(n);
        if !range.contains(t) {
            return None;
        }
        // Ask each edge whether the point lies to its left.
        let p = ray.at(t);
        let is_left = |from: Vec3, to: Vec3| (to - from).cross(p - from).dot(n) >= 0.0;
        (is_left(r1, r2) && is_left(r2, r3) && is_left(r3, r1)).then_some(t)
    }
}
// ANCHOR_END: edges
