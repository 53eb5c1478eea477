//! A power plant: storeys of steel, bundles of pipes, tanks, boilers, chimneys. From the bolts of a flange to the cooling
//! towers the sizes differ a thousandfold.

use common::{Rgb, Vec3, color::srgb};
use ray_casting::{light::DirectionalLight, material::Phong, mesh::Shading};

use super::{Generator, budget::share, builder::Builder, chance::Chance};
use crate::model::{Model, View};

mod flange;
mod house;
mod pipes;
mod steel;
mod vessels;

/// An industrial plant.
pub const GENERATOR: Generator = Generator { name: "plant", full_size: 12_700_000, make };

/// Seed of the random numbers of each kind of thing, so that one kind does not change another.
const SEED: u64 = 12;

/// The scene with about so many triangles.
fn make(triangles: u32) -> Model {
    let mut builder = Builder::default();
    builder.reserve(triangles);
    let chance = |kind: u64| Chance::numbered(SEED, kind);

    ground(&mut builder);
    vessels::vessels(&mut builder, share(triangles, 0.16));
    house::house(&mut builder, share(triangles, 0.34), &mut chance(1));
    if triangles >= 500 {
        pipes::rack(&mut builder, share(triangles, 0.02));
    }
    // Pipes take all that is left.
    let missing = builder.missing_to(triangles);
    pipes::pipes(&mut builder, missing, &mut chance(2));

    Model {
        mesh: builder.mesh,
        shading: Shading::Smooth,
        parts: builder.parts,
        view: View { eye: Vec3::new(66.0, 34.0, 98.0), lookat: Vec3::new(-3.0, 24.5, -8.0), field_of_view: 39.0 },
        lights: vec![
            Box::new(DirectionalLight::new(Vec3::new(-0.62, 0.55, 0.6), Rgb::new(3.2, 2.6, 1.9))),
            Box::new(DirectionalLight::new(Vec3::new(0.9, 0.5, 0.3), Rgb::new(0.3, 0.38, 0.5))),
        ],
        ambient: Rgb::new(0.2, 0.25, 0.33),
        background: srgb(164, 196, 222),
    }
}

/// The yard, and the land around.
fn ground(builder: &mut Builder) {
    let mut level = |name, color, half: (f32, f32), height| {
        builder.part(name, Phong::of(color, 0.0, 1.0));
        let corner = |x: f32, z: f32| Vec3::new(x * half.0, height, z * half.1);
        builder.quad([corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, -1.0)]);
    };
    level("land", srgb(132, 136, 88), (420.0, 420.0), -0.3);
    level("yard", srgb(170, 164, 152), (100.0, 84.0), 0.0);
}
