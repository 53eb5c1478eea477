//! Tubes: round bodies along lines.

use common::{Basis, Vec3};

use super::builder::Builder;

impl Builder {
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

    /// A round bar between two points, without ends: two triangles for each side.
    pub fn bar(&mut self, from: Vec3, to: Vec3, radius: f32, sides: u32) {
        self.tube(&[from, to], sides, |_| radius);
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
