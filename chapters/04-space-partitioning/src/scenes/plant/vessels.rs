//! What is round and large: tanks, gas holders, columns, boilers, chimneys and cooling towers.

use common::{Vec2, Vec3, color::srgb, float};
use ray_casting::material::Phong;

use super::{
    super::{
        ball,
        budget::{number, share},
        builder::Builder,
    },
    steel::railing,
};

/// Place on the ground, radius and height, in meters; the first are in any scene.
type Vessel = (f32, f32, f32, f32);
const TANKS: [Vessel; 5] = [
    (-14.0, 34.0, 9.0, 10.0),
    (-37.0, 28.0, 9.0, 12.0),
    (-24.0, 54.0, 8.0, 8.5),
    (-50.0, 50.0, 10.0, 9.0),
    (-62.0, 22.0, 9.0, 12.0),
];
const COLUMNS: [Vessel; 7] = [
    (-19.0, -20.0, 6.0, 43.0),
    (4.0, -20.0, 6.0, 43.0),
    (25.0, -14.0, 2.4, 40.0),
    (33.0, -20.0, 1.7, 30.0),
    (38.0, -10.0, 2.0, 24.0),
    (31.0, -5.0, 1.3, 19.0),
    (45.0, -17.0, 2.6, 34.0),
];
const TOWERS: [Vessel; 3] = [(64.0, -104.0, 25.0, 66.0), (8.0, -122.0, 25.0, 66.0), (-104.0, -84.0, 25.0, 66.0)];
const CHIMNEYS: [Vessel; 3] = [(-46.0, -48.0, 3.4, 78.0), (-38.0, -62.0, 3.4, 78.0), (-64.0, -40.0, 2.8, 66.0)];
/// Place and radius of a gas holder.
const HOLDERS: [(f32, f32, f32); 3] = [(18.0, 36.0, 6.5), (37.0, 29.0, 6.5), (52.0, 12.0, 6.5)];
/// Bands of a chimney, red and white in turn.
const BANDS: u32 = 7;
/// Half sections for radius and height 1: distance from the axis and height. Points twice in sequence are sharp edges.
const TANK: [(f32, f32); 10] = [
    (1.0, 0.0),
    (1.0, 0.93),
    (1.0, 0.93),
    (1.03, 0.94),
    (1.03, 0.97),
    (1.03, 0.97),
    (0.98, 0.98),
    (0.7, 1.08),
    (0.35, 1.14),
    (0.0, 1.16),
];
const COLUMN: [(f32, f32); 12] = [
    (1.12, 0.0),
    (1.0, 0.05),
    (1.0, 0.4),
    (1.0, 0.4),
    (1.1, 0.405),
    (1.1, 0.43),
    (1.0, 0.435),
    (1.0, 0.435),
    (1.0, 0.94),
    (0.86, 0.975),
    (0.5, 0.995),
    (0.0, 1.0),
];
const TOWER: [(f32, f32); 8] =
    [(1.0, 0.0), (0.88, 0.15), (0.77, 0.32), (0.69, 0.5), (0.64, 0.68), (0.635, 0.8), (0.65, 0.92), (0.67, 1.0)];

/// All of them, with about so many triangles.
pub(super) fn vessels(builder: &mut Builder, triangles: u32) {
    // Chimneys, in bands that grow narrower.
    let chimneys = some(&CHIMNEYS, share(triangles, 0.14), 6 * 4);
    let bands = if triangles < 400 { 2 } else { BANDS };
    for (name, color, parity) in [("chimneys, white", srgb(228, 222, 212), 0), ("chimneys, red", srgb(188, 66, 50), 1)]
    {
        builder.part(name, Phong::of(color, 0.1, 10.0));
        let budget = share(triangles, 0.14) / (chimneys.len() as u32 * bands);
        for &(x, z, radius, height) in chimneys {
            for band in (0..bands).filter(|band| band % 2 == parity) {
                let at = |band: u32| band as f32 / bands as f32;
                let radius = |band: u32| radius * (1.0 - 0.45 * at(band));
                let ends = [(radius(band), at(band) * height), (radius(band + 1), at(band + 1) * height)];
                turned(builder, Vec3::new(x, 0.0, z), (1.0, 1.0), &ends, budget);
            }
        }
    }

    builder.part("cooling towers", Phong::of(srgb(186, 182, 174), 0.0, 1.0));
    all(builder, some(&TOWERS, share(triangles, 0.12), 42), &TOWER, share(triangles, 0.12));
    builder.part("columns and boilers", Phong::of(srgb(176, 182, 186), 0.5, 30.0));
    all(builder, some(&COLUMNS, share(triangles, 0.24), 54), &COLUMN, share(triangles, 0.24));

    builder.part("tanks and gas holders", Phong::of(srgb(232, 228, 216), 0.2, 24.0));
    let tanks = some(&TANKS, share(triangles, 0.24), 42);
    all(builder, tanks, &TANK, share(triangles, 0.24));
    let holders = &HOLDERS[..number(triangles, 80, [1, HOLDERS.len() as u32]) as usize];
    for &(x, z, radius) in holders {
        let fineness = ball::fineness(share(triangles, 0.12), holders.len() as u32).max(2);
        builder.ball(Vec3::new(x, radius + 2.5, z), radius, fineness);
    }

    // Legs of the gas holders and railings of the tanks.
    if triangles > 2000 {
        builder.part("legs and railings", Phong::of(srgb(226, 176, 56), 0.3, 30.0));
        for &(x, z, radius) in holders {
            for leg in 0..8 {
                let foot = around(x, z, radius * 0.97, leg as f32 / 8.0);
                builder.beam(foot, foot + Vec3::Y * (radius + 2.5), 0.45);
            }
        }
        let pieces = 24;
        let budget = share(triangles, 0.1) / (pieces * tanks.len() as u32);
        for &(x, z, radius, height) in tanks {
            for piece in 0..pieces {
                let at =
                    |piece: u32| around(x, z, radius * 1.01, piece as f32 / pieces as f32) + Vec3::Y * (height * 0.97);
                railing(builder, at(piece), at(piece + 1), budget);
            }
        }
    }
}

/// A place on a circle on the ground.
fn around(x: f32, z: f32, radius: f32, turn: f32) -> Vec3 {
    let angle = std::f32::consts::TAU * turn;
    Vec3::new(x + radius * float::cos(angle), 0.0, z + radius * float::sin(angle))
}

/// As many of the vessels as so many triangles allow, but at least one.
fn some(vessels: &[Vessel], triangles: u32, least: u32) -> &[Vessel] {
    let count = number(triangles, least, [1, vessels.len() as u32]);
    &vessels[..count as usize]
}

/// Vessels of one half section, with about so many triangles together.
fn all(builder: &mut Builder, vessels: &[Vessel], section: &[(f32, f32)], triangles: u32) {
    for &(x, z, radius, height) in vessels {
        let budget = triangles / vessels.len() as u32;
        turned(builder, Vec3::new(x, 0.0, z), (radius, height), section, budget);
    }
}

/// A surface of revolution of about so many triangles. Its half section is stretched by `size`; with few triangles only
/// some of its points are taken, with many there are more in between.
fn turned(builder: &mut Builder, foot: Vec3, size: (f32, f32), section: &[(f32, f32)], triangles: u32) {
    /// Segments around for each step between two points of the section.
    const SEGMENTS: u32 = 24;
    let points: Vec<Vec2> = section.iter().map(|&(x, y)| Vec2::new(x * size.0, y * size.1)).collect();
    let steps = points.windows(2).filter(|pair| pair[0] != pair[1]).count() as u32;
    let cuts = (triangles as f32 / (2 * steps * SEGMENTS) as f32).sqrt() as u32;
    let profile = match cuts {
        // Too few even for a triangular prism of all points: foot, shoulder and top.
        0 if triangles < 6 * steps => vec![points[0], points[points.len() * 2 / 3], points[points.len() - 1]],
        0 | 1 => points,
        _ => {
            let between = |pair: &[Vec2]| {
                let (from, to) = (pair[0], pair[1]);
                let cuts = if from == to { 1 } else { cuts };
                (0..cuts).map(move |cut| from.lerp(to, cut as f32 / cuts as f32)).collect::<Vec<_>>()
            };
            points.windows(2).flat_map(between).chain(points.last().copied()).collect()
        }
    };
    let steps = profile.windows(2).filter(|pair| pair[0] != pair[1]).count() as u32;
    builder.turned_around(foot, Vec3::Y, &profile, triangles / (2 * steps).max(1));
}
