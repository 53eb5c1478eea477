//! The café: round tables with chairs and cups under parasols.

use common::{Vec2, Vec3, color::srgb, float};
use ray_casting::{frame::Frame, material::Phong};

use crate::scenes::{
    budget::{grid, number, ratio, share},
    builder::Builder,
    chance::Chance,
    furniture::{LEAST_CHAIR, chair_shares},
};

/// Where tables stand; every second one has a parasol.
const TABLES: [[f32; 2]; 6] = [[5.6, -2.8], [7.9, -5.4], [4.4, -5.6], [9.4, -2.4], [8.6, -8.6], [6.6, -0.3]];
/// Height of the tables.
const HIGH: f32 = 0.74;
/// Chairs at each table.
const CHAIRS: u32 = 3;

/// Tables, chairs, cups and parasols.
pub(super) fn cafe(builder: &mut Builder, triangles: u32) {
    const FEWEST: u32 = CHAIRS * LEAST_CHAIR + 60;
    let tables = number(triangles, FEWEST, [0, 6]);
    let each = triangles / tables.max(1);
    let places = || TABLES.into_iter().zip(0..tables).map(|([x, z], i)| (Vec3::new(x, 0.0, z), i));
    let sides = number(share(each, 0.06).min(4_000), 14, [5, 128]);
    builder.part("tables", Phong::of(srgb(224, 220, 210), 0.3, 40.0));
    for (place, _) in places() {
        let outline = [[0.0, HIGH - 0.03], [0.4, HIGH - 0.03], [0.42, HIGH - 0.015], [0.4, HIGH], [0.0, HIGH]];
        builder.turned(&Frame::at(place), &outline.map(Vec2::from), sides);
    }
    builder.part("iron", Phong::of(srgb(58, 66, 64), 0.3, 30.0));
    for (place, _) in places() {
        let outline = [[0.24, 0.0], [0.22, 0.03], [0.035, 0.07], [0.03, HIGH - 0.03]];
        builder.turned(&Frame::at(place), &outline.map(Vec2::from), sides);
    }
    chairs(builder, &places().collect::<Vec<_>>(), share(each, 0.66) / CHAIRS);
    if each >= 2 * FEWEST {
        cups(builder, &places().map(|(place, _)| place).collect::<Vec<_>>(), share(each, 0.08));
    }
    let parasols: Vec<Vec3> = places().filter(|(_, i)| i % 2 == 0).map(|(place, _)| place).collect();
    self::parasols(builder, &parasols, share(each, 0.3));
}

/// Chairs around tables, drawn back a little.
fn chairs(builder: &mut Builder, tables: &[(Vec3, u32)], each: u32) {
    let mut frames = vec![];
    for &(table, index) in tables {
        let mut chance = Chance::of("chairs", index);
        let first = chance.between(0.0, 360.0);
        for i in 0..CHAIRS {
            let turn = first + 360.0 * ratio(i, CHAIRS) + chance.around(20.0);
            let frame = Frame::at(Vec3::ZERO).turned(Vec3::Y, turn);
            let away = frame.vector_to_world(Vec3::Z) * chance.between(0.55, 0.8);
            frames.push(Frame::at(table - away).turned(Vec3::Y, turn + chance.around(15.0)));
        }
    }
    let [wooden, padded] = chair_shares(each.min(60_000));
    builder.part("chairs", Phong::of(srgb(70, 92, 84), 0.2, 30.0));
    for frame in &frames {
        builder.chair_wood(frame, wooden);
    }
    builder.part("cushions", Phong::of(srgb(190, 92, 64), 0.05, 10.0));
    for frame in &frames {
        builder.chair_cushions(frame, padded);
    }
}

/// Cups on saucers.
fn cups(builder: &mut Builder, tables: &[Vec3], each: u32) {
    builder.part("cups", Phong::of(srgb(244, 240, 230), 0.5, 60.0));
    let sides = number(each.min(10_000) / 2, 20, [5, 200]);
    for (table, i) in tables.iter().zip(0..) {
        let mut chance = Chance::of("cups", i);
        for side in [-1.0, 1.0] {
            let place = *table + Vec3::new(side * 0.2, HIGH, chance.around(0.18));
            builder.cup(&Frame::at(place), 0.085, 0.012, sides);
            builder.cup(&Frame::at(place + Vec3::Y * 0.012), 0.042, 0.07, sides);
        }
    }
}

/// Parasols with eight ribs, and their poles.
fn parasols(builder: &mut Builder, tables: &[Vec3], each: u32) {
    const RIBS: u32 = 8;
    builder.part("parasols", Phong::of(srgb(244, 232, 206), 0.0, 1.0));
    let [around, steps] = grid(each.min(60_000), 6.0, [RIBS, 2]);
    let around = around.max(RIBS) / RIBS * RIBS;
    for &table in tables {
        let top = table + Vec3::Y * 2.95;
        // From the rim to the top; between ribs the cloth hangs, and its hem falls straight.
        builder.surface(around, steps, |u, v| {
            let turn = std::f32::consts::TAU * u;
            let sag = float::cos(turn * ratio(RIBS, 1)) * 0.5 - 0.5;
            let way = (1.0 - v).max(0.01);
            let radius = 1.75 * way * (1.0 + 0.05 * sag);
            let drop = 0.62 * way * (0.75 + 0.25 * way) - 0.1 * sag * way * (1.0 - way);
            top + Vec3::new(float::cos(turn) * radius, -drop, -float::sin(turn) * radius)
        });
    }
    builder.part("poles", Phong::of(srgb(168, 124, 82), 0.1, 20.0));
    for &table in tables {
        builder.bar(table, table + Vec3::Y * 3.05, 0.025, number(each / 40, 1, [4, 32]));
    }
}
