//! A fountain for courts and squares.

use common::{Vec2, Vec3, color::srgb};
use ray_casting::{frame::Frame, material::Phong};

use super::{budget::number, builder::Builder, spline::finer};

/// A fountain: a basin, a pillar with a bowl, and water in both.
pub fn fountain(builder: &mut Builder, place: Vec3, triangles: u32) {
    const FEWEST: u32 = 60;
    if triangles < FEWEST {
        return;
    }
    let place = Frame::at(place);
    builder.part("fountain", Phong::of(srgb(224, 212, 194), 0.15, 30.0));
    let basin = [
        [1.75, 0.0],
        [1.75, 0.12],
        [1.75, 0.12],
        [1.5, 0.16],
        [1.46, 0.3],
        [1.52, 0.5],
        [1.62, 0.56],
        [1.62, 0.56],
        [1.62, 0.64],
        [1.62, 0.64],
        [1.36, 0.64],
        [1.36, 0.64],
        [1.36, 0.3],
    ];
    let pillar = [
        [0.42, 0.3],
        [0.36, 0.62],
        [0.2, 0.72],
        [0.15, 0.95],
        [0.22, 1.12],
        [0.13, 1.24],
        [0.16, 1.38],
        [0.5, 1.5],
        [0.74, 1.68],
        [0.78, 1.72],
        [0.74, 1.74],
        [0.6, 1.66],
        [0.12, 1.62],
        [0.1, 1.8],
        [0.17, 1.95],
        [0.1, 2.08],
        [0.05, 2.1],
        [0.06, 2.2],
        [0.0, 2.26],
    ];
    let refinement = number(triangles, 2_000, [1, 8]);
    let lines = [basin.map(Vec2::from).to_vec(), finer(&pillar.map(Vec2::from), refinement)];
    let rows: usize = lines.iter().map(Vec::len).sum();
    let sides = number(triangles, 2 * u32::try_from(rows).unwrap_or(1), [3, 2_000]);
    if sides < 6 {
        builder.turned(&place, &[[1.6, 0.0], [1.6, 0.6], [0.0, 0.6]].map(Vec2::from), 6);
        return;
    }
    for line in &lines {
        builder.turned(&place, line, sides);
    }
    builder.part("water", Phong::of(srgb(64, 128, 140), 0.9, 120.0));
    builder.turned(&place, &[[1.36, 0.54], [0.0, 0.54]].map(Vec2::from), sides);
    builder.turned(&place, &[[0.66, 1.69], [0.0, 1.69]].map(Vec2::from), sides);
}
