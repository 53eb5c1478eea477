//! The fronts of the houses: walls with windows and doors, their glass, bars, sills and shutters.

use common::{Vec3, color::srgb};
use ray_casting::{frame::Frame, material::Phong};

use super::houses::House;
use crate::scenes::{
    budget::{number, ratio},
    builder::Builder,
};

/// From the wall's face to the glass.
const REVEAL: f32 = 0.2;

/// An opening in a front: a window or a door.
struct Opening {
    /// The least and the greatest x and y.
    low: [f32; 2],
    high: [f32; 2],
    is_door: bool,
}

/// The opening in a column of a floor.
fn opening(house: &House, column: u32, floor: u32) -> Opening {
    let (x, y) = (house.column(column), house.floor(floor));
    if floor == 0 && column == house.door {
        Opening { low: [x - 0.56, 0.14], high: [x + 0.56, 2.4], is_door: true }
    } else {
        Opening { low: [x - 0.46, y + 0.85], high: [x + 0.46, y + 2.25], is_door: false }
    }
}

/// All openings of a house.
fn openings(house: &House) -> impl Iterator<Item = Opening> + '_ {
    (0..house.floors).flat_map(move |floor| (0..house.columns).map(move |column| opening(house, column, floor)))
}

/// Fronts with windows and doors. With few triangles windows are painted on.
pub(super) fn windows(builder: &mut Builder, houses: &[House], triangles: u32) {
    const FEWEST: u32 = 64;
    let count: usize = houses.iter().map(|house| openings(house).count()).sum();
    let each = triangles / u32::try_from(count).unwrap_or(1).max(1);
    if each < FEWEST {
        return painted(builder, houses);
    }
    for house in houses {
        builder.part("fronts", house.plaster());
        front(builder, house);
    }
    builder.part("glass", Phong::of(srgb(56, 70, 82), 0.9, 80.0));
    for house in houses {
        for opening in openings(house).filter(|opening| !opening.is_door) {
            panel(builder, &house.frame, &opening, -REVEAL);
        }
    }
    builder.part("window bars", Phong::of(srgb(236, 230, 216), 0.0, 1.0));
    for house in houses {
        for Opening { low, high, .. } in openings(house).filter(|opening| !opening.is_door) {
            if each >= 2 * FEWEST {
                let glass = Frame::at(house.frame.point_to_world(Vec3::new(0.0, 0.0, -REVEAL + 0.02)));
                let glass = glass.turned(Vec3::Y, turn(&house.frame));
                builder.muntins(&glass, [low[0] + 0.02, high[0] - 0.02], [low[1] + 0.02, high[1] - 0.02], [2, 3]);
            }
            let (left, right) = (low[0] - 0.1, high[0] + 0.1);
            builder.cuboid(&house.frame, Vec3::new(left, low[1] - 0.07, -REVEAL), Vec3::new(right, low[1], 0.1));
        }
    }
    doors(builder, houses, each);
    shutters(builder, houses, number(each.saturating_sub(FEWEST), 24, [0, 24]));
}

/// Windows, doors and shutters as mere rectangles before the walls.
fn painted(builder: &mut Builder, houses: &[House]) {
    for house in houses {
        builder.part("fronts", house.plaster());
        let half = house.width / 2.0;
        let corners = [[-half, 0.0], [half, 0.0], [half, house.eaves()], [-half, house.eaves()]];
        builder.quad(corners.map(|[x, y]| house.frame.point_to_world(Vec3::new(x, y, 0.0))));
    }
    builder.part("glass", Phong::of(srgb(56, 70, 82), 0.9, 80.0));
    // With so few triangles that houses are left out, only the first house has any.
    for house in houses.iter().take(if houses.len() < 10 { 1 } else { houses.len() }) {
        for opening in openings(house) {
            panel(builder, &house.frame, &opening, 0.01);
        }
    }
}

/// How far a house's frame is turned about the vertical, in degrees.
fn turn(frame: &Frame) -> f32 {
    match frame.vector_to_world(Vec3::Z).x {
        x if x > 0.5 => 90.0,
        x if x < -0.5 => -90.0,
        _ => 0.0,
    }
}

/// A rectangle in an opening.
fn panel(builder: &mut Builder, frame: &Frame, Opening { low, high, .. }: &Opening, z: f32) {
    let corners = [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]];
    builder.quad(corners.map(|[x, y]| frame.point_to_world(Vec3::new(x, y, z))));
}

/// The wall around all openings of a front, and their sides.
fn front(builder: &mut Builder, house: &House) {
    let at = |x: f32, y: f32, z: f32| house.frame.point_to_world(Vec3::new(x, y, z));
    for floor in 0..house.floors {
        for column in 0..house.columns {
            let half = house.width / ratio(house.columns, 1) / 2.0;
            let middle = house.column(column);
            let ([left, right], [low, high]) =
                ([middle - half, middle + half], [house.floor(floor), house.floor(floor + 1)]);
            let Opening { low: [l, b], high: [r, t], .. } = opening(house, column, floor);
            for [x0, y0, x1, y1] in [[left, low, right, b], [left, t, right, high], [left, b, l, t], [r, b, right, t]] {
                builder.quad([at(x0, y0, 0.0), at(x1, y0, 0.0), at(x1, y1, 0.0), at(x0, y1, 0.0)]);
            }
            let d = -REVEAL;
            builder.quad([at(l, b, 0.0), at(r, b, 0.0), at(r, b, d), at(l, b, d)]);
            builder.quad([at(l, t, d), at(r, t, d), at(r, t, 0.0), at(l, t, 0.0)]);
            builder.quad([at(l, b, 0.0), at(l, b, d), at(l, t, d), at(l, t, 0.0)]);
            builder.quad([at(r, b, d), at(r, b, 0.0), at(r, t, 0.0), at(r, t, d)]);
        }
    }
}

/// Doors of planks, with stone around them.
fn doors(builder: &mut Builder, houses: &[House], each: u32) {
    builder.part("doors", Phong::of(srgb(104, 70, 48), 0.1, 20.0));
    let planks = number(each, 24, [1, 7]);
    for house in houses {
        for Opening { low, high, .. } in openings(house).filter(|opening| opening.is_door) {
            let width = (high[0] - low[0]) / ratio(planks, 1);
            for i in 0..planks {
                let x = low[0] + width * ratio(i, 1);
                let (near, far) = (Vec3::new(x + width - 0.006, high[1], -0.12), Vec3::new(x + 0.006, low[1], -REVEAL));
                builder.cuboid(&house.frame, far, near);
            }
        }
    }
    builder.part("stone around the doors", Phong::of(srgb(220, 204, 176), 0.0, 1.0));
    for house in houses {
        for Opening { low, high, .. } in openings(house).filter(|opening| opening.is_door) {
            let [outer_left, outer_right] = [low[0] - 0.2, high[0] + 0.2];
            let lintel = high[1] + 0.24;
            for [x0, y0, x1, y1] in [
                [outer_left, 0.0, low[0], high[1]],
                [high[0], 0.0, outer_right, high[1]],
                [outer_left - 0.06, high[1], outer_right + 0.06, lintel],
            ] {
                builder.cuboid(&house.frame, Vec3::new(x0, y0, -0.05), Vec3::new(x1, y1, 0.07));
            }
        }
    }
}

/// Open shutters beside the windows, with so many slats each.
fn shutters(builder: &mut Builder, houses: &[House], slats: u32) {
    let colors = [
        ("green shutters", srgb(74, 112, 92)),
        ("blue shutters", srgb(82, 122, 150)),
        ("brown shutters", srgb(132, 86, 60)),
    ];
    for (index, (name, color)) in colors.into_iter().enumerate() {
        builder.part(name, Phong::of(color, 0.1, 20.0));
        for house in houses.iter().filter(|house| house.shutters == index) {
            for Opening { low, high, .. } in openings(house).filter(|opening| !opening.is_door) {
                for (left, right) in [(low[0] - 0.5, low[0] - 0.02), (high[0] + 0.02, high[0] + 0.5)] {
                    shutter(builder, &house.frame, [left, low[1]], [right, high[1]], slats);
                }
            }
        }
    }
}

/// One shutter: a frame with slanting slats, or a mere board.
fn shutter(builder: &mut Builder, frame: &Frame, low: [f32; 2], high: [f32; 2], slats: u32) {
    const FRAME: f32 = 0.055;
    const THICK: f32 = 0.05;
    if slats < 4 {
        builder.cuboid(frame, Vec3::new(low[0], low[1], 0.01), Vec3::new(high[0], high[1], THICK));
        return;
    }
    let [inner_low, inner_high] = [low.map(|c| c + FRAME), high.map(|c| c - FRAME)];
    for [x0, y0, x1, y1] in [
        [low[0], low[1], inner_low[0], high[1]],
        [inner_high[0], low[1], high[0], high[1]],
        [inner_low[0], low[1], inner_high[0], inner_low[1]],
        [inner_low[0], inner_high[1], inner_high[0], high[1]],
    ] {
        builder.cuboid(frame, Vec3::new(x0, y0, 0.01), Vec3::new(x1, y1, THICK));
    }
    let step = (inner_high[1] - inner_low[1]) / ratio(slats, 1);
    let tilt = turn(frame);
    for i in 0..slats {
        let y = inner_low[1] + step * (ratio(i, 1) + 0.5);
        let middle = frame.point_to_world(Vec3::new((inner_low[0] + inner_high[0]) / 2.0, y, THICK / 2.0));
        let slat = Frame::at(middle).turned(Vec3::X, 35.0).turned(Vec3::Y, tilt);
        let half = Vec3::new((inner_high[0] - inner_low[0]) / 2.0, 0.005, step * 0.6);
        builder.cuboid(&slat, -half, half);
    }
}
