//! Boxes: between two corners in a frame, or around a middle toward anywhere, as beams are.

use common::{Basis, Vec3};
use ray_casting::frame::Frame;

use super::builder::Builder;

/// Triangles of a box: two for each of its six sides.
pub const COST: u32 = 12;

impl Builder {
    /// A box in a frame, between its least and its greatest corner.
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

    /// The same along the axes of the scene.
    pub fn block(&mut self, low: [f32; 3], high: [f32; 3]) {
        self.cuboid(&Frame::at(Vec3::ZERO), low.into(), high.into());
    }

    /// A box around its middle, that reaches so far to both sides in three directions at right angles, right-handed.
    pub fn cuboid_around(&mut self, center: Vec3, half: [Vec3; 3]) {
        // Each pair of opposite sides, spanned by the other two directions.
        for i in 0..3 {
            let [out, u, v] = [half[i], half[(i + 1) % 3], half[(i + 2) % 3]];
            let (near, far) = (center + out, center - out);
            self.quad([near - u - v, near + u - v, near + u + v, near - u + v]);
            self.quad([far - u - v, far - u + v, far + u + v, far + u - v]);
        }
    }

    /// A straight beam of square section.
    pub fn beam(&mut self, from: Vec3, to: Vec3, thickness: f32) {
        let along = (to - from) / 2.0;
        let basis = Basis::around(along.normalize_or(Vec3::Y));
        let half = thickness / 2.0;
        self.cuboid_around(from + along, [basis.tangent * half, basis.bitangent * half, along]);
    }
}
