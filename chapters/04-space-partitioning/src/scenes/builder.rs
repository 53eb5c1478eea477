//! The builder: takes triangles, quads, curved surfaces and tubes, and keeps them as parts of one mesh.

use common::{Basis, Vec3, obj::ObjMesh};
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

    /// A curved surface: `place(u, v)` for `u` and `v` from 0 to 1 in equal steps, two triangles for each step of both.
    /// Its outside is where `∂place/∂u × ∂place/∂v` points.
    #[expect(clippy::cast_precision_loss, reason = "a row has far fewer than 2²⁴ vertices")]
    pub fn surface(&mut self, columns: u32, rows: u32, mut place: impl FnMut(f32, f32) -> Vec3) {
        let (columns, rows) = (columns.max(1), rows.max(1));
        #[expect(clippy::cast_possible_truncation, reason = "indices are u32 anyway")]
        let first = self.mesh.positions.len() as u32;
        for row in 0..=rows {
            for column in 0..=columns {
                self.vertex(place(column as f32 / columns as f32, row as f32 / rows as f32));
            }
        }
        let index = |column, row| first + row * (columns + 1) + column;
        for row in 0..rows {
            for column in 0..columns {
                let (a, b) = (index(column, row), index(column + 1, row));
                let (c, d) = (index(column + 1, row + 1), index(column, row + 1));
                self.triangle([a, b, c]);
                self.triangle([a, c, d]);
            }
        }
    }

    /// A tube without ends around a line of points, `radius(i)` wide at the point of index `i`, with flat sides.
    #[expect(clippy::cast_precision_loss, reason = "few sides")]
    #[expect(clippy::cast_possible_truncation, reason = "indices are u32 anyway")]
    pub fn tube(&mut self, points: &[Vec3], sides: u32, radius: impl Fn(usize) -> f32) {
        let sides = sides.max(3);
        let first = self.mesh.positions.len() as u32;
        let mut before: Option<Basis> = None;
        for (i, &point) in points.iter().enumerate() {
            // Around the direction from the point before to the point after. The first vector across it is the one of
            // the point before, turned as little as possible, so that the tube does not twist.
            let direction = points[(i + 1).min(points.len() - 1)] - points[i.saturating_sub(1)];
            let normal = direction.normalize_or(Vec3::Y);
            let basis = before.map_or_else(|| Basis::around(normal), |before| leaned(before, normal));
            before = Some(basis);
            for side in 0..sides {
                let angle = std::f32::consts::TAU * side as f32 / sides as f32;
                let (sin, cos) = (common::float::sin(angle), common::float::cos(angle));
                self.vertex(point + (basis.tangent * cos + basis.bitangent * sin) * radius(i));
            }
        }
        for ring in 1..points.len() as u32 {
            for side in 0..sides {
                let at = |ring: u32, side: u32| first + ring * sides + side % sides;
                let [a, b] = [at(ring - 1, side), at(ring - 1, side + 1)];
                let [c, d] = [at(ring, side + 1), at(ring, side)];
                self.triangle([a, b, c]);
                self.triangle([a, c, d]);
            }
        }
    }
}

/// The basis around another unit vector that is turned from `before` as little as can be.
fn leaned(before: Basis, normal: Vec3) -> Basis {
    match (before.tangent - normal * before.tangent.dot(normal)).try_normalize() {
        Some(tangent) => Basis { tangent, bitangent: normal.cross(tangent), normal },
        None => Basis::around(normal),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tube_does_not_twist_where_it_turns_back() {
        // Around a half circle in the plane of x and z: the direction's z changes its sign.
        let angles = (0_u8..=16).map(|i| std::f32::consts::PI * f32::from(i) / 16.0);
        let points: Vec<Vec3> =
            angles.map(|angle| Vec3::new(common::float::cos(angle), 0.0, common::float::sin(angle))).collect();
        let mut builder = Builder::default();
        builder.tube(&points, 4, |_| 0.1);
        let rings: Vec<&[Vec3]> = builder.mesh.positions.chunks(4).collect();
        for pair in rings.windows(2) {
            for (a, b) in pair[0].iter().zip(pair[1]) {
                assert!(a.distance(*b) < 0.25, "{a} {b}");
            }
        }
    }
}
