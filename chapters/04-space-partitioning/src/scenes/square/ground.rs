//! The ground: paving stones, each a little different, and hills far behind the houses.

use common::{Vec3, color::srgb, float};
use ray_casting::material::Phong;

use super::{FAR, NEAR, SIDES};
use crate::scenes::{
    budget::{grid, number, ratio},
    builder::Builder,
    chance::Chance,
};

/// Width and length of the smallest stones.
const STONE: f32 = 0.19;
/// How far stones stand above the ground between them.
const HIGH: f32 = 0.025;

/// Stones in rows, each row shifted, and sand between them.
pub(super) fn paving(builder: &mut Builder, triangles: u32) {
    const FEWEST: u32 = 18;
    let [left, right] = SIDES;
    builder.part("sand", Phong::of(srgb(150, 130, 104), 0.0, 1.0));
    // Sand reaches under the houses and into the alley.
    let (wide, far) = (12.0, FAR - 40.0);
    builder.quad(
        [[left - wide, NEAR + wide], [right + wide, NEAR + wide], [right + wide, far], [left - wide, far]]
            .map(|[x, z]| Vec3::new(x, 0.0, z)),
    );
    let [width, length] = [right - left, NEAR - FAR];
    let most = [width, length].map(|side| (1..2_000).find(|&n| side / ratio(n, 1) < STONE).unwrap_or(2_000));
    let stones = number(triangles, FEWEST, [0, most[0] * most[1]]);
    if stones < 60 {
        return;
    }
    let [columns, rows] = grid(2 * stones, width / length, [4, 4]);
    let [side, _] = grid((triangles / stones).min(200), 1.0, [3, 3]);
    let shades = [
        ("warm stones", srgb(186, 162, 132)),
        ("grey stones", srgb(164, 152, 138)),
        ("pale stones", srgb(200, 184, 156)),
    ];
    for (shade, (name, color)) in shades.into_iter().enumerate() {
        builder.part(name, Phong::of(color, 0.06, 20.0));
        for row in 0..rows {
            let mut chance = Chance::of("paving stones", row);
            let [near, far] = [row, row + 1].map(|row| NEAR - length * ratio(row, rows));
            let size = width / ratio(columns, 1);
            let shift = size * chance.between(0.0, 1.0);
            for column in 0..columns {
                let from = left + size * ratio(column, 1) + shift - size * 0.5;
                let mine = chance.index(shades.len()) == shade;
                let lift = chance.between(0.6, 1.2) * HIGH;
                let gap = size * chance.between(0.015, 0.035);
                if mine {
                    stone(builder, [from + gap, from + size - gap], [far + gap, near - gap], lift, side);
                }
            }
        }
    }
}

/// One stone with round edges.
fn stone(builder: &mut Builder, [left, right]: [f32; 2], [far, near]: [f32; 2], high: f32, side: u32) {
    // Steps lie closely near the edges: from −1 to 1, eighth roots of equal steps.
    let spread = |t: f32| {
        let s = 2.0 * t - 1.0;
        (s.abs().sqrt().sqrt().sqrt().copysign(s), 1.0 - s * s * s * s)
    };
    builder.surface(side, side, |u, v| {
        let ((x, across), (z, along)) = (spread(u), spread(v));
        let at = [left + (right - left) * (0.5 + 0.5 * x), near + (far - near) * (0.5 + 0.5 * z)];
        Vec3::new(at[0], high * (across * along).sqrt() * 1.6 - 0.6 * high, at[1])
    });
}

/// Wooded hills on the horizon.
pub(super) fn hills(builder: &mut Builder, triangles: u32) {
    const FEWEST: u32 = 24;
    if triangles < FEWEST {
        return;
    }
    let [columns, rows] = grid(triangles.min(60_000), 3.0, [8, 1]);
    for (name, color, z, height, phase) in
        [("far hills", srgb(122, 150, 172), -150.0, 62.0, 1.2), ("hills", srgb(104, 136, 112), -95.0, 30.0, 3.4)]
    {
        builder.part(name, Phong::of(color, 0.0, 1.0));
        builder.surface(columns / 2, rows, |u, v| {
            let x = 220.0 * (u - 0.5);
            let ridge = 0.62 + 0.25 * float::sin(0.035 * x + phase) + 0.12 * float::sin(0.09 * x + 2.0 * phase);
            let bumps = 0.5 * float::sin(0.9 * x + 7.0 * v) * float::sin(0.53 * x + 19.0 * v);
            Vec3::new(x, (height * ridge + bumps) * float::sin(1.57 * v) - 1.0, z - 40.0 * v)
        });
    }
}
