//! The builder: takes triangles, and keeps them as parts of one mesh. What it can make of them has a file for each kind
//! of thing.

use common::{Vec3, obj::ObjMesh};
use ray_casting::material::Phong;

use crate::model::Part;

/// A mesh that grows, part by part.
#[derive(Clone, Debug, Default)]
pub struct Builder {
    /// What there is so far.
    pub mesh: ObjMesh,
    /// Its parts; the last one still grows.
    pub parts: Vec<Part>,
}

impl Builder {
    /// Begin a part: all triangles from now on are made of this material.
    pub fn part(&mut self, name: &'static str, material: Phong) -> &mut Self {
        self.parts.push(Part { name, first: self.count(), material });
        self
    }

    /// Number of triangles so far.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "indices are u32 anyway")]
    pub fn count(&self) -> u32 {
        self.mesh.triangles.len() as u32
    }

    /// Number of triangles that are missing to so many.
    #[must_use]
    pub fn missing_to(&self, triangles: u32) -> u32 {
        triangles.saturating_sub(self.count())
    }

    /// Make room for so many triangles, of which about every vertex belongs to two.
    pub fn reserve(&mut self, triangles: u32) {
        self.mesh.triangles.reserve(triangles as usize);
        self.mesh.positions.reserve(triangles as usize / 2);
    }

    /// A new vertex, by its index.
    #[expect(clippy::cast_possible_truncation, reason = "indices are u32 anyway")]
    pub fn vertex(&mut self, position: Vec3) -> u32 {
        self.mesh.positions.push(position);
        (self.mesh.positions.len() - 1) as u32
    }

    /// A triangle between three vertices, counter-clockwise when seen from outside.
    pub fn triangle(&mut self, corners: [u32; 3]) {
        self.mesh.triangles.push(corners);
    }

    /// Two triangles between four corners, counter-clockwise when seen from outside.
    pub fn quad(&mut self, corners: [Vec3; 4]) {
        let [a, b, c, d] = corners.map(|corner| self.vertex(corner));
        self.triangle([a, b, c]);
        self.triangle([a, c, d]);
    }

    /// Forget parts that have got nothing.
    pub fn without_empty_parts(&mut self) {
        let ends: Vec<u32> =
            self.parts.iter().skip(1).map(|part| part.first).chain(std::iter::once(self.count())).collect();
        let mut ends = ends.into_iter();
        self.parts.retain(|part| ends.next().is_some_and(|end| part.first < end));
    }
}
