//! Prisms: flat outlines that have become thick.

use common::Vec2;
use ray_casting::frame::Frame;

use super::builder::Builder;

impl Builder {
    /// An outline in the frame's x and y, counter-clockwise, from `back` to `front` along its z, with flat
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
}
