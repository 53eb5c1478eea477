//! What is made of steel bars: girders, gratings, railings and stairs.

use common::Vec3;

use super::super::{builder::Builder, cuboid};

/// Height of a handrail above the floor, in meters, and the thickness of its bars.
const HANDRAIL: f32 = 1.1;
const BAR: f32 = 0.06;

/// A beam of about so many triangles, at most: two chords with diagonals between if that is enough, otherwise a box.
pub(super) fn girder(builder: &mut Builder, from: Vec3, to: Vec3, thickness: f32, triangles: u32) {
    let panels = (triangles / cuboid::COST).saturating_sub(2).min(40);
    if panels < 4 {
        return builder.beam(from, to, thickness);
    }
    let down = Vec3::Y * (-2.2 * thickness);
    let bar = thickness * 0.3;
    builder.beam(from, to, bar * 1.3);
    builder.beam(from + down, to + down, bar * 1.3);
    for panel in 0..panels {
        let at = |i: u32| from.lerp(to, i as f32 / panels as f32) + if i.is_multiple_of(2) { Vec3::ZERO } else { down };
        builder.beam(at(panel), at(panel + 1), bar * 0.7);
    }
}

/// A column of at most so many triangles: of H section if that is enough, otherwise a box.
pub(super) fn column(builder: &mut Builder, from: Vec3, to: Vec3, thickness: f32, triangles: u32) {
    if triangles < 3 * cuboid::COST {
        return builder.beam(from, to, thickness);
    }
    let (half, thin) = (thickness / 2.0, thickness / 12.0);
    let mut part = |low: Vec3, high: Vec3| plate(builder, from + low, to + high);
    part(Vec3::new(-half, 0.0, -half), Vec3::new(half, 0.0, thin - half));
    part(Vec3::new(-half, 0.0, half - thin), Vec3::new(half, 0.0, half));
    part(Vec3::new(-thin / 2.0, 0.0, thin - half), Vec3::new(thin / 2.0, 0.0, half - thin));
}

/// A solid plate along the axes, however thick, from its least to its greatest coordinates.
pub(super) fn plate(builder: &mut Builder, low: Vec3, high: Vec3) {
    let half = (high - low) / 2.0;
    builder.cuboid_around(low + half, [Vec3::X * half.x, Vec3::Y * half.y, Vec3::Z * half.z]);
}

/// A floor of at most so many triangles, or a plate: bars along x, and one in eight across.
pub(super) fn grating(builder: &mut Builder, low: Vec3, high: Vec3, triangles: u32) {
    /// Least distance between bars, in meters.
    const PITCH: f32 = 0.05;
    let bars = (triangles / cuboid::COST).min(((high.z - low.z) / PITCH) as u32);
    if bars < 8 {
        return plate(builder, low, high);
    }
    let across = bars / 8;
    let mut rows = |count: u32, size: f32, place: &dyn Fn(f32) -> (Vec3, Vec3)| {
        for i in 0..count {
            let (from, to) = place(size * (i as f32 + 0.25) / count as f32);
            plate(builder, from, to);
        }
    };
    let size = high - low;
    let (wide_x, wide_z) = (0.4 * size.x / across as f32, 0.4 * size.z / (bars - across) as f32);
    let (wide_x, middle) = (wide_x.min(0.1), low.y + 0.6 * size.y);
    rows(bars - across, size.z, &|at| {
        (Vec3::new(low.x, low.y, low.z + at), Vec3::new(high.x, high.y, low.z + at + wide_z))
    });
    rows(across, size.x, &|at| (Vec3::new(low.x + at, middle, low.z), Vec3::new(low.x + at + wide_x, high.y, high.z)));
}

/// A railing of at most so many triangles: handrail, rail at the knee, posts. With fewer than two bars there is none.
pub(super) fn railing(builder: &mut Builder, from: Vec3, to: Vec3, triangles: u32) {
    /// Least distance between posts, in meters.
    const PITCH: f32 = 0.14;
    let bars = triangles / cuboid::COST;
    if bars < 2 {
        return;
    }
    let rails = if bars < 5 { 1 } else { 2 };
    let posts = (bars - rails).min(((to - from).length() / PITCH) as u32);
    for rail in 0..rails {
        let up = Vec3::Y * (HANDRAIL * (1.0 - 0.5 * rail as f32));
        builder.beam(from + up, to + up, BAR);
    }
    for post in 0..posts {
        let foot = from.lerp(to, (post as f32 + 0.5) / posts as f32);
        let thickness = if posts > 12 && post % 8 != 0 { 0.35 * BAR } else { BAR };
        builder.beam(foot, foot + Vec3::Y * HANDRAIL, thickness);
    }
}

/// A flight of stairs of at most so many triangles, `width` wide toward `aside`.
pub(super) fn flight(builder: &mut Builder, from: Vec3, to: Vec3, aside: Vec3, triangles: u32) {
    /// Least height of a step, in meters.
    const RISE: f32 = 0.17;
    let bars = triangles / cuboid::COST;
    // Two strings, and the steps between.
    let width = aside.length();
    for edge in [Vec3::ZERO, aside] {
        builder.beam(from + edge, to + edge, 0.16);
    }
    let steps = bars.saturating_sub(2).min(((to - from).y.abs() / RISE) as u32);
    for step in 0..steps {
        let place = from.lerp(to, (step as f32 + 0.5) / steps as f32) + aside / 2.0;
        let along = Vec3::Y.cross(aside).normalize_or(Vec3::X);
        builder.cuboid_around(place, [aside.normalize_or(Vec3::Z) * (width / 2.0), Vec3::Y * 0.03, -along * 0.14]);
    }
    if bars > 40 {
        for edge in [Vec3::ZERO, aside] {
            railing(builder, from + edge, to + edge, triangles / 6);
        }
    }
}
