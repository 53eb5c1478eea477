//! A clearing in the forest: a lantern among standing stones, mushrooms, flowers, grass, and trees around.

use common::{Rgb, Vec3, color::srgb};
use ray_casting::{
    light::{DirectionalLight, PointLight},
    material::Phong,
    mesh::Shading,
};

use super::{
    Generator,
    budget::share,
    builder::Builder,
    chance::Chance,
    noise::{fractal, smooth_step},
};
use crate::model::{Model, View};

mod lantern;
mod meadow;
mod tree;

/// A clearing with trees.
pub const GENERATOR: Generator = Generator { name: "clearing", full_size: 174_000, make };

/// Half the side of the ground, in meters.
const HALF: f32 = 17.0;
/// Seed of the random numbers of each kind of thing, so that one kind does not change another.
const SEED: u64 = 2;

/// The scene with about so many triangles.
fn make(triangles: u32) -> Model {
    let mut builder = Builder::default();
    builder.reserve(triangles);
    let chance = |kind: u64| Chance::numbered(SEED, kind);

    builder.part("ground", Phong::of(srgb(70, 78, 46), 0.0, 1.0));
    let cells = ((f64::from(share(triangles, 0.05)) / 2.0).sqrt() as u32).clamp(2, 700);
    builder.surface(cells, cells, |u, v| ground(HALF * (2.0 * u - 1.0), HALF * (1.0 - 2.0 * v)));

    // The lantern is there in small scenes too.
    lantern::lantern(&mut builder, share(triangles, 0.02).max((triangles / 8).min(150)));
    lantern::stones(&mut builder, share(triangles, 0.04), &mut chance(1));
    tree::far_trees(&mut builder, share(triangles, 0.1), &mut chance(2));
    tree::trees(&mut builder, share(triangles, 0.46), &mut chance(3));
    meadow::mushrooms(&mut builder, share(triangles, 0.05), &mut chance(4));
    meadow::flowers(&mut builder, share(triangles, 0.04), &mut chance(5));
    let missing = builder.missing_to(triangles);
    meadow::grass(&mut builder, missing, &mut chance(6));

    let glow = PointLight { position: lantern::flame(), intensity: Rgb::new(36.0, 21.0, 8.8) };
    Model {
        mesh: builder.mesh,
        shading: Shading::Smooth,
        parts: builder.parts,
        view: View { eye: Vec3::new(0.5, 2.1, 7.8), lookat: Vec3::new(0.0, 1.35, 0.0), field_of_view: 41.0 },
        lights: vec![
            Box::new(glow),
            Box::new(DirectionalLight::new(Vec3::new(-0.7, 0.9, 0.1), Rgb::new(0.85, 1.15, 1.5))),
            Box::new(DirectionalLight::new(Vec3::new(0.6, 0.5, 0.9), Rgb::new(0.16, 0.21, 0.27))),
        ],
        ambient: Rgb::new(0.14, 0.2, 0.25),
        background: srgb(146, 176, 186),
    }
}

/// A point of the ground: flat in the middle, hilly toward the forest.
fn ground(x: f32, z: f32) -> Vec3 {
    let distance = (x * x + z * z).sqrt();
    let bumps = 0.16 * fractal(31, x * 0.6, z * 0.6, 4) * smooth_step(0.5, 3.0, distance);
    let hills = smooth_step(4.0, 16.0, distance) * (0.9 + 0.9 * fractal(37, x * 0.15, z * 0.15, 3));
    // The eye stands in a hollow.
    Vec3::new(x, bumps + hills * (1.0 - smooth_step(-4.0, 9.0, z)), z)
}
