//! Triangles as primitives: the corners side by side in memory, ready for a ray.

use std::sync::Arc;

use common::{Interval, Vec3};
use ray_casting::{aabb::Aabb, hit::Hit, mesh::Mesh, ray::Ray, triangle::Triangle, triangle_barycentric::Shear};

use crate::{
    clip::{clip, clip_to_octants},
    primitives::Primitives,
};

// ANCHOR: triangles
/// The triangles of a mesh.
#[derive(Clone, Debug)]
pub struct Triangles(pub Arc<Mesh>);

/// A triangle and its number. Lists hold such copies, so that a test reads one place in memory instead of four.
#[derive(Clone, Copy, Debug)]
pub struct Numbered {
    triangle: Triangle,
    number: u32,
}

impl Numbered {
    /// The triangle of that number.
    pub(crate) fn new(triangle: Triangle, number: u32) -> Self {
        Self { triangle, number }
    }

    /// The triangle.
    #[inline(always)]
    pub(crate) fn triangle(&self) -> &Triangle {
        &self.triangle
    }
}

impl Primitives for Triangles {
    type View = Shear;
    type Entry = Numbered;

    #[expect(clippy::cast_possible_truncation, reason = "structures refuse more")]
    fn count(&self) -> u32 {
        self.0.len() as u32
    }

    fn aabb(&self, number: u32) -> Aabb {
        let [a, b, c] = self.0.triangle(number as usize).corners;
        // The least of a number and of no number is the number: say so here, or damage would stay unnoticed.
        if !(a.is_finite() && b.is_finite() && c.is_finite()) {
            return Aabb { min: Vec3::NAN, max: Vec3::NAN };
        }
        Aabb { min: a.min(b).min(c), max: a.max(b).max(c) }
    }

    fn clipped(&self, number: u32, cell: &Aabb) -> Option<Aabb> {
        clip(&self.0.triangle(number as usize), cell)
    }

    fn octants(&self, number: u32, cell: &Aabb, middle: Vec3) -> [Option<Aabb>; 8] {
        clip_to_octants(&self.0.triangle(number as usize), cell, middle)
    }

    fn entry(&self, number: u32) -> Numbered {
        Numbered::new(self.0.triangle(number as usize), number)
    }

    #[inline]
    fn number(&self, entry: &Numbered) -> u32 {
        entry.number
    }

    fn view(&self, ray: &Ray) -> Shear {
        Shear::along(ray)
    }

    #[inline(always)]
    fn intersect(&self, entry: &Numbered, view: &Shear, range: Interval) -> Option<f32> {
        entry.triangle.hit_by_barycentric(view, range).map(|hit| hit.t)
    }

    fn hit(&self, number: u32, ray: &Ray, t: f32) -> Option<Hit> {
        // A ray that leaves from here may be tested against any of the triangles: its offset follows all coordinates.
        let Aabb { min, max } = self.0.bounds();
        Some(self.0.hit(ray, number as usize, t).among(min).among(max))
    }
}
// ANCHOR_END: triangles
