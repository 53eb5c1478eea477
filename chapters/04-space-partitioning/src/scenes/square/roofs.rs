//! Roofs of half-round tiles, each tile made.

use common::{Vec3, color::srgb, float};
use ray_casting::material::Phong;

use super::houses::{DEPTH, House};
use crate::scenes::{
    budget::{grid, number, ratio},
    builder::Builder,
    chance::Chance,
};

/// How far the roof reaches over the front and the back.
const OVERHANG: f32 = 0.45;
/// Width and length of the smallest tiles.
const TILE: [f32; 2] = [0.21, 0.38];

/// One side of a roof.
struct Slope {
    /// The left end of the eaves, seen from outside.
    corner: Vec3,
    /// Along the eaves to their right end.
    across: Vec3,
    /// From the eaves to the ridge.
    up: Vec3,
}

impl Slope {
    fn area(&self) -> f32 {
        self.across.length() * self.up.length()
    }
}

/// The two slopes of a house.
fn slopes(house: &House) -> [Slope; 2] {
    let half = house.width / 2.0;
    // The slope goes on below the eaves.
    let below = house.eaves() - house.rise() * OVERHANG / (DEPTH / 2.0);
    let ridge = Vec3::new(0.0, house.eaves() + house.rise(), -DEPTH / 2.0);
    [(1.0, OVERHANG), (-1.0, -DEPTH - OVERHANG)].map(|(sign, z)| {
        let corner = Vec3::new(-half * sign, below, z);
        let up = Vec3::new(0.0, ridge.y - below, ridge.z - z);
        Slope {
            corner: house.frame.point_to_world(corner + Vec3::Y * 0.06),
            across: house.frame.vector_to_world(Vec3::X * (house.width * sign)),
            up: house.frame.vector_to_world(up),
        }
    })
}

/// All roofs: boards with tiles on them.
pub(super) fn roofs(builder: &mut Builder, houses: &[House], triangles: u32) {
    const FEWEST: u32 = 6;
    let slopes: Vec<Slope> = houses.iter().flat_map(slopes).collect();
    let area: f32 = slopes.iter().map(Slope::area).sum();
    builder.part("roofs", Phong::of(srgb(168, 88, 60), 0.0, 1.0));
    for Slope { corner, across, up } in &slopes {
        builder.quad([*corner, *corner + *across, *corner + *across + *up, *corner + *up]);
    }
    // As many tiles as the budget pays for, but none smaller than tiles are.
    let tiles = number(triangles, FEWEST, [0, number_of_smallest(area)]);
    if tiles < 150 {
        return;
    }
    let scale = (area / ratio(tiles, 1) / (TILE[0] * TILE[1])).sqrt().max(1.0);
    let steps = grid((triangles / tiles).min(80), 2.5, [3, 1]);
    let shades = [("tiles", srgb(190, 100, 66)), ("dark tiles", srgb(164, 82, 58)), ("pale tiles", srgb(206, 132, 92))];
    for (shade, (name, color)) in shades.into_iter().enumerate() {
        builder.part(name, Phong::of(color, 0.0, 1.0));
        for (slope, i) in slopes.iter().zip(0..) {
            tile(builder, slope, scale, steps, (shade, shades.len()), &mut Chance::of("tiles", i));
        }
    }
}

/// How many of the smallest tiles cover an area.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few thousand")]
fn number_of_smallest(area: f32) -> u32 {
    (area / (TILE[0] * TILE[1])) as u32
}

/// Those tiles of a slope that have one of the shades.
fn tile(builder: &mut Builder, slope: &Slope, scale: f32, steps: [u32; 2], shade: (usize, usize), chance: &mut Chance) {
    let count = |length: f32, tile: f32| (1..400).find(|&n| length / ratio(n, 1) <= tile * scale).unwrap_or(400);
    let columns = count(slope.across.length(), TILE[0]);
    let rows = count(slope.up.length(), TILE[1]);
    let [across, up] = [slope.across / ratio(columns, 1), slope.up / ratio(rows, 1)];
    let out = across.cross(up).normalize_or(Vec3::Y);
    let radius = across.length() * 0.5;
    for row in 0..rows {
        for column in 0..columns {
            let mine = chance.index(shade.1) == shade.0;
            let shift = across * chance.around(0.05) + out * chance.between(0.0, 0.15) * radius;
            if !mine {
                continue;
            }
            let corner = slope.corner + across * ratio(column, 1) + up * ratio(row, 1) + shift;
            builder.surface(steps[0], steps[1], |u, v| {
                let (cos, sin) = half_turn(u);
                // Wider and lifted at its lower end, which lies on the tile below.
                let wide = 0.5 - 0.5 * cos * (1.0 - 0.12 * v);
                corner + across * wide + up * (1.12 * v) + out * (radius * (0.75 * sin + 0.3 * (1.0 - v)))
            });
        }
    }
}

/// Cosine and sine of a share of half a turn.
fn half_turn(u: f32) -> (f32, f32) {
    let angle = std::f32::consts::PI * u;
    (float::cos(angle), float::sin(angle))
}
