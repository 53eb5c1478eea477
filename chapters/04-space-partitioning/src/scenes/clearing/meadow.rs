//! What grows on the ground: grass, flowers and mushrooms.

use common::{Rgb, Vec2, Vec3, color::srgb, float};
use ray_casting::material::Phong;

use super::{
    super::{budget::number, builder::Builder, chance::Chance, noise::noise},
    ground,
};

/// Triangles of a blade of grass and of a flower.
const BLADE: u32 = 3;
const FLOWER: u32 = 12;
/// Blades that grow from one place.
const TUFT: u32 = 9;
/// Radius of the stone in the middle, in meters.
const STONE: f32 = 0.65;
/// Half sections of a mushroom of height 1: distance from the axis and height.
const STEM: [(f32, f32); 3] = [(0.17, -0.1), (0.1, 0.2), (0.09, 0.75)];
const CAP: [(f32, f32); 7] =
    [(0.08, 0.74), (0.5, 0.62), (0.53, 0.66), (0.46, 0.82), (0.32, 0.94), (0.16, 0.99), (0.0, 1.0)];
/// Half section of a cap of few triangles.
const PLAIN_CAP: [(f32, f32); 3] = [(0.08, 0.7), (0.52, 0.64), (0.0, 1.0)];

/// A place that the eye sees, nearer ones more often.
fn seen_place(chance: &mut Chance) -> Vec3 {
    let near = chance.between(0.0, 1.0);
    let z = 6.6 - 16.0 * near * float::pow(near, 0.35);
    let half = 1.4 + 0.8 * (8.2 - z);
    let x = chance.between(-half, half);
    ground(x.clamp(-14.0, 14.0), z)
}

/// Grass of about so many triangles, in tufts.
pub(super) fn grass(builder: &mut Builder, triangles: u32, chance: &mut Chance) {
    let blades = (triangles / BLADE).max(3);
    let tuft = (blades / 60).clamp(1, TUFT);
    // Fewer blades are broader.
    let broad = float::pow(16_000.0 / blades as f32, 0.5).clamp(0.12, 8.0);
    let greens = [
        ("dark grass", srgb(64, 92, 44), 0.34),
        ("grass", srgb(100, 130, 56), 0.72),
        ("dry grass", srgb(158, 158, 88), 1.0),
    ];
    let mut grown = 0;
    for (name, color, until) in greens {
        builder.part(name, Phong::of(color, 0.0, 1.0));
        let last = ((blades as f32 * until) as u32).max(grown + 1);
        let mut place = seen_place(chance);
        let mut high = 1.0;
        for blade in grown..last {
            if blade % tuft == 0 {
                place = seen_place(chance);
                high = 1.0 + 0.6 * noise(5, place.x * 0.8, place.z * 0.8);
            }
            let aside = Vec3::new(chance.around(0.1), 0.0, chance.around(0.1)) * broad.min(2.0);
            let height = high * chance.between(0.12, 0.34) * broad.clamp(0.7, 1.6);
            let root = place + aside - Vec3::Y * 0.02;
            // No grass grows through the stone in the middle.
            let from_middle = Vec2::new(root.x, root.z).length();
            let root = root + Vec3::Z * (STONE - from_middle.min(STONE)) * 2.0;
            blade_of_grass(builder, root, height, 0.011 * broad, chance);
        }
        grown = last;
    }
}

/// A blade: a strip that bends and ends in a tip.
fn blade_of_grass(builder: &mut Builder, root: Vec3, height: f32, width: f32, chance: &mut Chance) {
    let angle = chance.angle();
    let lean = Vec3::new(float::cos(angle), 0.0, float::sin(angle)) * (height * chance.between(0.15, 0.6));
    let side = Vec3::new(-float::sin(angle), 0.0, float::cos(angle)) * (width / 2.0);
    let middle = root + Vec3::Y * (0.62 * height) + lean * 0.35;
    let tip = root + Vec3::Y * height + lean;
    let [a, b, c, d, e] = [root - side, root + side, middle + side * 0.8, middle - side * 0.8, tip]
        .map(|position| builder.vertex(position));
    builder.triangle([a, b, c]);
    builder.triangle([a, c, d]);
    builder.triangle([d, c, e]);
}

/// Flowers of about so many triangles.
pub(super) fn flowers(builder: &mut Builder, triangles: u32, chance: &mut Chance) {
    let flowers = triangles / FLOWER;
    let broad = float::pow(500.0 / flowers.max(1) as f32, 0.3).clamp(0.35, 2.0);
    let colors = [("white flowers", srgb(244, 240, 228)), ("violet flowers", srgb(158, 120, 214))];
    for (kind, (name, color)) in (0..).zip(colors) {
        let count = (flowers + kind) / 2;
        if count > 0 {
            builder.part(name, Phong::of(color, 0.0, 1.0));
        }
        for _ in 0..count {
            let place = seen_place(chance);
            // Each kind has its own patches.
            let shift = if (noise(9, place.x * 0.7, place.z * 0.7) > 0.0) == (kind == 0) { 0.0 } else { 1.3 };
            let place = ground(place.x + shift, place.z);
            flower(builder, place, chance.between(0.16, 0.32) * broad.max(0.8), 0.05 * broad, chance);
        }
    }
}

/// A flower: a stalk and five petals.
fn flower(builder: &mut Builder, root: Vec3, height: f32, size: f32, chance: &mut Chance) {
    let lean = Vec3::new(chance.around(0.2), 1.0, chance.between(-0.1, 0.3));
    let top = root + lean * height;
    let side = Vec3::X * (size * 0.06);
    builder.quad([root - side, root + side, top + side, top - side]);
    let turn = chance.angle();
    for petal in 0..5 {
        let at = |quarter: f32, out: f32, up: f32| {
            let angle = turn + std::f32::consts::TAU * (petal as f32 + quarter) / 5.0;
            top + Vec3::new(float::cos(angle) * out, up, -float::sin(angle) * out) * size
        };
        builder.quad([top, at(-0.4, 0.7, 0.25), at(0.0, 1.1, 0.2), at(0.4, 0.7, 0.25)]);
    }
}

/// Mushrooms of about so many triangles: a ring around the stones, and a few near the eye.
pub(super) fn mushrooms(builder: &mut Builder, triangles: u32, chance: &mut Chance) {
    let plain = triangles < 1500;
    let cap: &[(f32, f32)] = if plain { &PLAIN_CAP } else { &CAP };
    let count = number(triangles, if plain { 30 } else { 200 }, [1, 46]);
    // Two triangles for each segment and step.
    let steps = (cap.len() + STEM.len() - 2) as u32;
    let segments = (triangles / count / (2 * steps)).max(3);
    let all: Vec<(Vec3, Vec3, f32)> = (0..count)
        .map(|mushroom| {
            let turn = mushroom as f32 * 0.618_034;
            let place = if mushroom % 3 == 1 {
                // In groups before the stones.
                let group = [Vec2::new(-2.5, 4.3), Vec2::new(1.9, 4.9), Vec2::new(2.9, 3.3)][mushroom as usize / 3 % 3];
                group + Vec2::new(chance.around(0.35), chance.around(0.3))
            } else {
                let angle = std::f32::consts::TAU * turn;
                Vec2::new(float::cos(angle), float::sin(angle)) * chance.between(1.5, 1.9)
            };
            let axis = Vec3::new(chance.around(0.2), 1.0, chance.between(-0.1, 0.2)).normalize_or(Vec3::Y);
            (ground(place.x, place.y), axis, chance.between(0.16, 0.36))
        })
        .collect();
    let mut turned = |name, color: Rgb, gloss, section: &[(f32, f32)]| {
        builder.part(name, Phong::of(color, gloss, 30.0));
        for &(foot, axis, size) in &all {
            let profile: Vec<Vec2> = section.iter().map(|&(x, y)| Vec2::new(x, y) * size).collect();
            builder.turned_around(foot, axis, &profile, segments);
        }
    };
    turned("mushrooms' stems", srgb(236, 226, 204), 0.0, &STEM);
    turned("mushrooms' caps", srgb(190, 42, 30), 0.3, cap);
}
