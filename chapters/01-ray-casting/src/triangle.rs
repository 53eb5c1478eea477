//! The triangle, and where on it a point lies.

use common::Vec3;

// ANCHOR: triangle
/// Three corners, counter-clockwise when seen from outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// The corners `r1`, `r2`, `r3`, in scene units.
    pub corners: [Vec3; 3],
}
// ANCHOR_END: triangle

// ANCHOR: hit
/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit {
    /// Ray parameter.
    pub t: f32,
    /// Barycentric coordinates α, β, γ of the point: none negative, together 1.
    pub weights: [f32; 3],
}
// ANCHOR_END: hit

impl Triangle {
    /// A triangle from its corners, counter-clockwise when seen from outside.
    #[must_use]
    #[inline]
    pub fn new(r1: Vec3, r2: Vec3, r3: Vec3) -> Self {
        Self { corners: [r1, r2, r3] }
    }

    // ANCHOR: normal
    /// The vector at right angles to the triangle, `(r2 − r1) × (r3 − r1)`; its length is twice the area.
    #[must_use]
    #[inline]
    pub fn normal(&self) -> Vec3 {
        let [r1, r2, r3] = self.corners;
        (r2 - r1).cross(r3 - r1)
    }
    // ANCHOR_END: normal

    /// For each axis the greatest distance of a corner from the scene's origin.
    #[must_use]
    #[inline]
    pub fn farthest(&self) -> Vec3 {
        let [r1, r2, r3] = self.corners.map(Vec3::abs);
        r1.max(r2).max(r3)
    }
}
