//! The stands: rows of seats all around, a roof over them, and the masts of the floodlights.

use common::{Vec2, Vec3, color::srgb, float};
use ray_casting::material::Phong;

use super::super::{budget::share, builder::Builder, cuboid};

/// Half the inner length and width of the ring of stands, in meters.
const INNER: Vec2 = Vec2::new(66.0, 46.0);
/// How far the stands reach outward, and how high.
const DEPTH: f32 = 24.0;
const HEIGHT: f32 = 11.0;
/// Height of the first row.
const FIRST: f32 = 1.4;
/// Height of the roof at its outer and its inner edge, and its reach inward.
const ROOF: (f32, f32, f32) = (15.0, 16.0, 13.0);
/// How round the ring is: 2 is an ellipse, and more is nearer to a rectangle.
const ROUNDNESS: f32 = 3.4;
/// Blocks of seats of one color, from the field to the top.
const BLOCKS: u32 = 4;
/// Every so many segments have an aisle.
const AISLE: u32 = 8;

/// The stands, with about so many triangles.
pub(super) fn stands(builder: &mut Builder, triangles: u32) {
    // Each segment of a row has a step and a riser; the roof and the walls are like four rows.
    let rows = ((triangles as f32 / 16.0).sqrt() as u32).clamp(2, 22);
    let segments = (triangles / (4 * (rows + 2))).max(6);
    let step = Vec2::new(DEPTH, HEIGHT - FIRST) / rows as f32;

    // The risers: seats of two colors, and aisles between.
    let height = |row: u32| FIRST + step.y * row as f32;
    let riser = |builder: &mut Builder, row: u32, segment: u32, below: f32| {
        let out = step.x * row as f32;
        band(builder, segment, segments, (out, below), (out, height(row)));
    };
    let is_aisle = |segment: u32| segments > 3 * AISLE && segment.is_multiple_of(AISLE);
    // A small stadium has two blocks around.
    let block = AISLE.min(segments / 2);
    let is_pale = |row: u32, segment: u32| (row * BLOCKS / rows + segment / block) % 2 == 1;
    for (name, color, pale) in [("blue seats", srgb(38, 78, 148), false), ("pale seats", srgb(206, 208, 206), true)] {
        builder.part(name, Phong::of(color, 0.1, 20.0));
        for row in 1..rows {
            for segment in (0..segments).filter(|&segment| is_pale(row, segment) == pale && !is_aisle(segment)) {
                riser(builder, row, segment, height(row - 1));
            }
        }
    }

    builder.part("concrete", Phong::of(srgb(168, 164, 158), 0.0, 1.0));
    for segment in 0..segments {
        for row in 0..rows {
            let out = step.x * row as f32;
            band(builder, segment, segments, (out, height(row)), (out + step.x, height(row)));
            if row == 0 || is_aisle(segment) {
                riser(builder, row, segment, if row == 0 { 0.0 } else { height(row - 1) });
            }
        }
        // The wall outside, seen from both sides.
        band(builder, segment, segments, (DEPTH, height(rows - 1)), (DEPTH, ROOF.0));
        band(builder, segment, segments, (DEPTH + 0.3, ROOF.0), (DEPTH + 0.3, 0.0));
    }

    if triangles > 150 {
        roof(builder, segments, share(triangles, 0.1) / cuboid::COST);
    }
}

/// A roof over the upper rows, on so many columns.
fn roof(builder: &mut Builder, segments: u32, columns: u32) {
    builder.part("roof", Phong::of(srgb(210, 214, 220), 0.1, 20.0));
    let (edge, wall) = (DEPTH - ROOF.2, DEPTH + 0.3);
    for segment in 0..segments {
        band(builder, segment, segments, (edge, ROOF.1), (wall, ROOF.0));
        band(builder, segment, segments, (wall, ROOF.0 - 0.4), (edge, ROOF.1 - 0.4));
        band(builder, segment, segments, (edge, ROOF.1 - 0.4), (edge, ROOF.1));
    }
    for column in 0..columns {
        let foot = ring(column as f32 / columns as f32, DEPTH - 1.5);
        builder.beam(Vec3::new(foot.x, HEIGHT - 2.0, foot.y), Vec3::new(foot.x, ROOF.0, foot.y), 0.5);
    }
}

/// Two triangles of the ring, between two (distance outward, height), that face inward and upward.
fn band(builder: &mut Builder, segment: u32, segments: u32, inner: (f32, f32), outer: (f32, f32)) {
    let corner = |segment: u32, (out, height): (f32, f32)| {
        let place = ring(segment as f32 / segments as f32, out);
        Vec3::new(place.x, height, place.y)
    };
    let next = (segment + 1) % segments;
    builder.quad([corner(segment, inner), corner(next, inner), corner(next, outer), corner(segment, outer)]);
}

/// A place of the ring that surrounds the field, `out` meters behind its inner edge. `turn` is from 0 to 1.
fn ring(turn: f32, out: f32) -> Vec2 {
    let angle = std::f32::consts::TAU * turn;
    let (cos, sin) = (float::cos(angle), float::sin(angle));
    let bulge = float::pow(float::pow(cos.abs(), ROUNDNESS) + float::pow(sin.abs(), ROUNDNESS), -1.0 / ROUNDNESS);
    Vec2::new(cos, sin) * bulge * (INNER + Vec2::splat(out))
}

/// A mast with a board of lamps that looks at the field.
pub(super) fn floodlight(builder: &mut Builder, lamps: Vec3, detailed: bool) {
    let top = lamps * Vec3::new(1.03, 1.0, 1.03);
    builder.beam(Vec3::new(top.x, 0.0, top.z), top, 1.1);
    let toward = Vec3::new(-lamps.x, -0.5 * lamps.y, -lamps.z).normalize_or(Vec3::X);
    let aside = toward.cross(Vec3::Y).normalize_or(Vec3::Z);
    let up = aside.cross(toward);
    builder.cuboid_around(top, [aside * 4.6, up * 3.4, -toward * 0.2]);
    if detailed {
        // Rows of round lamps.
        for row in -1..=1 {
            for column in -2..=2 {
                let place = top + aside * (1.7 * column as f32) + up * (2.0 * row as f32) + toward * 0.2;
                let profile = [Vec2::new(0.75, 0.0), Vec2::new(0.75, 0.5), Vec2::new(0.75, 0.5), Vec2::new(0.0, 0.6)];
                builder.turned_around(place, toward, &profile, 8);
            }
        }
    }
}
