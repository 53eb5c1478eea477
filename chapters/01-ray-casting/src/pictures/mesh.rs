//! Any mesh, framed automatically.

use std::ops::RangeInclusive;

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    film::Size,
    knob::Knob,
    picture::{ORBIT, Picture, Render, Settings},
};

use super::stage::{camera_error, pawn};
use crate::{
    camera::Camera,
    light::DirectionalLight,
    local_illumination::{LocalIllumination, Terms},
    material::Phong,
    mesh::{Mesh, Shading},
    scene::Scene,
};

const SHADING: Knob = Knob::choice("shading", "which normals the triangles are shaded with", &["smooth", "flat"], 0);

pub(super) const PICTURE: Picture = Picture {
    name: "mesh",
    alt: "A chess pawn made of triangles, alone before a dark background, or any other mesh that is named with --mesh \
          FILE, framed so that all of it is seen.",
    knobs: &[SHADING, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<640, 480>(),
    samples: 4,
    takes_mesh: true,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let shading = [Shading::Smooth, Shading::Flat][settings.values.index(&SHADING).min(1)];
    let mesh = match &settings.mesh {
        Some(obj) => Mesh::new(obj, shading)?,
        None => Mesh::new(&pawn()?, shading)?,
    };
    // Stand back until the sphere around the mesh fills the field of view. A mesh in one point gets a radius too.
    const FIELD_OF_VIEW: f32 = 30.0;
    let bounds = mesh.bounds();
    let radius = (bounds.diagonal() / 2.0).max(bounds.center().abs().max_element() * 1e-6);
    // Squares of larger and smaller numbers leave the range of f32.
    const RADII: RangeInclusive<f32> = 1e-15..=1e15;
    if !RADII.contains(&radius) {
        let (least, most) = (RADII.start(), RADII.end());
        let message =
            format!("the mesh has a radius of {radius:e} units, and only {least:e} to {most:e} can be framed");
        return Err(Error::Picture(message));
    }
    let distance = 0.95 * radius / common::float::sin((FIELD_OF_VIEW / 2.0).to_radians());
    let toward = Vec3::new(0.5, 0.35, 1.0).normalize();
    let eye = bounds.center() + toward * distance;
    let camera = Camera::orbited(eye, bounds.center(), FIELD_OF_VIEW, &settings.values).map_err(camera_error)?;

    let mut scene = Scene::new();
    scene.ambient = Rgb::splat(0.10);
    scene.surround(srgb(34, 38, 46));
    scene.light(DirectionalLight::new(Vec3::new(0.9, 0.9, 1.0), Rgb::new(2.98, 2.7, 2.26)));
    scene.light(DirectionalLight::new(Vec3::new(-1.0, 0.3, -0.25), Rgb::new(1.07, 1.32, 1.88)));
    scene.add("mesh", mesh, Phong::of(srgb(214, 196, 164), 0.35, 40.0));
    Ok(Box::new(LocalIllumination { scene, camera, terms: Terms::ALL }))
}
