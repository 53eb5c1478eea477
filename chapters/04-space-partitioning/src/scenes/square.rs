//! The square: houses with tiled roofs around a paved village square, with a fountain, a café, flowers and trees.
//!
//! It has the character and size of SAN MIGUEL: stone and tiles, and most of all leaves.

mod bunting;
mod cafe;
mod flowers;
mod ground;
mod houses;
mod roofs;
mod trees;
mod windows;

use common::{Rgb, Vec3, color::srgb};
use ray_casting::{
    light::{DirectionalLight, Light},
    mesh::Shading,
};

use super::{Generator, budget::share, builder::Builder, fountain::fountain};
use crate::model::{Model, View};

/// The family of village squares.
pub const GENERATOR: Generator = Generator { name: "square", full_size: 10_500_000, make };

/// The square reaches from here to here along x.
const SIDES: [f32; 2] = [-11.6, 12.4];
/// z of the houses at the far end.
const FAR: f32 = -17.0;
/// z where the paving begins, behind the viewer.
const NEAR: f32 = 9.0;
/// Where the fountain stands.
const FOUNTAIN: Vec3 = Vec3::new(0.6, 0.0, -9.0);

fn make(triangles: u32) -> Model {
    let part = |of: f32| share(triangles, of);
    let mut builder = Builder::default();
    builder.mesh.triangles.reserve(triangles as usize);
    builder.mesh.positions.reserve(triangles as usize + triangles as usize / 4);
    // What is built.
    let houses = houses::all(triangles);
    houses::walls(&mut builder, &houses, part(0.02));
    windows::windows(&mut builder, &houses, part(0.13));
    roofs::roofs(&mut builder, &houses, part(0.08));
    ground::paving(&mut builder, part(0.12));
    ground::hills(&mut builder, part(0.02));
    fountain(&mut builder, FOUNTAIN, part(0.02));
    cafe::cafe(&mut builder, part(0.06));
    bunting::bunting(&mut builder, part(0.005));
    // What grows.
    flowers::pots(&mut builder, &houses, part(0.04));
    flowers::creepers(&mut builder, part(0.06));
    trees::wood(&mut builder, part(0.03));
    // The leaves of the trees have what is left.
    trees::leaves(&mut builder, triangles);
    builder.without_empty_parts();
    Model {
        mesh: builder.mesh,
        shading: Shading::Smooth,
        parts: builder.parts,
        view: View { eye: Vec3::new(1.2, 2.5, 7.4), lookat: Vec3::new(-0.3, 3.0, -10.0), field_of_view: 46.0 },
        lights: lights(),
        ambient: Rgb::new(0.24, 0.26, 0.32),
        background: srgb(140, 186, 228),
    }
}

/// The sun of the late morning, the sky, and what bright walls send back.
fn lights() -> Vec<Box<dyn Light>> {
    vec![
        Box::new(DirectionalLight::new(Vec3::new(-0.62, 0.9, 0.5), Rgb::new(4.9, 4.0, 2.8))),
        Box::new(DirectionalLight::new(Vec3::new(0.1, 1.0, 0.15), Rgb::new(0.42, 0.5, 0.64))),
        Box::new(DirectionalLight::new(Vec3::new(0.7, 0.6, 1.0), Rgb::new(0.34, 0.32, 0.32))),
    ]
}
