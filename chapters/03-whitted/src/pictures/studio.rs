//! What several pictures share: the depth knob, how to look at a scene, a terrace at sea, a roll of paper, pencils.

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    knob::{Knob, Step},
    obj::ObjMesh,
    picture::Settings,
};
use ray_casting::{
    camera::Camera,
    frame::Frame,
    light::{DirectionalLight, Light},
    material::Phong,
    mesh::{Mesh, Shading},
    quadric::Quadric,
    scene::Scene,
};
use shadows::offset::Offset;

use super::{disc::Disc, evening::Evening, paper::Paper};
use crate::{
    material::{Fresnel, Material},
    whitted::{Limits, Terms, Whitted},
};

/// How many surfaces a ray may have behind it and still be followed.
pub(super) const DEPTH: Knob = depth(8.0);

/// The same knob with a default of its own.
pub(super) const fn depth(default: f32) -> Knob {
    Knob::number("depth", "greatest depth of the recursion", [0.0, 10_000.0], default, "surfaces", Step::Whole)
}

/// The limits of the recursion, with the depth that the user has chosen.
pub(super) fn limits(settings: &Settings, depth: &Knob) -> Limits {
    // The knob's range is far below the greatest u32.
    let max_depth = u32::try_from(settings.values.index(depth)).unwrap_or(u32::MAX);
    Limits { max_depth, ..Limits::DEFAULT }
}

/// A scene as it is usually seen: the whole formula, Fresnel's equations, the offset that follows.
pub(super) fn seen(scene: Scene<Material>, camera: Camera, limits: Limits) -> Whitted {
    Whitted { scene, camera, limits, terms: Terms::ALL, fresnel: Fresnel::Exact, offset: Offset::Following }
}

/// An evening at sea. The sun stands on the left behind the camera.
pub(super) fn evening() -> Scene<Material> {
    let toward_sun = Vec3::new(-0.62, 0.60, 0.58).normalize();
    let mut scene = Scene::new();
    scene.surround(Evening { sun: toward_sun });
    scene.light(DirectionalLight::new(toward_sun, Rgb::new(5.0, 3.6, 2.2)));
    // As bright as the sky in the mean, and cooler: what lies in shadow looks away from the sun.
    scene.ambient = Rgb::new(0.22, 0.22, 0.31);
    scene
}

/// A round terrace of slate with a band of stone and gold, in the evening.
pub(super) fn terrace() -> Scene<Material> {
    const RADIUS: f32 = 4.4;
    let mut scene = evening();
    let ring = |inner, outer| Disc { center: Vec3::ZERO, inner, outer };
    let slate = Material::rough(Phong::of(srgb(98, 104, 120), 0.0, 1.0));
    let stone = Material::rough(Phong::of(srgb(190, 172, 152), 0.0, 1.0));
    let side = Quadric::cylinder(RADIUS, 0.4).placed(Frame::at(Vec3::Y * -0.4));
    scene
        .add("stone", ring(0.0, 1.2), stone)
        .add("slate", ring(1.2, 3.25), slate)
        .add("gold inlay", ring(3.25, 3.33), Material::GOLD)
        .add("stone", ring(3.33, 3.75), stone)
        .add("gold inlay", ring(3.75, 3.83), Material::GOLD)
        .add("slate", ring(3.83, RADIUS), slate)
        .add("side of the terrace (cylinder)", side, slate);
    scene
}

/// An endless roll of white paper, lit from the upper left.
pub(super) fn paper() -> Scene<Material> {
    let mut scene = Scene::new();
    let white = Phong::of(srgb(226, 226, 228), 0.0, 1.0);
    let sun = DirectionalLight::new(Vec3::new(-0.75, 0.9, 0.25), Rgb::new(2.6, 2.5, 2.3));
    scene.ambient = Rgb::new(0.21, 0.22, 0.25);
    // Where the floor ends, it looks like the paper behind.
    let sunlight = sun.illuminate(Vec3::ZERO);
    let horizon = white.ambient * scene.ambient + sunlight.strength * white.diffuse_term(sunlight.direction, Vec3::Y);
    scene.surround(Paper { horizon });
    scene.light(sun);
    scene.add("floor", Disc { center: Vec3::ZERO, inner: 0.0, outer: 200.0 }, Material::rough(white));
    scene
}

/// Colored pencils that stand in a row around the z axis, their tips up.
pub(super) fn pencils(scene: &mut Scene<Material>, z: f32, height: f32) {
    const RADIUS: f32 = 0.17;
    let colors = [
        srgb(204, 44, 48),
        srgb(232, 118, 36),
        srgb(240, 196, 56),
        srgb(112, 172, 62),
        srgb(34, 140, 122),
        srgb(40, 116, 196),
        srgb(64, 62, 156),
        srgb(128, 58, 148),
        srgb(206, 74, 132),
    ];
    for (color, place) in colors.into_iter().zip(-4_i8..) {
        let foot = Vec3::new(f32::from(place) * 0.42, 0.0, z);
        let paint = Material::rough(Phong::of(color, 0.3, 40.0));
        let wood = Material::rough(Phong::of(srgb(222, 184, 138), 0.0, 1.0));
        scene.add("pencil (cylinder)", Quadric::cylinder(RADIUS, height).placed(Frame::at(foot)), paint);
        let tip = Frame::at(foot + Vec3::Y * height);
        scene.add("tip of a pencil (cone)", Quadric::cone(RADIUS, 0.5).placed(tip), wood);
    }
}

/// An upright rectangle above the line from `left` to `right`; its outside is on the viewer's side.
pub(super) fn wall(left: Vec3, right: Vec3, height: f32) -> Result<Mesh, Error> {
    let up = Vec3::Y * height;
    let obj = ObjMesh {
        positions: vec![left, right, right + up, left + up],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..ObjMesh::default()
    };
    Mesh::new(&obj, Shading::Flat)
}
