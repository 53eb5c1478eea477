//! A flat shape with four corners.

use common::{Interval, Vec2, Vec3};
use ray_casting::{hit::Hit, ray::Ray, shape::Shape};

/// The points `corner + x · edges[0] + y · edges[1]` with x and y from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quad {
    /// One of its corners.
    pub(crate) corner: Vec3,
    /// The two edges that meet there.
    pub(crate) edges: [Vec3; 2],
}

impl Quad {
    /// The one around `center`, by half of its two edges.
    pub(crate) fn around(center: Vec3, halves: [Vec3; 2]) -> Self {
        Self { corner: center - halves[0] - halves[1], edges: halves.map(|half| half * 2.0) }
    }

    /// x and y of a point in its plane, without a right angle too.
    pub(crate) fn place(&self, point: Vec3) -> Vec2 {
        let ([a, b], offset) = (self.edges, point - self.corner);
        let cross = a.cross(b);
        Vec2::new(offset.cross(b).dot(cross), a.cross(offset).dot(cross)) / cross.length_squared()
    }
}

impl Shape for Quad {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let normal = self.edges[0].cross(self.edges[1]);
        let t = (self.corner - ray.origin).dot(normal) / ray.direction.dot(normal);
        // A ray along the plane gives no number, and lies in no range.
        if !range.contains(t) {
            return None;
        }
        let place = self.place(ray.at(t));
        let is_inside = place.cmpge(Vec2::ZERO).all() && place.cmple(Vec2::ONE).all();
        is_inside.then(|| Hit::new(ray, t, normal).among(self.corner))
    }
}
