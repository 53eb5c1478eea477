//! Foliage: clouds of leaves, as plants in pots, climbers and crowns of trees have them.

use common::{Vec3, float};
use ray_casting::frame::Frame;

use super::{budget::ratio, builder::Builder, chance::Chance};

/// Leaves that grow around a point.
#[derive(Clone, Copy, Debug)]
pub struct Cloud {
    /// The middle.
    pub center: Vec3,
    /// Half its size along each axis.
    pub half: Vec3,
}

impl Builder {
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

    /// So many leaves in clouds, of the given length in scene units, as many in each cloud.
    pub fn leaves(&mut self, clouds: &[Cloud], number: u32, length: f32, fine: bool, chance: &mut Chance) {
        self.mesh.triangles.reserve(number as usize * if fine { 4 } else { 2 });
        self.mesh.positions.reserve(number as usize * if fine { 5 } else { 4 });
        for (_, cloud) in (0..number).zip(clouds.iter().cycle()) {
            // Most leaves are near the outside, where the light is.
            let direction = chance.direction();
            let depth = float::cbrt(chance.between(0.15, 1.0));
            let base = cloud.center + cloud.half * direction * depth;
            // Leaves point outward, hang a little, and turn their upper side to the sky.
            let along = (direction + chance.in_ball() * 0.9 - Vec3::Y * 0.25).normalize_or(Vec3::X);
            let up = direction * 0.6 + Vec3::Y * 0.7 + chance.in_ball() * 0.8;
            let across = up.cross(along).normalize_or(Vec3::Z);
            let length = length * chance.between(0.7, 1.3);
            self.leaf(base, along * length, across * (length * 0.27), fine);
        }
    }

    /// A pot of terracotta with a rim, and earth in it. It costs `14 · sides` triangles.
    pub fn pot(&mut self, frame: &Frame, radius: f32, height: f32, sides: u32) {
        let rim = height * 0.8;
        let profile = [
            [0.68, 0.0],
            [0.9, rim],
            [0.9, rim],
            [1.0, rim],
            [1.0, rim],
            [1.0, height],
            [1.0, height],
            [0.86, height],
            [0.86, height],
            [0.84, height * 0.9],
            [0.84, height * 0.9],
            [0.0, height * 0.92],
        ];
        let profile = profile.map(|[r, y]| common::Vec2::new(r * radius, y));
        self.turned(frame, &profile, sides);
    }
}

/// The length of leaves so that so many of them cover an area in square scene units once over.
#[must_use]
pub fn leaf_length(area: f32, number: u32) -> f32 {
    // A leaf is a rhombus, 0.54 of its length wide.
    (area / ratio(number.max(1), 1) / 0.27).sqrt()
}
