//! The cover.

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    film::Size,
    knob::{Knob, Step},
    obj::ObjMesh,
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{
    background::Background,
    camera::Camera,
    light::DirectionalLight,
    material::Phong,
    mesh::{Mesh, Shading},
    scene::Scene,
    sphere::Sphere,
};
use shadows::offset::Offset;

use crate::{
    material::{Fresnel, Material},
    whitted::{Limits, Terms, Whitted},
};

/// How many surfaces a ray may have behind it.
const DEPTH: Knob =
    Knob::number("depth", "greatest depth of the recursion", [0.0, 10_000.0], 8.0, "surfaces", Step::Add(1.0));

pub(super) const PICTURE: Picture = Picture {
    name: "treasure",
    alt: "Spheres of gold, silver, copper and glass on a rough floor under an evening sky, each of them full of images \
          of the others.",
    knobs: &[DEPTH, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

struct Sky;
impl Background for Sky {
    fn radiance(&self, direction: Vec3) -> Rgb {
        let up = direction.normalize().y;
        Rgb::new(0.9, 0.5, 0.3).lerp(Rgb::new(0.1, 0.2, 0.5), up.clamp(0.0, 1.0).sqrt())
    }
}

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let mut scene = Scene::new();
    scene.ambient = Rgb::splat(0.2);
    scene.surround(Sky);
    scene.light(DirectionalLight::new(Vec3::new(-1.0, 1.5, 1.0), Rgb::splat(2.5)));
    let c = |x: f32, z: f32| Vec3::new(x * 30.0, 0.0, z * 30.0);
    let floor = ObjMesh {
        positions: vec![c(-1., -1.), c(-1., 1.), c(1., 1.), c(1., -1.)],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..ObjMesh::default()
    };
    scene.add("floor", Mesh::new(&floor, Shading::Flat)?, Material::rough(Phong::of(srgb(160, 140, 120), 0.0, 1.0)));
    for (x, z, m) in [
        (-2.2, 0.0, Material::GOLD),
        (0.0, -1.0, Material::SILVER),
        (2.2, 0.0, Material::COPPER),
        (0.0, 1.4, Material::glass(1.5)),
    ] {
        scene.add("ball", Sphere::new(Vec3::new(x, 1.0, z), 1.0), m);
    }
    let camera = Camera::orbited(Vec3::new(0.0, 2.6, 8.0), Vec3::new(0.0, 0.9, 0.0), 35.0, &settings.values)
        .map_err(|e| Error::Picture(e.to_string()))?;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the knob's range")]
    let max_depth = settings.values.number(&DEPTH) as u32;
    Ok(Box::new(Whitted {
        scene,
        camera,
        limits: Limits { max_depth, ..Limits::DEFAULT },
        terms: Terms::ALL,
        fresnel: Fresnel::Exact,
        offset: Offset::Following,
    }))
}
