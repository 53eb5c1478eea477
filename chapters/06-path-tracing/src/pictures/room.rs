//! A room with colored walls: where all comparisons of the chapter are made.

use std::{f32::consts::PI, sync::Arc};

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    film::Size,
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{
    camera::Camera,
    frame::Frame,
    light::PointLight,
    material::Phong,
    mesh::Shading,
    pictures::stage::{self, crystals},
    scene::Scene,
    sphere::Sphere,
};
use space_partitioning::{choice::Choice, scenes::builder::Builder};

use super::knobs::{METHOD, method};
use crate::{material::Material, method::Method, path_tracer::PathTracer, world::World};

pub(super) const PICTURE: Picture = Picture {
    name: "room",
    alt: "A room with a vermilion wall on the left, a blue one on the right, and all else white, lit by a bright panel in \
          the ceiling and by a lamp on the left. A tall white block stands behind, blue crystals in front of it, and a \
          gold mirror ball on the right shows the whole room. The white things are tinged red on the left and blue on the \
          right, and no shadow is black.",
    knobs: &[METHOD[0], METHOD[1], METHOD[2], METHOD[3], ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 600>(),
    samples: 32,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    Ok(Box::new(tracer(method(settings, [&METHOD[2], &METHOD[3]]), settings)?))
}

/// The room, seen in some way.
///
/// # Errors
/// [`Error::Picture`] if the knobs leave no direction to look in.
pub fn tracer(method: Method, settings: &Settings) -> Result<PathTracer, Error> {
    let lamp = if method.direct { Lamp::Abstract } else { Lamp::Glowing };
    Ok(PathTracer { world: Arc::new(world(lamp)?), camera: view(settings)?, method })
}

/// Who looks.
///
/// # Errors
/// [`Error::Picture`] if the knobs leave no direction to look in.
pub fn view(settings: &Settings) -> Result<Camera, Error> {
    stage::camera([0.0, 1.5, 3.75], [0.0, 1.36, 0.0], 47.0, &settings.values)
}

// ANCHOR: lamp
/// What the lamp is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lamp {
    /// A small ball that glows. A path finds it by chance.
    Glowing,
    /// A point without size, of the same power. It is asked at every hit.
    Abstract,
}

/// Where the lamp is, the radius of the ball, and its radiance.
const LAMP: Vec3 = Vec3::new(-1.05, 1.6, 0.75);
const RADIUS: f32 = 0.1;
const RADIANCE: Rgb = Rgb::new(100.0, 68.0, 36.0);

impl Lamp {
    fn put_into(self, scene: &mut Scene<Material>) {
        match self {
            Lamp::Glowing => {
                scene.add("lamp", Sphere::new(LAMP, RADIUS), Material::glowing(RADIANCE));
            }
            Lamp::Abstract => {
                // From far away a ball of radiance L and radius r is a disc: I = π r² L.
                scene.light(PointLight { position: LAMP, intensity: RADIANCE * (PI * RADIUS * RADIUS) });
            }
        }
    }
}
// ANCHOR_END: lamp

// ANCHOR: world
/// Half the width of the room, its height, and z of its far and near wall. The eye is inside.
const HALF_WIDTH: f32 = 2.0;
const HEIGHT: f32 = 2.9;
const FAR: f32 = -2.0;
const NEAR: f32 = 4.0;

/// The room and what is in it.
///
/// # Errors
/// None, since it has triangles.
pub fn world(lamp: Lamp) -> Result<World, Error> {
    let mut scene = Scene::new();
    scene.add("gold ball", Sphere::new(Vec3::new(0.86, 0.66, -0.25), 0.66), Material::GOLD);
    lamp.put_into(&mut scene);
    furnished(scene)
}

/// The same without the mirror: all that is left is matte.
///
/// # Errors
/// None, since it has triangles.
pub fn world_without_ball(lamp: Lamp) -> Result<World, Error> {
    let mut scene = Scene::new();
    lamp.put_into(&mut scene);
    furnished(scene)
}

/// A scene with the walls, the panel, the block and the crystals around it.
fn furnished(scene: Scene<Material>) -> Result<World, Error> {
    let matte = |color| Phong::of(color, 0.0, 1.0);
    let white = matte(srgb(236, 233, 228));
    let mut builder = Builder::default();
    let corner = Vec3::new;
    let (w, h, f, n) = (HALF_WIDTH, HEIGHT, FAR, NEAR);
    builder.part("floor", matte(srgb(222, 214, 202))).quad([
        corner(-w, 0.0, f),
        corner(-w, 0.0, n),
        corner(w, 0.0, n),
        corner(w, 0.0, f),
    ]);
    builder.part("ceiling", white).quad([corner(-w, h, f), corner(w, h, f), corner(w, h, n), corner(-w, h, n)]);
    builder.part("far wall", white).quad([corner(-w, 0.0, f), corner(w, 0.0, f), corner(w, h, f), corner(-w, h, f)]);
    builder.part("near wall", white).quad([corner(-w, 0.0, n), corner(-w, h, n), corner(w, h, n), corner(w, 0.0, n)]);
    builder.part("left wall", matte(srgb(226, 104, 74))).quad([
        corner(-w, 0.0, f),
        corner(-w, h, f),
        corner(-w, h, n),
        corner(-w, 0.0, n),
    ]);
    builder.part("right wall", matte(srgb(104, 168, 214))).quad([
        corner(w, 0.0, f),
        corner(w, 0.0, n),
        corner(w, h, n),
        corner(w, h, f),
    ]);
    // The panel hangs a little below the ceiling.
    let [left, right, back, front, under] = [-1.2, 1.2, -1.45, 1.6, h - 0.001];
    builder.part("panel", white).quad([
        corner(left, under, back),
        corner(right, under, back),
        corner(right, under, front),
        corner(left, under, front),
    ]);
    builder.part("block", white);
    let frame = Frame::at(corner(-0.72, 0.0, -0.95)).turned(Vec3::Y, 22.0);
    builder.cuboid(&frame, corner(-0.42, 0.0, -0.42), corner(0.42, 1.75, 0.42));
    builder.part("crystals", matte(srgb(96, 130, 214)));
    for triangle in crystals(corner(-0.28, 0.0, 0.42), 0.75)?.triangles() {
        let corners = triangle.corners.map(|corner| builder.vertex(corner));
        builder.triangle(corners);
    }
    let panel = Material::glowing(Rgb::new(1.75, 1.9, 2.15));
    let material = |name, phong: Phong| if name == "panel" { panel } else { phong.into() };
    World::new(scene).with_parts((&builder.mesh, Shading::Flat), &builder.parts, Choice::EightAtOnce, material)
}
// ANCHOR_END: world
