//! Any mesh, framed automatically.

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    film::Size,
    knob::Knob,
    picture::{ORBIT, Picture, Render, Settings},
};

use super::stage::{pawn, whole};
use crate::{
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
    let camera = whole(mesh.bounds(), &settings.values)?;
    let mut scene = Scene::new();
    scene.ambient = Rgb::splat(0.10);
    scene.surround(srgb(34, 38, 46));
    scene.light(DirectionalLight::new(Vec3::new(0.9, 0.9, 1.0), Rgb::new(2.98, 2.7, 2.26)));
    scene.light(DirectionalLight::new(Vec3::new(-1.0, 0.3, -0.25), Rgb::new(1.07, 1.32, 1.88)));
    scene.add("mesh", mesh, Phong::of(srgb(214, 196, 164), 0.35, 40.0));
    Ok(Box::new(LocalIllumination { scene, camera, terms: Terms::ALL }))
}
