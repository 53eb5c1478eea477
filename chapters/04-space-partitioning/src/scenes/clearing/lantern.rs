//! The middle of the clearing: a lantern on a stone, in a ring of standing stones.

use common::{Vec2, Vec3, color::srgb, float};
use ray_casting::material::Phong;

use super::{
    super::{ball, budget::number, builder::Builder, chance::Chance, cuboid, noise::noise},
    ground,
};

/// Height of the stone under the lantern, in meters.
const PLINTH: f32 = 0.5;
/// Size of the lantern, whose sections and posts are given for size 1.
const SIZE: f32 = 1.5;
/// Height of the candle.
const CANDLE: f32 = 0.15;
/// The lantern's posts: how far from the middle, how high, how thick.
const POSTS: (f32, f32, f32) = (0.16, 0.38, 0.018);
/// Half sections of the stone, the lantern's floor, its roof with a knob, and the candle: distance from the axis, and
/// height above the floor. Points twice in sequence are sharp edges.
const STONE: [(f32, f32); 5] = [(0.4, -0.5), (0.34, -0.06), (0.3, -0.02), (0.3, -0.02), (0.0, -0.02)];
const PLAIN_STONE: [(f32, f32); 3] = [(0.4, -0.5), (0.3, -0.02), (0.0, -0.02)];
const FLOOR: [(f32, f32); 5] = [(0.2, -0.02), (0.2, 0.012), (0.2, 0.012), (0.17, 0.012), (0.0, 0.012)];
const ROOF: [(f32, f32); 9] = [
    (0.0, 0.38),
    (0.23, 0.37),
    (0.23, 0.37),
    (0.24, 0.385),
    (0.12, 0.46),
    (0.045, 0.53),
    (0.03, 0.56),
    (0.045, 0.59),
    (0.0, 0.62),
];
const WAX: [(f32, f32); 4] = [(0.05, 0.012), (0.047, CANDLE), (0.047, CANDLE), (0.0, CANDLE + 0.01)];
/// Number of standing stones, and the radius of their ring.
const STONES: u32 = 9;
const RING: f32 = 2.6;

/// Where the light of the lantern is: a little above the candle.
pub(super) fn flame() -> Vec3 {
    foot() + Vec3::Y * ((CANDLE + 0.06) * SIZE)
}

/// The middle of the lantern's floor.
fn foot() -> Vec3 {
    ground(0.0, 0.0) + Vec3::Y * PLINTH
}

/// The lantern, with about so many triangles.
pub(super) fn lantern(builder: &mut Builder, triangles: u32) {
    let posts = if triangles < 150 { 3 } else { 6 };
    let in_sections = 2 * (STONE.len() + FLOOR.len() + ROOF.len() + WAX.len()) as u32;
    let segments = number(triangles.saturating_sub(posts * cuboid::COST), in_sections, [3, 2000]);
    let turned = |builder: &mut Builder, section: &[(f32, f32)]| {
        let profile: Vec<Vec2> = section.iter().map(|&(x, y)| Vec2::new(x, y) * SIZE).collect();
        builder.turned_around(foot(), Vec3::Y, &profile, segments);
    };
    builder.part("lantern's stone", Phong::of(srgb(126, 124, 120), 0.0, 1.0));
    if triangles < 100 {
        return turned(builder, &PLAIN_STONE);
    }
    turned(builder, &STONE);
    builder.part("candle", Phong::of(srgb(250, 236, 200), 0.2, 20.0));
    turned(builder, &WAX);
    builder.part("lantern", Phong::of(srgb(62, 58, 56), 0.4, 30.0));
    turned(builder, &FLOOR);
    turned(builder, &ROOF);
    for post in 0..posts {
        let angle = std::f32::consts::TAU * (post as f32 + 0.25) / posts as f32;
        let place = foot() + Vec3::new(float::cos(angle), 0.0, float::sin(angle)) * (POSTS.0 * SIZE);
        builder.beam(place, place + Vec3::Y * (POSTS.1 * SIZE), POSTS.2 * SIZE);
    }
}

/// The ring of standing stones, with about so many triangles.
pub(super) fn stones(builder: &mut Builder, triangles: u32, chance: &mut Chance) {
    builder.part("standing stones", Phong::of(srgb(132, 134, 132), 0.0, 1.0));
    let stones = number(triangles, 8, [1, STONES]);
    let fineness = ball::fineness(triangles, stones);
    for stone in 0..stones {
        // A gap is toward the eye.
        let angle = std::f32::consts::TAU * (0.33 + 0.84 * (stone as f32 + chance.between(0.4, 0.6)) / stones as f32);
        let place = ground(RING * float::cos(angle), RING * float::sin(angle));
        let toward = Vec3::new(float::cos(angle), 0.0, float::sin(angle));
        let half = Vec3::new(chance.between(0.24, 0.36), chance.between(0.5, 0.85), chance.between(0.14, 0.2));
        let lean = Vec3::new(chance.around(0.12), 1.0, chance.around(0.12));
        standing_stone(
            builder,
            place,
            [Vec3::Y.cross(toward) * half.x, lean * half.y, toward * half.z],
            fineness,
            stone,
        );
    }
}

/// A stone of irregular shape: a ball, made square and rough, and set on its end.
fn standing_stone(builder: &mut Builder, foot: Vec3, half: [Vec3; 3], fineness: u32, seed: u32) {
    let first = builder.mesh.positions.len();
    builder.ball(Vec3::ZERO, 1.0, fineness);
    for position in &mut builder.mesh.positions[first..] {
        // Between a ball and a box.
        let square = *position / position.abs().max_element().max(0.5);
        let rough = 1.0 + 0.13 * noise(seed, 2.0 * position.x + position.z, 2.3 * position.y - position.z);
        let rough = rough + 0.04 * noise(seed, 7.0 * position.x + 5.0 * position.z, 8.0 * position.y);
        let place = position.lerp(square, 0.55) * rough;
        *position = foot + half[0] * place.x + half[1] * (place.y + 0.7) + half[2] * place.z;
    }
}
