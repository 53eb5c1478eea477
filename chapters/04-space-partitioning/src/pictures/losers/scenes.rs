//! The scenes in which a structure loses.

use common::{Rgb, Vec3, color::srgb};
use ray_casting::{
    light::{DirectionalLight, Light},
    material::Phong,
    mesh::Shading,
};

use crate::{
    model::{Model, View},
    scenes::{builder::Builder, chance::Chance, stadium},
};

/// A scene with what is special about it.
pub(super) struct Scene {
    /// What it is.
    pub(super) title: &'static str,
    /// Why it is hard, in two lines.
    pub(super) why: [&'static str; 2],
    /// Makes it of about so many triangles.
    pub(super) make: fn(u32) -> Model,
}

/// One for each structure, in the order of [`crate::choice::Choice::STRUCTURES`].
pub(super) const SCENES: [Scene; 3] = [
    Scene {
        title: "a teapot in a stadium",
        why: ["Cells as large as the stadium asks for:", "a few of them hold all of the teapot."],
        make: stadium::GENERATOR.make,
    },
    Scene {
        title: "a dandelion",
        why: ["All triangles meet in one point:", "a cut in eight parts hardly parts them."],
        make: dandelion,
    },
    Scene {
        title: "an even cloud",
        why: ["Equally dense everywhere: there is", "nothing that a tree could adapt to."],
        make: cloud,
    },
];

/// Thin triangles from one point in all directions.
fn dandelion(triangles: u32) -> Model {
    let mut builder = Builder::default();
    builder.part("seeds", Phong::of(srgb(236, 214, 150), 0.0, 1.0));
    let middle = builder.vertex(Vec3::ZERO);
    for i in 0..triangles {
        let mut chance = Chance::of("seed", i);
        let tip = chance.direction() * chance.between(0.94, 1.0);
        let beside = tip + chance.direction() * 0.05;
        let [tip, beside] = [tip, beside].map(|vertex| builder.vertex(vertex));
        builder.triangle([middle, tip, beside]);
    }
    seen(builder, Vec3::new(1.9, 1.4, 2.7), 36.0)
}

/// Small triangles everywhere in a cube.
fn cloud(triangles: u32) -> Model {
    let mut builder = Builder::default();
    builder.part("crumbs", Phong::of(srgb(196, 206, 222), 0.0, 1.0));
    for i in 0..triangles {
        let mut chance = Chance::of("crumb", i);
        let middle = Vec3::new(chance.around(1.0), chance.around(1.0), chance.around(1.0));
        let corners = [0; 3].map(|_| middle + chance.direction() * 0.04);
        let corners = corners.map(|corner| builder.vertex(corner));
        builder.triangle(corners);
    }
    seen(builder, Vec3::new(1.6, 1.2, 2.2), 34.0)
}

/// Seen from somewhere, with the origin in the middle.
fn seen(builder: Builder, eye: Vec3, field_of_view: f32) -> Model {
    let sun = |direction, irradiance| -> Box<dyn Light> { Box::new(DirectionalLight::new(direction, irradiance)) };
    Model {
        mesh: builder.mesh,
        shading: Shading::Flat,
        parts: builder.parts,
        view: View { eye, lookat: Vec3::ZERO, field_of_view },
        lights: vec![
            sun(Vec3::new(-0.3, 1.0, 0.5), Rgb::new(3.0, 2.8, 2.4)),
            sun(Vec3::new(1.0, 0.2, 1.0), Rgb::new(0.5, 0.6, 0.8)),
        ],
        ambient: Rgb::new(0.22, 0.24, 0.3),
        background: srgb(42, 54, 84),
    }
}
