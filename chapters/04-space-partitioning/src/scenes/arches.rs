//! Walls with round arches.

use common::{Vec2, Vec3, float};
use ray_casting::frame::Frame;

use super::{budget::ratio, builder::Builder};

/// A piece of wall with one round-arched opening in its middle. In its frame the wall's face looks along z, and x runs
/// along the wall.
#[derive(Clone, Copy, Debug)]
pub struct Arch {
    /// Width of the piece.
    pub width: f32,
    /// Height of its lower edge: that of `spring` where columns carry it, lower where it has jambs.
    pub bottom: f32,
    /// Height where the round part begins.
    pub spring: f32,
    /// Height of its upper edge.
    pub top: f32,
    /// Half the width of the opening.
    pub radius: f32,
    /// Thickness of the wall.
    pub depth: f32,
}

/// Which faces of a wall are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Faces {
    /// Only the one that is seen.
    Front,
    /// Both.
    Both,
}

impl Arch {
    /// The point of the round part at a share of the way over it, from the right to the left.
    #[must_use]
    pub fn over(&self, share: f32, radius: f32) -> Vec2 {
        let angle = std::f32::consts::PI * share;
        Vec2::new(float::cos(angle), float::sin(angle)) * radius + Vec2::Y * self.spring
    }

    /// Number of triangles of [`Builder::arch`].
    #[must_use]
    pub fn cost(segments: u32, faces: Faces) -> u32 {
        match faces {
            Faces::Front => 4 * segments + 8,
            Faces::Both => 6 * segments + 12,
        }
    }

    /// How many segments so many triangles pay for, at least two.
    #[must_use]
    pub fn segments(triangles: u32, faces: Faces) -> u32 {
        let left = triangles.saturating_sub(Self::cost(0, faces));
        (left / (Self::cost(1, faces) - Self::cost(0, faces))).max(2)
    }
}

impl Builder {
    /// The wall around an arch: its faces and the inside of the opening.
    pub fn arch(&mut self, frame: &Frame, arch: &Arch, segments: u32, faces: Faces) {
        let at = |x: f32, y: f32, z: f32| frame.point_to_world(Vec3::new(x, y, z));
        let (half, back) = (arch.width / 2.0, -arch.depth);
        // Above the opening.
        for i in 0..segments {
            let [a, b] = [i, i + 1].map(|i| arch.over(ratio(i, segments), arch.radius));
            self.quad([at(b.x, b.y, 0.0), at(a.x, a.y, 0.0), at(a.x, arch.top, 0.0), at(b.x, arch.top, 0.0)]);
            if faces == Faces::Front {
                continue;
            }
            self.quad([at(a.x, a.y, back), at(b.x, b.y, back), at(b.x, arch.top, back), at(a.x, arch.top, back)]);
        }
        self.surface(segments, 1, |u, v| {
            let point = arch.over(u, arch.radius);
            at(point.x, point.y, back * v)
        });
        // Beside it.
        for [left, right] in [[-half, -arch.radius], [arch.radius, half]] {
            let (low, high) = (arch.bottom, arch.top);
            self.quad([at(left, low, 0.0), at(right, low, 0.0), at(right, high, 0.0), at(left, high, 0.0)]);
            if faces == Faces::Both {
                self.quad([at(right, low, back), at(left, low, back), at(left, high, back), at(right, high, back)]);
            }
            // Its lower side where columns carry it, otherwise the jamb.
            if arch.bottom == arch.spring {
                self.quad([at(left, low, back), at(right, low, back), at(right, low, 0.0), at(left, low, 0.0)]);
            } else if left < 0.0 {
                let high = arch.spring;
                self.quad([at(right, low, 0.0), at(right, low, back), at(right, high, back), at(right, high, 0.0)]);
            } else {
                let high = arch.spring;
                self.quad([at(left, low, back), at(left, low, 0.0), at(left, high, 0.0), at(left, high, back)]);
            }
        }
    }

    /// A molding around an arch: a half-round bar that stands before the wall. It costs `2 · segments · rounds`
    /// triangles.
    pub fn molding(&mut self, frame: &Frame, arch: &Arch, thickness: f32, [segments, rounds]: [u32; 2]) {
        self.surface(rounds, segments, |u, v| {
            // Across the bar from its inner to its outer edge, bulging forward.
            let across = arch.over(1.0 - u, 1.0) - Vec2::Y * arch.spring;
            let point = arch.over(v, arch.radius + thickness * (1.0 + across.x));
            frame.point_to_world(point.extend(thickness * across.y))
        });
    }

    /// Bars in an opening: a frame that crosses it from left to right and from bottom to top, each bar a box.
    pub fn muntins(&mut self, frame: &Frame, [left, right]: [f32; 2], [low, high]: [f32; 2], [across, up]: [u32; 2]) {
        const HALF: f32 = 0.022;
        let bar = Vec3::splat(HALF);
        for i in 0..=across {
            let x = left + (right - left) * ratio(i, across);
            self.cuboid(frame, Vec3::new(x, low, 0.0) - bar, Vec3::new(x, high, 0.0) + bar);
        }
        for i in 0..=up {
            let y = low + (high - low) * ratio(i, up);
            self.cuboid(frame, Vec3::new(left, y, 0.0) - bar * 0.9, Vec3::new(right, y, 0.0) + bar * 0.9);
        }
    }
}
