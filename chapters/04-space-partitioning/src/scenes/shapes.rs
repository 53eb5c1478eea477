//! Shapes of which things are made: boxes, bars, balls, cushions, turned and extruded bodies, leaves.

use common::{Vec2, Vec3, float};
use ray_casting::frame::Frame;

use super::{budget::ratio, builder::Builder};

impl Builder {
    /// A box in a frame, between its least and its greatest corner: 12 triangles.
    pub fn cuboid(&mut self, frame: &Frame, low: Vec3, high: Vec3) {
        let corner = |x: bool, y: bool, z: bool| {
            let pick = |upper, axis: usize| if upper { high[axis] } else { low[axis] };
            frame.point_to_world(Vec3::new(pick(x, 0), pick(y, 1), pick(z, 2)))
        };
        let (f, t) = (false, true);
        self.quad([corner(f, f, t), corner(t, f, t), corner(t, t, t), corner(f, t, t)]);
        self.quad([corner(t, f, f), corner(f, f, f), corner(f, t, f), corner(t, t, f)]);
        self.quad([corner(t, f, t), corner(t, f, f), corner(t, t, f), corner(t, t, t)]);
        self.quad([corner(f, f, f), corner(f, f, t), corner(f, t, t), corner(f, t, f)]);
        self.quad([corner(f, t, t), corner(t, t, t), corner(t, t, f), corner(f, t, f)]);
        self.quad([corner(f, f, f), corner(t, f, f), corner(t, f, t), corner(f, f, t)]);
    }

    /// A box of the scene itself.
    pub fn block(&mut self, low: [f32; 3], high: [f32; 3]) {
        self.cuboid(&Frame::at(Vec3::ZERO), low.into(), high.into());
    }

    /// A body turned on a lathe around the frame's y axis: the profile has radius and height of each ring, upward where
    /// the outside is outside. A point twice in a row makes an edge. Each step costs two triangles for each side, or one
    /// at a tip of radius 0.
    pub fn turned(&mut self, frame: &Frame, profile: &[Vec2], sides: u32) {
        let sides = sides.max(3);
        let directions: Vec<Vec2> = (0..sides)
            .map(|side| std::f32::consts::TAU * ratio(side, sides))
            .map(|angle| Vec2::new(float::cos(angle), -float::sin(angle)))
            .collect();
        let mut below: Option<(Vec2, Vec<u32>)> = None;
        for &point in profile {
            let at = |direction: Vec2| {
                frame.point_to_world(Vec3::new(direction.x * point.x, point.y, direction.y * point.x))
            };
            let ring: Vec<u32> = match point.x == 0.0 {
                true => vec![self.vertex(at(Vec2::ZERO))],
                false => directions.iter().map(|&direction| self.vertex(at(direction))).collect(),
            };
            if let Some((_, below)) = below.filter(|(last, _)| *last != point) {
                self.belt(&below, &ring);
            }
            below = Some((point, ring));
        }
    }

    /// The triangles between two closed rings, counter-clockwise seen from above. A tip is a ring of one vertex.
    pub fn belt(&mut self, below: &[u32], above: &[u32]) {
        let sides = below.len().max(above.len());
        for side in 0..sides {
            let at = |ring: &[u32], side: usize| ring[side % ring.len()];
            let [a, b] = [at(below, side), at(below, side + 1)];
            let [c, d] = [at(above, side + 1), at(above, side)];
            if a != b {
                self.triangle([a, b, c]);
            }
            if c != d {
                self.triangle([a, c, d]);
            }
        }
    }

    /// A closed surface: the unit sphere, cut into columns and rows, each of its points put in its place. It costs
    /// `2 · columns · (rows − 1)` triangles.
    pub fn ball(&mut self, [columns, rows]: [u32; 2], place: impl Fn(Vec3) -> Vec3) {
        let (columns, rows) = (columns.max(3), rows.max(2));
        // Four columns make a box, not a diamond.
        let turn = 1.0 / 8.0;
        let mut below = vec![self.vertex(place(-Vec3::Y))];
        for row in 1..=rows {
            let height = std::f32::consts::PI * (ratio(row, rows) - 0.5);
            let (radius, y) = (float::cos(height), float::sin(height));
            let ring: Vec<u32> = match row == rows {
                true => vec![self.vertex(place(Vec3::Y))],
                false => (0..columns)
                    .map(|column| {
                        let angle = std::f32::consts::TAU * (ratio(column, columns) + turn);
                        self.vertex(place(Vec3::new(float::cos(angle) * radius, y, -float::sin(angle) * radius)))
                    })
                    .collect(),
            };
            self.belt(&below, &ring);
            below = ring;
        }
    }

    /// A box with round edges, like a cushion: the higher the power, the sharper.
    pub fn cushion(&mut self, frame: &Frame, center: Vec3, half: Vec3, steps: [u32; 2], power: f32) {
        self.ball(steps, |p| {
            let sum: f32 = p.to_array().iter().map(|c| float::pow(c.abs(), power)).sum();
            frame.point_to_world(center + half * p / float::pow(sum, 1.0 / power))
        });
    }

    /// A round bar between two points, without ends: two triangles for each side.
    pub fn bar(&mut self, from: Vec3, to: Vec3, radius: f32, sides: u32) {
        self.tube(&[from, to], sides, |_| radius);
    }

    /// A prism: an outline in the frame's x and y, counter-clockwise, from `back` to `front` along its z, with flat
    /// ends when the outline is convex. It costs `4 n − 4` triangles for `n` points.
    pub fn prism(&mut self, frame: &Frame, outline: &[Vec2], back: f32, front: f32) {
        for (i, &start) in outline.iter().enumerate() {
            let end = outline[(i + 1) % outline.len()];
            let at = |point: Vec2, z| frame.point_to_world(point.extend(z));
            self.quad([at(start, back), at(end, back), at(end, front), at(start, front)]);
        }
        for (z, first, second) in [(front, 0, 1), (back, 1, 0)] {
            let corners: Vec<u32> =
                outline.iter().map(|point| self.vertex(frame.point_to_world(point.extend(z)))).collect();
            for pair in corners.windows(2).skip(1) {
                self.triangle([corners[0], pair[first], pair[second]]);
            }
        }
    }

    /// A leaf from its stalk along a vector, half as wide as `across` is long, folded along its middle. Its upper side
    /// is where `along × across` points. It costs 2 triangles, a fine one 4.
    pub fn leaf(&mut self, base: Vec3, along: Vec3, across: Vec3, fine: bool) {
        let up = along.cross(across).normalize_or_zero() * across.length();
        let [middle, fold] = [base + along * 0.45, up * 0.35];
        let stalk = self.vertex(base);
        let right = self.vertex(middle - across + fold);
        let tip = self.vertex(base + along - up * 0.3);
        let left = self.vertex(middle + across + fold);
        if fine {
            let rib = self.vertex(base + along * 0.5 + up * 0.1);
            for [from, to] in [[stalk, right], [right, tip], [tip, left], [left, stalk]] {
                self.triangle([from, to, rib]);
            }
        } else {
            self.triangle([stalk, right, tip]);
            self.triangle([stalk, tip, left]);
        }
    }

    /// Forget parts that have got nothing.
    pub fn without_empty_parts(&mut self) {
        let ends: Vec<u32> =
            self.parts.iter().skip(1).map(|part| part.first).chain(std::iter::once(self.count())).collect();
        let mut ends = ends.into_iter();
        self.parts.retain(|part| ends.next().is_some_and(|end| part.first < end));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Six times the volume inside a closed mesh: positive if its triangles face outward.
    fn volume(builder: &Builder) -> f32 {
        let at = |i: u32| builder.mesh.positions[i as usize];
        builder.mesh.triangles.iter().map(|&[a, b, c]| at(a).cross(at(b)).dot(at(c))).sum()
    }

    #[test]
    fn closed_bodies_face_outward() {
        let frame = Frame::at(Vec3::new(0.1, 0.2, 0.3)).turned(Vec3::Y, 30.0);
        let bodies: [fn(&mut Builder, &Frame); 4] = [
            |b, f| b.cuboid(f, Vec3::ZERO, Vec3::ONE),
            |b, f| b.cushion(f, Vec3::ZERO, Vec3::splat(0.5), [12, 8], 4.0),
            |b, f| b.turned(f, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Vec2::from), 8),
            |b, f| b.prism(f, &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(Vec2::from), 0.0, 1.0),
        ];
        for body in bodies {
            let mut builder = Builder::default();
            body(&mut builder, &frame);
            assert!(volume(&builder) > 1.0);
        }
    }

    #[test]
    fn the_costs_are_as_said() {
        let frame = Frame::at(Vec3::ZERO);
        let cost = |make: &dyn Fn(&mut Builder)| {
            let mut builder = Builder::default();
            make(&mut builder);
            builder.count()
        };
        assert_eq!(cost(&|b| b.cuboid(&frame, Vec3::ZERO, Vec3::ONE)), 12);
        assert_eq!(cost(&|b| b.ball([5, 4], |p| p)), 2 * 5 * 3);
        assert_eq!(cost(&|b| b.bar(Vec3::ZERO, Vec3::Y, 0.1, 6)), 12);
        assert_eq!(cost(&|b| b.leaf(Vec3::ZERO, Vec3::X, Vec3::Y, true)), 4);
        assert_eq!(cost(&|b| b.prism(&frame, &[Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y], 0.0, 1.0)), 12);
    }
}
