//! Curved surfaces: open ones, closed ones, and belts of which closed ones are made.

use common::{Vec3, float};

use super::{budget::ratio, builder::Builder};

impl Builder {
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

    /// A closed surface: the unit sphere, cut into columns and rows as a globe is by its lines, each of its points put in
    /// its place. It costs `2 · columns · (rows − 1)` triangles.
    pub fn closed_surface(&mut self, [columns, rows]: [u32; 2], place: impl Fn(Vec3) -> Vec3) {
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

    /// The triangles between two closed rings of vertices, counter-clockwise seen from above. Where a ring shrinks to a
    /// tip, be it one vertex or many in one place, there is no triangle along it.
    pub fn belt(&mut self, below: &[u32], above: &[u32]) {
        let place = |builder: &Self, vertex: u32| builder.mesh.positions[vertex as usize];
        for side in 0..below.len().max(above.len()) {
            let at = |ring: &[u32], side: usize| ring[side % ring.len()];
            let [a, b] = [at(below, side), at(below, side + 1)];
            let [c, d] = [at(above, side + 1), at(above, side)];
            if place(self, a) != place(self, b) {
                self.triangle([a, b, c]);
            }
            if place(self, c) != place(self, d) {
                self.triangle([a, c, d]);
            }
        }
    }
}
