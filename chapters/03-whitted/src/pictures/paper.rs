//! Surroundings of a photographer: an endless roll of paper and two soft boxes.

use common::{Rgb, Vec3};
use ray_casting::background::Background;

// ANCHOR: paper
/// Paper that is bright at the horizon and darker above, with two lit windows that only mirrors see.
pub(super) struct Paper {
    /// The radiance at the horizon, where the paper meets the floor.
    pub(super) horizon: Rgb,
}

impl Background for Paper {
    fn radiance(&self, direction: Vec3) -> Rgb {
        let direction = direction.normalize();
        // A large box on the left behind the camera, a narrow one on the right.
        let large = softbox(direction, Vec3::new(-1.0, 0.9, 0.9), [0.45, 0.45]);
        let narrow = softbox(direction, Vec3::new(1.0, 0.35, 0.3), [0.1, 0.5]);
        let paper = self.horizon * (1.0 - 0.6 * direction.y.clamp(0.0, 1.0).sqrt());
        paper + Rgb::new(3.2, 3.1, 2.9) * large + Rgb::new(1.6, 1.8, 2.1) * narrow
    }
}

/// 1 in directions to a rectangle around `middle`, 0 elsewhere. `half` is half its width and height, at distance 1.
fn softbox(direction: Vec3, middle: Vec3, half: [f32; 2]) -> f32 {
    let forward = middle.normalize();
    let right = forward.cross(Vec3::Y).normalize();
    let up = right.cross(forward);
    let [across, along, ahead] = [right, up, forward].map(|axis| axis.dot(direction));
    if across.abs() < half[0] * ahead && along.abs() < half[1] * ahead { 1.0 } else { 0.0 }
}
// ANCHOR_END: paper
