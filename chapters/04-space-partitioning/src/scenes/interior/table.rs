//! The long table with its chairs, and what lies and stands on it.

use common::{Vec2, Vec3, color::srgb, float};
use ray_casting::{frame::Frame, material::Phong};

use super::{brass, wood};
use crate::scenes::{
    budget::{grid, number, ratio, share},
    builder::Builder,
    chance::Chance,
    furniture::{LEAST_CHAIR, chair_shares},
};

/// Height of the table's top.
const TABLE: f32 = 0.76;
/// Half the table's width.
const TABLE_HALF: f32 = 0.72;
/// z of its ends.
const TABLE_ENDS: [f32; 2] = [-3.0, -9.8];

/// The table: a top with round edges, a frame and turned legs.
pub(super) fn table(builder: &mut Builder, triangles: u32) {
    builder.part("table", wood(srgb(128, 76, 42)));
    let [near, far] = TABLE_ENDS;
    let here = Frame::at(Vec3::ZERO);
    let (middle, half) =
        (Vec3::new(0.0, TABLE - 0.03, (near + far) / 2.0), Vec3::new(TABLE_HALF, 0.03, (near - far) / 2.0));
    let top = grid(share(triangles, 0.3), 1.0, [4, 3]);
    if top[1] < 16 {
        builder.cuboid(&here, middle - half, middle + half);
    } else {
        builder.cushion(&here, middle, half, top, 40.0);
    }
    if triangles >= 40 {
        builder.block([-0.58, TABLE - 0.15, far + 0.25], [0.58, TABLE - 0.061, near - 0.25]);
    }
    let rows = number(triangles, 80, [2, 4]);
    for i in 0..rows {
        let z = near - 0.35 + (far - near + 0.7) * ratio(i, rows - 1);
        for x in [-0.5, 0.5] {
            builder.table_leg(&Frame::at(Vec3::new(x, 0.0, z)), TABLE - 0.06, 0.06, share(triangles, 0.6) / (2 * rows));
        }
    }
}

/// Open books, piles of books, bowls, and reading lamps with green shades.
pub(super) fn on_the_table(builder: &mut Builder, triangles: u32) {
    const FEWEST: u32 = 40;
    let places = number(triangles, FEWEST, [0, 14]);
    let place = |i: u32, x: f32| {
        let mut chance = Chance::of("things on the table", i);
        let [near, far] = TABLE_ENDS;
        let z = near - 0.55 + (far - near + 1.0) * ratio(i / 2, places.div_ceil(2));
        let side = if i.is_multiple_of(2) { 1.0 } else { -1.0 };
        let frame = Frame::at(Vec3::new(side * x, TABLE + 0.001, z + chance.around(0.12)));
        (frame.turned(Vec3::Y, side * 90.0 + chance.around(16.0)), chance)
    };
    let each = triangles / places.max(1);
    builder.part("open books", Phong::of(srgb(236, 226, 204), 0.0, 1.0));
    for i in 0..places {
        builder.open_book(&place(i, 0.42).0, number(share(each, 0.15), 4, [2, 400]));
    }
    // Piles lie beside every third open book.
    let piles =
        [("red covers", srgb(134, 40, 38)), ("green covers", srgb(50, 88, 70)), ("ochre covers", srgb(190, 140, 60))];
    for (level, (name, color)) in piles.into_iter().enumerate().take(if each < 2 * FEWEST { 0 } else { 3 }) {
        builder.part(name, Phong::of(color, 0.1, 20.0));
        for i in (0..places).step_by(3) {
            let (frame, mut chance) = place(i, 0.12);
            let height = 0.045 * ratio(u32::try_from(level).unwrap_or(0), 1);
            let at = frame.point_to_world(Vec3::new(0.1, height, 0.0));
            let frame = Frame::at(at).turned(Vec3::Y, 60.0 + chance.around(60.0) + height * 900.0);
            builder.cuboid(&frame, Vec3::new(-0.1, 0.0, -0.14), Vec3::new(0.1, 0.043, 0.14));
        }
    }
    let sides = number(share(each, 0.25), 14, [3, 500]);
    builder.part("bowls", Phong::of(srgb(60, 110, 130), 0.6, 80.0));
    for i in (1..places).step_by(4) {
        builder.cup(&place(i, 0.1).0, 0.13, 0.09, sides);
    }
    reading_lamps(builder, share(triangles, 0.4));
}

/// Reading lamps along the middle of the table.
fn reading_lamps(builder: &mut Builder, triangles: u32) {
    const FEWEST: u32 = 60;
    let lamps = number(triangles, FEWEST, [0, 3]);
    let each = triangles / lamps.max(1);
    let feet: Vec<Vec3> = (0..lamps).map(|i| Vec3::new(0.0, TABLE, -4.9 - 2.1 * ratio(i, 1))).collect();
    builder.part("stands of reading lamps", brass());
    let sides = number(share(each, 0.4), 12, [4, 600]);
    for &foot in &feet {
        let profile = [[0.1, 0.0], [0.1, 0.015], [0.02, 0.04], [0.012, 0.1], [0.018, 0.2], [0.01, 0.22], [0.01, 0.4]];
        builder.turned(&Frame::at(foot), &profile.map(Vec2::from), sides);
    }
    builder.part("green shades", Phong::of(srgb(22, 112, 74), 0.8, 60.0));
    let [around, along] = grid(share(each, 0.45), 2.0, [4, 1]);
    for &foot in &feet {
        // Half a pipe, its opening below.
        builder.surface(along, around, |u, v| {
            let angle = std::f32::consts::PI * v;
            let (x, y) = (0.085 * float::cos(angle), 0.38 + 0.075 * float::sin(angle));
            foot + Vec3::new(x, y, 0.17 * (1.0 - 2.0 * u))
        });
    }
}

/// Chairs at both sides of the table.
pub(super) fn chairs(builder: &mut Builder, triangles: u32) {
    let pairs = number(triangles, 2 * LEAST_CHAIR, [1, 7]);
    let seats = if triangles < LEAST_CHAIR { 1 } else { 2 * pairs };
    let [near, far] = TABLE_ENDS;
    let mut frames = vec![];
    for i in 0..pairs {
        let z = near + (far - near) * (ratio(i, pairs) + 0.5 / ratio(pairs, 1));
        for side in [-1.0, 1.0] {
            let mut chance = Chance::of("chairs", 2 * i + u32::from(side > 0.0));
            // Somebody pushed some of them back.
            let x = side * (TABLE_HALF + 0.12 + chance.between(0.0, 1.0) * chance.between(0.0, 0.55));
            frames.push(Frame::at(Vec3::new(x, 0.0, z)).turned(Vec3::Y, -side * 90.0 + chance.around(14.0)));
        }
    }
    frames.truncate(usize::try_from(seats).unwrap_or(usize::MAX));
    let [wooden, padded] = chair_shares(triangles / seats);
    builder.part("chairs", wood(srgb(112, 66, 38)));
    for frame in &frames {
        builder.chair_wood(frame, wooden);
    }
    builder.part("cushions", Phong::of(srgb(52, 98, 82), 0.18, 12.0));
    for frame in &frames {
        builder.chair_cushions(frame, padded);
    }
}
