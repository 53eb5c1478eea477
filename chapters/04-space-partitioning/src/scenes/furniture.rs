//! Furniture: chairs, legs, lamps, books.

use common::{Vec2, Vec3, float};
use ray_casting::frame::Frame;

use super::{
    budget::{grid, ratio, share},
    builder::Builder,
    chance::Chance,
    cushion,
};

/// Fewest columns and rows of a cushion: a box.
const CUSHION: [u32; 2] = [4, 3];
/// Height of a chair's seat.
const SEAT: f32 = 0.44;

/// Number of triangles of the smallest chair, wood and cushions together.
pub const LEAST_CHAIR: u32 = 67;

impl Builder {
    /// The wood of a chair that looks along its frame's z: four legs and the two posts of its back.
    pub fn chair_wood(&mut self, frame: &Frame, triangles: u32) {
        let [sides, steps] = grid(triangles / 7, 1.0, [3, 1]);
        for (x, z) in [(-0.19, 0.2), (0.19, 0.2), (-0.19, -0.2), (0.19, -0.2)] {
            self.limb(frame, [Vec3::new(x * 1.1, 0.0, z * 1.1), Vec3::new(x, SEAT, z)], [0.014, 0.024], sides, steps);
        }
        // The posts lean back a little.
        for x in [-0.19, 0.19] {
            self.limb(frame, [Vec3::new(x, SEAT, -0.2), Vec3::new(x, 0.98, -0.3)], [0.022, 0.015], sides, steps);
        }
        // The rails under the seat.
        if triangles >= 6 * 6 + 12 {
            self.cuboid(frame, Vec3::new(-0.21, SEAT - 0.05, -0.21), Vec3::new(0.21, SEAT, 0.22));
        }
    }

    /// The cushions of the same chair: a seat and a bent back.
    pub fn chair_cushions(&mut self, frame: &Frame, triangles: u32) {
        let steps = grid(triangles / 2, 1.6, CUSHION);
        let (middle, half) = (Vec3::new(0.0, SEAT + 0.04, 0.01), Vec3::new(0.24, 0.055, 0.24));
        self.cushion(frame, middle, half, steps, 4.0);
        self.closed_surface(steps, |p| {
            let round = p / cushion::distance(p, 4.0);
            let (x, y) = (round.x * 0.23, 0.76 + round.y * 0.2);
            // Leaning like the posts, and hollow for a back.
            let z = -0.225 - 0.185 * (y - SEAT) + round.z * 0.035 + 0.06 * (x / 0.23) * (x / 0.23);
            frame.point_to_world(Vec3::new(x, y, z))
        });
    }

    /// A round bar from one point of a frame to another, that becomes thicker or thinner.
    fn limb(&mut self, frame: &Frame, ends: [Vec3; 2], radii: [f32; 2], sides: u32, steps: u32) {
        let points: Vec<Vec3> =
            (0..=steps).map(|i| frame.point_to_world(ends[0].lerp(ends[1], ratio(i, steps)))).collect();
        let last = steps.max(1);
        self.tube(&points, sides, |i| radii[0] + (radii[1] - radii[0]) * i as f32 / ratio(last, 1));
    }

    /// A turned leg of a table with bulges, from the floor to a height. It costs about so many triangles.
    pub fn table_leg(&mut self, frame: &Frame, height: f32, radius: f32, triangles: u32) {
        let [sides, steps] = grid(triangles, 0.7, [3, 1]);
        let profile: Vec<Vec2> = (0..=steps)
            .map(|i| ratio(i, steps))
            .map(|y| {
                let bulge = 0.72 + 0.22 * float::sin(y * 9.5) * y + 0.12 * float::cos(y * 31.0);
                Vec2::new(radius * if y > 0.0 && y < 1.0 { bulge } else { 0.9 }, height * y)
            })
            .collect();
        self.turned(frame, &profile, sides);
    }

    /// The cover of a book that stands upright with its spine toward its frame's z, the spine cut into steps around and
    /// upward. It costs 8 triangles more than the spine.
    pub fn book(&mut self, frame: &Frame, size: Vec3, [rounds, steps]: [u32; 2]) {
        let half = size.x / 2.0;
        let at = |x: f32, y: f32, z: f32| frame.point_to_world(Vec3::new(x, y, z));
        let bulge = if rounds > 1 { half * 0.45 } else { 0.0 };
        self.surface(rounds, steps, |u, v| {
            let x = 2.0 * u - 1.0;
            // Raised bands cross the spine where it is cut finely enough for them.
            let band = if steps > 40 && float::cos(v * 31.4) > 0.93 && v < 0.95 { 0.002 } else { 0.0 };
            at(x * half, v * size.y, (bulge + band) * (1.0 - x * x))
        });
        for side in [-1.0, 1.0] {
            let (near, far) = if side > 0.0 { (0.0, -size.z) } else { (-size.z, 0.0) };
            let x = side * half;
            self.quad([at(x, 0.0, near), at(x, 0.0, far), at(x, size.y, far), at(x, size.y, near)]);
        }
        // Above and below.
        self.quad([
            at(-half, size.y, 0.0),
            at(half, size.y, 0.0),
            at(half, size.y, -size.z),
            at(-half, size.y, -size.z),
        ]);
        self.quad([at(-half, 0.0, -size.z), at(half, 0.0, -size.z), at(half, 0.0, 0.0), at(-half, 0.0, 0.0)]);
    }

    /// An open book that lies on a table: two pages that bend.
    pub fn open_book(&mut self, frame: &Frame, steps: u32) {
        const WIDE: f32 = 0.19;
        const HIGH: f32 = 0.26;
        self.surface(2 * steps.max(1), 1, |u, v| {
            let x = 2.0 * u - 1.0;
            let y = 0.006
                + 0.035 * (1.0 - (2.0 * x.abs() - 0.7) * (2.0 * x.abs() - 0.7) * 0.6).max(0.0) * x.abs().min(0.35);
            frame.point_to_world(Vec3::new(x * WIDE, y, HIGH * (0.5 - v)))
        });
    }

    /// A cup or bowl: a turned body, open above.
    pub fn cup(&mut self, frame: &Frame, radius: f32, height: f32, sides: u32) {
        let profile =
            [[0.0, 0.0], [0.6, 0.0], [0.6, 0.0], [0.95, 0.4], [1.0, 1.0], [0.9, 1.0], [0.84, 0.4], [0.0, 0.1]];
        self.turned(frame, &profile.map(|[r, y]| Vec2::new(r * radius, y * height)), sides);
    }

    /// A curtain or a banner with folds, hung up in its frame between two corners: both sides are seen.
    pub fn drapery(&mut self, frame: &Frame, low: Vec2, high: Vec2, folds: f32, triangles: u32, chance: &mut Chance) {
        let [columns, rows] = grid(triangles, (high.x - low.x) * 8.0 / (high.y - low.y), [2, 1]);
        let phase = chance.between(0.0, 6.0);
        let depth = 0.35 * (high.x - low.x) / folds;
        self.surface(columns, rows, |u, v| {
            // Folds are deeper below, where nothing holds them, and wander a little.
            let wave = float::sin(u * folds * std::f32::consts::TAU + phase + 0.8 * float::sin(2.3 * v + phase));
            let sway = 0.3 * float::sin(5.0 * u + 3.0 * (1.0 - v) + phase);
            let deep = depth * (0.55 + 0.45 * (1.0 - v));
            let at = low + (high - low) * Vec2::new(u, v);
            frame.point_to_world(at.extend(deep * (wave + sway * (1.0 - v))))
        });
    }
}

/// What a chair's budget is spent on: wood, then cushions.
#[must_use]
pub fn chair_shares(triangles: u32) -> [u32; 2] {
    [share(triangles, 0.4), share(triangles, 0.6)]
}
