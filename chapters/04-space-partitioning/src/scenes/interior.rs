//! The interior: a reading room with arched windows, a long table, chairs, shelves of books and plants.
//!
//! It has the character and size of CONFERENCE: large flat walls, and furniture of many small triangles.

mod library;
mod room;
mod table;
mod things;

use common::{Rgb, Vec3, color::srgb};
use ray_casting::{
    light::{DirectionalLight, Light, PointLight},
    material::Phong,
    mesh::Shading,
};

use super::{Generator, budget::share, builder::Builder};
use crate::model::{Model, View};

/// The family of reading rooms.
pub const GENERATOR: Generator = Generator { name: "interior", full_size: 282_000, make };

/// The room reaches from −4 to 4 along x, with the windows at −4.
const HALF_WIDTH: f32 = 4.0;
/// Height of the ceiling.
const HEIGHT: f32 = 3.9;
/// z of the wall behind the viewer.
const NEAR: f32 = 1.2;
/// z of the far wall.
const FAR: f32 = -12.0;
/// Where the lamps hang over the table.
const LAMPS: [Vec3; 3] = [Vec3::new(0.0, 2.2, -4.0), Vec3::new(0.0, 2.2, -6.4), Vec3::new(0.0, 2.2, -8.8)];

fn make(triangles: u32) -> Model {
    let part = |of: f32| share(triangles, of);
    let mut builder = Builder::default();
    // What never moves.
    room::walls(&mut builder, part(0.05));
    room::ceiling(&mut builder, part(0.02));
    room::floor(&mut builder, part(0.06));
    room::window_bars(&mut builder, part(0.03));
    let shelves = library::shelves(triangles);
    builder.part("shelves", wood(srgb(122, 78, 46)));
    for shelf in &shelves {
        shelf.wood(&mut builder);
    }
    // What can be moved.
    things::curtains(&mut builder, part(0.06));
    library::books(&mut builder, &shelves, part(0.2));
    table::table(&mut builder, part(0.05));
    table::on_the_table(&mut builder, part(0.05));
    table::chairs(&mut builder, part(0.272));
    things::lamps(&mut builder, part(0.04));
    things::globe(&mut builder, part(0.02));
    // Leaves have what is left.
    things::plants(&mut builder, triangles);
    builder.without_empty_parts();
    Model {
        mesh: builder.mesh,
        shading: Shading::Smooth,
        parts: builder.parts,
        view: View { eye: Vec3::new(0.95, 1.62, 0.9), lookat: Vec3::new(-0.15, 1.42, -7.0), field_of_view: 44.0 },
        lights: lights(),
        ambient: Rgb::new(0.34, 0.32, 0.33),
        background: srgb(226, 236, 246),
    }
}

/// The sun and the sky through the windows, lamps over the table, and what the bright walls send back.
fn lights() -> Vec<Box<dyn Light>> {
    let mut lights: Vec<Box<dyn Light>> = vec![
        Box::new(DirectionalLight::new(Vec3::new(-1.0, 0.52, -0.12), Rgb::new(9.0, 7.0, 4.5))),
        // The sky before the windows.
        Box::new(PointLight { position: Vec3::new(-3.0, 2.0, -2.3), intensity: Rgb::new(3.4, 3.8, 4.4) }),
        Box::new(PointLight { position: Vec3::new(-2.9, 2.2, -8.7), intensity: Rgb::new(3.4, 3.8, 4.4) }),
        // What the sunlit floor sends to the ceiling.
        Box::new(PointLight { position: Vec3::new(0.9, 1.35, -0.6), intensity: Rgb::new(5.6, 4.6, 3.4) }),
    ];
    for lamp in LAMPS {
        lights.push(Box::new(PointLight { position: lamp + Vec3::Y * 0.07, intensity: Rgb::new(2.6, 1.9, 1.1) }));
    }
    lights
}

/// Brass, polished.
fn brass() -> Phong {
    Phong::of(srgb(196, 150, 70), 1.2, 60.0)
}

/// Waxed wood of a color.
fn wood(color: Rgb) -> Phong {
    Phong::of(color, 0.12, 30.0)
}
