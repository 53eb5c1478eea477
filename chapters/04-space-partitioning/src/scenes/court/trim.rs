//! What the building is trimmed with: cornices, balustrades, and the paving before it.

use common::{Vec2, Vec3, color::srgb, float};
use ray_casting::{frame::Frame, material::Phong};

use super::{Bays, EAVES, FAR, GALLERY, HALF_WIDTH, THICK};
use crate::scenes::{
    budget::{grid, number, ratio},
    builder::Builder,
    chance::Chance,
};

/// Bands along the walls between and above the storeys, with a row of small blocks under the upper one.
pub(super) fn cornices(builder: &mut Builder, triangles: u32) {
    builder.part("cornices", Phong::of(srgb(232, 214, 182), 0.0, 1.0));
    let steps = number(triangles, 2 * 3 * 12, [u32::from(triangles >= 15), 4]);
    for (low, high) in [(4.9, 5.15), (8.75, EAVES)] {
        for step in 0..steps {
            let out = 0.24 * ratio(step + 1, steps);
            let [low, high] = [step, step + 1].map(|i| low + (high - low) * ratio(i, steps));
            let inner = HALF_WIDTH - out;
            for [left, right] in [[-HALF_WIDTH - THICK, -inner], [inner, HALF_WIDTH + THICK]] {
                builder.block([left, low, FAR - THICK], [right, high, 0.3]);
            }
            builder.block([-inner, low, FAR - THICK], [inner, high, FAR + out]);
        }
    }
    let blocks = (triangles.saturating_sub(steps * 72) / 12).min(240);
    let around = 2.0 * -FAR + 2.0 * HALF_WIDTH;
    for i in 0..blocks {
        let way = around * (ratio(i, blocks) + 0.5 / ratio(blocks, 1));
        let at = match way + FAR {
            over if over < 0.0 => Frame::at(Vec3::new(-HALF_WIDTH, 8.62, -way)).turned(Vec3::Y, 90.0),
            over if over < 2.0 * HALF_WIDTH => Frame::at(Vec3::new(over - HALF_WIDTH, 8.62, FAR)),
            over => Frame::at(Vec3::new(HALF_WIDTH, 8.62, FAR - 2.0 * HALF_WIDTH + over)).turned(Vec3::Y, -90.0),
        };
        builder.cuboid(&at, Vec3::new(-0.06, 0.0, -0.01), Vec3::new(0.06, 0.13, 0.11));
    }
}

/// Balustrades between the columns of the upper storey.
pub(super) fn balustrades(builder: &mut Builder, bays: Bays, triangles: u32) {
    const FEWEST: u32 = 12;
    const LOW: f32 = 5.15;
    const RAIL: f32 = 5.92;
    const HIGH: f32 = 6.04;
    builder.part("balustrades", Phong::of(srgb(226, 210, 182), 0.0, 1.0));
    let frames = bays.frames();
    let each = triangles / u32::try_from(frames.len()).unwrap_or(1);
    if each < FEWEST {
        return;
    }
    let half = bays.width() / 2.0;
    let middle = -THICK / 2.0;
    let posts = number(each - 12, 30, [0, 11]);
    for frame in &frames {
        let low = if posts == 0 { LOW } else { RAIL };
        builder.cuboid(frame, Vec3::new(-half, low, middle - 0.1), Vec3::new(half, HIGH, middle + 0.1));
        let [sides, steps] = grid((each - 12) / posts.max(1), 0.9, [4, 2]);
        let profile: Vec<Vec2> = (0..=steps)
            .map(|i| ratio(i, steps))
            .map(|t| {
                let belly = float::sin(std::f32::consts::PI * float::pow(t, 0.62));
                Vec2::new(0.036 + 0.05 * belly * belly, LOW + (RAIL - LOW) * t)
            })
            .collect();
        for i in 0..posts {
            let x = half * (2.0 * (ratio(i, posts) + 0.5 / ratio(posts, 1)) - 1.0);
            let foot = frame.point_to_world(Vec3::new(x, 0.0, middle));
            builder.turned(&Frame::at(foot), &profile, sides);
        }
    }
}

/// Slabs of two kinds of stone, laid like a chessboard, with narrow joints.
pub(super) fn paving(builder: &mut Builder, triangles: u32) {
    const SLAB: u32 = 12;
    const BEGIN: f32 = 4.0;
    let [outer, end] = [HALF_WIDTH + GALLERY, FAR - GALLERY];
    builder.part("ground", Phong::of(srgb(150, 128, 104), 0.0, 1.0));
    let deep = -0.012;
    builder.quad([[-outer, BEGIN], [outer, BEGIN], [outer, end], [-outer, end]].map(|[x, z]| [x, deep, z].into()));
    let slabs = triangles / SLAB;
    if slabs < 60 {
        return;
    }
    let [along, across] = grid(2 * slabs, (BEGIN - end) / (2.0 * outer), [2, 2]);
    let [along, across] = [along.min(60), across.min(36)];
    for (shade, (name, color)) in
        [("light slabs", srgb(214, 196, 166)), ("dark slabs", srgb(166, 122, 96))].into_iter().enumerate()
    {
        builder.part(name, Phong::of(color, 0.1, 40.0));
        for i in 0..along {
            let [near, far] = [i, i + 1].map(|i| BEGIN + (end - BEGIN) * ratio(i, along));
            for k in 0..across {
                let mut chance = Chance::of("slabs", i * across + k);
                let [left, right] = [k, k + 1].map(|k| outer * (2.0 * ratio(k, across) - 1.0));
                // Not all lie quite level.
                let y = chance.around(0.004);
                if (i + k) % 2 == u32::try_from(shade).unwrap_or(0) {
                    builder.block([left + 0.006, -0.05, far + 0.006], [right - 0.006, y, near - 0.006]);
                }
            }
        }
    }
}
