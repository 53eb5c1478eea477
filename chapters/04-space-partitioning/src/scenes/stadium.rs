//! The teapot in a stadium: a scene that is empty almost everywhere, and whose triangles are nearly all in one place.

use common::{Rgb, Vec3, color::srgb};
use ray_casting::{
    light::{Light, PointLight},
    material::Phong,
    mesh::Shading,
};

use super::{Generator, budget::share, builder::Builder};
use crate::model::{Model, View};

mod field;
mod stands;
pub(crate) mod teapot;

/// A teapot in a stadium.
pub const GENERATOR: Generator = Generator { name: "stadium", full_size: 1_000_000, make };

/// The stadium has at most so many triangles; all others are in the teapot.
const STADIUM: u32 = 9000;
/// Where the lamps of the four floodlights are, on one side of each axis, in meters.
const LAMPS: Vec3 = Vec3::new(92.0, 38.0, 78.0);

/// The scene with about so many triangles.
fn make(triangles: u32) -> Model {
    let mut builder = Builder::default();
    builder.reserve(triangles);
    let stadium = share(triangles, 0.4).min(STADIUM);

    field::field(&mut builder, stadium);
    stands::stands(&mut builder, share(stadium, 0.85));
    builder.part("floodlights", Phong::of(srgb(176, 182, 190), 0.3, 20.0));
    if stadium > 300 {
        for (x, z) in [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)] {
            stands::floodlight(&mut builder, LAMPS * Vec3::new(x, 1.0, z), stadium > 2000);
        }
    } else {
        builder.beam(LAMPS * Vec3::new(-1.0, 0.0, -1.0), LAMPS * Vec3::new(-1.0, 0.98, -1.0), 1.5);
    }
    let teapot = builder.missing_to(triangles);
    teapot::teapot(&mut builder, teapot);

    Model {
        mesh: builder.mesh,
        shading: Shading::Smooth,
        parts: builder.parts,
        view: View { eye: Vec3::new(0.43, 0.27, 0.53), lookat: Vec3::new(0.0, 0.205, -0.02), field_of_view: 52.0 },
        lights: vec![lamp(-1.0, 1.0, 2.3), lamp(1.0, 1.0, 0.7), lamp(1.0, -1.0, 1.2), lamp(-1.0, -1.0, 1.3)],
        ambient: Rgb::new(0.13, 0.16, 0.25),
        background: srgb(62, 84, 136),
    }
}

/// The light of one floodlight, that gives so much irradiance in the middle of the field.
fn lamp(x: f32, z: f32, strength: f32) -> Box<dyn Light> {
    // A little before the lamps, that they cast no shadow.
    let position = LAMPS * Vec3::new(x * 0.97, 1.0, z * 0.97);
    Box::new(PointLight { position, intensity: Rgb::new(1.0, 0.94, 0.84) * strength * position.length_squared() })
}
