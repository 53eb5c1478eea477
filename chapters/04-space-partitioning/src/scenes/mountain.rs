//! A mountain at a lake: a height field made of noise.

use common::{Rgb, Vec3, color::srgb};
use ray_casting::{light::DirectionalLight, material::Phong, mesh::Shading};

use super::{
    Generator,
    builder::Builder,
    noise::{fractal, noise, ridges, smooth_step},
};
use crate::model::{Model, View};

/// Mountains at a lake.
pub const GENERATOR: Generator = Generator { name: "mountain", full_size: 1_000_000, make };

/// Side of the square of land, in meters.
const SIDE: f32 = 12_000.0;
/// Distance from one ridge to the next, in meters.
const RIDGE: f32 = 3600.0;
/// Height of the peaks above the lake, in meters.
const PEAK: f32 = 3100.0;
/// Height from which snow lies, in meters.
const SNOW_LINE: f32 = 1050.0;
/// Beginning of the random numbers.
const SEED: u32 = 11;

/// What the land is made of.
const SNOW: usize = 0;
const ROCK: usize = 1;
const SCREE: usize = 2;
const MEADOW: usize = 3;
const FOREST: usize = 4;

/// The scene with about so many triangles.
fn make(triangles: u32) -> Model {
    let mut builder = Builder::default();

    // The water.
    builder.part("lake", Phong { ambient: srgb(206, 232, 236), ..Phong::of(srgb(26, 70, 84), 0.5, 24.0) });
    let half = SIDE / 2.0;
    let corner = |x: f32, z: f32| Vec3::new(x * half, 0.0, z * half);
    builder.quad([corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, -1.0)]);

    // The land: cells of two triangles.
    let cells = ((f64::from(builder.missing_to(triangles)) / 2.0).sqrt() + 0.5).max(2.0) as u32;
    let mut land = Builder::default();
    land.reserve(2 * cells * cells);
    let octaves = octaves(SIDE / cells as f32);
    land.surface(cells, cells, |u, v| {
        let (x, z) = (SIDE * (u - 0.5), SIDE * (0.5 - v));
        Vec3::new(x, height(x, z, octaves), z)
    });

    // Its triangles, one kind after the other.
    let mut kinds = [const { Vec::new() }; 5];
    for &corners in &land.mesh.triangles {
        kinds[kind(corners.map(|i| land.mesh.positions[i as usize]))].push(corners);
    }
    let first = builder.mesh.positions.len() as u32;
    builder.mesh.positions.append(&mut land.mesh.positions);
    let materials = [
        ("snow", srgb(238, 240, 246), 0.12),
        ("rock", srgb(112, 106, 106), 0.0),
        ("scree", srgb(150, 138, 126), 0.0),
        ("meadow", srgb(128, 134, 74), 0.0),
        ("forest", srgb(56, 84, 54), 0.0),
    ];
    for ((name, color, gloss), triangles) in materials.into_iter().zip(kinds) {
        if !triangles.is_empty() {
            builder.part(name, Phong::of(color, gloss, 10.0));
            builder.mesh.triangles.extend(triangles.into_iter().map(|corners| corners.map(|i| first + i)));
        }
    }

    Model {
        mesh: builder.mesh,
        shading: Shading::Smooth,
        parts: builder.parts,
        view: View {
            eye: Vec3::new(700.0, 330.0, 5900.0),
            lookat: Vec3::new(100.0, 1340.0, -1000.0),
            field_of_view: 38.0,
        },
        lights: vec![Box::new(DirectionalLight::new(Vec3::new(-1.0, 0.52, 0.62), Rgb::new(3.5, 2.6, 1.8)))],
        ambient: Rgb::new(0.2, 0.27, 0.42),
        background: srgb(176, 196, 222),
    }
}

/// Number of octaves of noise that cells of this size, in meters, can show.
fn octaves(cell: f32) -> u32 {
    let finest = RIDGE / (2.0 * cell).max(4.0);
    (1..).take_while(|&octave| finest >= (1 << octave) as f32).count().clamp(2, 10) as u32
}

/// Height of the land above the lake, in meters.
fn height(x: f32, z: f32, octaves: u32) -> f32 {
    let (u, v) = (x / RIDGE, z / RIDGE);
    // Bend the plane, so that ridges do not run straight.
    let bend = 0.35;
    let bent = (u + bend * noise(SEED + 50, u * 0.8, v * 0.8), v + bend * noise(SEED + 60, u * 0.8, v * 0.8));
    let ridge = ridges(SEED, bent.0, bent.1, octaves);
    let ground = fractal(SEED + 20, u * 1.4, v * 1.4, octaves.min(7));

    // Mountains stand in the back and on both sides; the middle of the front is a valley with the lake.
    let from_valley = Vec3::new((x - 900.0) / 3000.0, 0.0, (z - 3500.0) / 3500.0).length();
    let massif = smooth_step(0.55, 1.75, from_valley);
    // The highest peak.
    let from_peak = Vec3::new((x + 350.0) / 2400.0, 0.0, (z + 1900.0) / 2200.0).length_squared();
    let peak = 1.0 / (1.0 + 2.2 * from_peak);
    massif * PEAK * (ridge * (0.55 + 0.55 * peak) + 0.42 * peak) + 300.0 * ground + 190.0 * (from_valley - 0.62)
}

/// What a triangle of the land is made of.
fn kind(corners: [Vec3; 3]) -> usize {
    let [a, b, c] = corners;
    let middle = (a + b + c) / 3.0;
    let normal = (b - a).cross(c - a).normalize_or(Vec3::Y);
    let patches = fractal(SEED + 40, middle.x / 500.0, middle.z / 500.0, 5);
    // Borders are not level.
    let height = middle.y + 200.0 * patches;
    let woods = 380.0 + 620.0 * noise(SEED + 45, middle.x / 900.0, middle.z / 900.0);
    match (height, normal.y) {
        // Snow stays where it is not too steep, and the higher the steeper.
        (SNOW_LINE.., steepness) if steepness > 0.72 - (height - SNOW_LINE) / 6000.0 => SNOW,
        (_, ..0.62) => ROCK,
        (950.0.., _) | (_, ..0.72) if patches > 0.0 => SCREE,
        (950.0.., _) => ROCK,
        (height, _) if height > woods => MEADOW,
        _ => FOREST,
    }
}
