//! The flat scene: triangles that stand on end, cut by a plane, so that each is seen as a short straight line.

use std::sync::Arc;

use common::{Error, Vec2, Vec3, float, obj::ObjMesh};
use ray_casting::{
    mesh::{Mesh, Shading},
    ray::Ray,
};

use crate::{scenes::chance::Chance, triangles::Triangles};

/// The height of the triangles: so flat that no structure parts them across it.
const FLAT: f32 = 1e-3;
/// The height of the plane that is drawn, a share of the triangles' height.
const CUT: f32 = 0.05;

/// The triangles, and the lines as which they are seen.
pub(super) struct Paper {
    pub(super) triangles: Triangles,
    /// From (0, 0) at the lower left to (1, 1).
    pub(super) lines: Vec<[Vec2; 2]>,
}

impl Paper {
    /// The scene.
    pub(super) fn new() -> Result<Self, Error> {
        let lines = lines();
        let mut obj = ObjMesh::default();
        for &[a, b] in &lines {
            // The foot is so much longer than the line that the cut is as long as the line.
            let over = (b - a) * (CUT / (1.0 - CUT) / 2.0);
            #[expect(clippy::cast_possible_truncation, reason = "few lines")]
            let first = obj.positions.len() as u32;
            obj.positions.extend([(a - over).extend(0.0), (b + over).extend(0.0), ((a + b) / 2.0).extend(FLAT)]);
            obj.triangles.push([first, first + 1, first + 2]);
        }
        Ok(Self { triangles: Triangles(Arc::new(Mesh::new(&obj, Shading::Flat)?)), lines })
    }
}

/// The ray that starts on the left edge, `height` above the lower one, and goes up by an angle in degrees.
pub(super) fn ray(height: f32, angle: f32) -> Ray {
    let angle = angle.to_radians();
    let direction = Vec3::new(float::cos(angle), float::sin(angle), 0.0);
    Ray::new(Vec3::new(-0.02, height, FLAT * CUT), direction)
}

/// The point of a drawing above the plane.
pub(super) fn seen(point: Vec3) -> Vec2 {
    point.truncate()
}

/// Whether the drawn plane cuts a box from one height to another.
pub(super) fn is_cut([low, high]: [f32; 2]) -> bool {
    (low..high).contains(&(FLAT * CUT))
}

fn lines() -> Vec<[Vec2; 2]> {
    let mut lines = Vec::new();
    // What reaches to the edges: a floor and a wall.
    lines.push([Vec2::new(0.0, 0.04), Vec2::new(1.0, 0.0)]);
    lines.push([Vec2::new(0.99, 0.02), Vec2::new(1.0, 1.0)]);
    // A large ring, a smaller one, and a very small one of as many lines.
    ring(&mut lines, Vec2::new(0.73, 0.62), 0.19, 18);
    ring(&mut lines, Vec2::new(0.325, 0.29), 0.055, 13);
    ring(&mut lines, Vec2::new(0.21, 0.80), 0.10, 8);
    // Crumbs.
    for i in 0..9 {
        let mut chance = Chance::of("crumb", i);
        let middle = Vec2::new(chance.between(0.46, 0.56), chance.between(0.27, 0.37));
        let along = chance.direction().truncate().normalize_or(Vec2::X) * 0.017;
        lines.push([middle - along, middle + along]);
    }
    lines
}

/// Lines around a point.
fn ring(lines: &mut Vec<[Vec2; 2]>, center: Vec2, radius: f32, count: u8) {
    let corner = |i: u8| {
        let angle = std::f32::consts::TAU * (f32::from(i) + 0.5) / f32::from(count);
        center + Vec2::new(float::cos(angle), float::sin(angle)) * radius
    };
    lines.extend((0..count).map(|i| [corner(i), corner(i + 1)]));
}
