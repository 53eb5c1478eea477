//! A photographer's backdrop, for things that are shown alone.

use common::{Vec3, float};

use super::builder::Builder;

impl Builder {
    /// A floor at height 0 that runs to `depth` behind the origin and bends upward there into a wall. It has four
    /// triangles for each of `rows` rows, which are at least 5.
    pub fn backdrop(&mut self, width: f32, depth: f32, height: f32, rows: u32) {
        let rows = rows.max(5);
        let bend = height / 2.0;
        self.surface(2, rows, |u, v| {
            let x = width * (u - 0.5);
            // The floor is the first row, the wall the last, all the others make the bend: a quarter of a circle.
            let row = (v * rows as f32).round();
            if row < 1.0 {
                return Vec3::new(x, 0.0, 2.0 * depth);
            }
            if row >= rows as f32 {
                return Vec3::new(x, height, -depth);
            }
            let angle = std::f32::consts::FRAC_PI_2 * (row - 1.0) / (rows - 2) as f32;
            Vec3::new(x, bend * (1.0 - float::cos(angle)), bend - depth - bend * float::sin(angle))
        });
    }
}
