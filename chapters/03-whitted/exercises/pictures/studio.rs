//! What several pictures share: a studio with soft lights, blocks, and the eye in it.

use common::{
    Error, Interval, Rgb, Vec3,
    obj::ObjMesh,
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{
    background::Background,
    camera::Camera,
    hit::Hit,
    mesh::{Mesh, Shading},
    ray::Ray,
    scene::Scene,
    shape::Shape,
};
use shadows::offset::Offset;
use whitted::{
    material::{Fresnel, Material},
    whitted::{Limits, Terms, Whitted},
};

/// Makes a picture of what a user has chosen.
pub(super) type Make = fn(&Settings) -> Result<Box<dyn Render>, Error>;

/// A picture with a camera that can be moved.
pub(super) const fn picture(name: &'static str, alt: &'static str, make: Make) -> Picture {
    let size = common::film::Size::of::<960, 540>();
    Picture { name, alt, knobs: &ORBIT, size, samples: 16, takes_mesh: false, make }
}

/// The walls of a studio: dark below, brighter toward the ceiling, with two soft lamps.
#[derive(Clone, Copy)]
pub(super) struct Studio {
    /// Radiance at the floor, in linear RGB.
    pub(super) low: Rgb,
    /// Radiance at the ceiling.
    pub(super) high: Rgb,
    /// Radiance of the soft lamps.
    pub(super) lamps: Rgb,
}

impl Background for Studio {
    fn radiance(&self, direction: Vec3) -> Rgb {
        let d = direction.normalize_or(Vec3::Y);
        let walls = self.low.lerp(self.high, smooth(-0.1, 0.8, d.y));
        // A long lamp on the left and a small square one on the right, both with soft edges.
        let left = lamp(d, Vec3::new(-0.8, 0.55, 0.35), [0.5, 0.16]);
        let right = lamp(d, Vec3::new(0.85, 0.6, 0.15), [0.14, 0.22]);
        walls + self.lamps * (left + 0.8 * right)
    }
}

/// How much of a soft rectangular lamp is seen in a direction.
fn lamp(d: Vec3, toward: Vec3, [wide, high]: [f32; 2]) -> f32 {
    let toward = toward.normalize_or(Vec3::Y);
    let across = toward.cross(Vec3::Y).normalize_or(Vec3::X);
    let forward = d.dot(toward);
    if forward <= 0.0 {
        return 0.0;
    }
    let [x, y] = [across, across.cross(toward)].map(|axis| (d.dot(axis) / forward).abs());
    (1.0 - smooth(0.85 * wide, 1.15 * wide, x)) * (1.0 - smooth(0.85 * high, 1.15 * high, y))
}

/// From 0 at `from` to 1 at `to`, without edges.
pub(super) fn smooth(from: f32, to: f32, x: f32) -> f32 {
    let x = ((x - from) / (to - from)).clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// The part of a horizontal square around the origin, at height 0, where `shows` says so of x and z.
pub(super) struct Ground {
    /// Half the side of the square, in scene units.
    pub(super) half: f32,
    /// Whether there is anything at x and z.
    pub(super) shows: fn(f32, f32) -> bool,
}

impl Shape for Ground {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let t = -ray.origin.y / ray.direction.y;
        if !range.contains(t) {
            return None;
        }
        let Vec3 { x, z, .. } = ray.at(t);
        let is_there = x.abs() < self.half && z.abs() < self.half && (self.shows)(x, z);
        is_there.then(|| Hit::new(ray, t, Vec3::Y))
    }
}

/// A solid with flat faces, each given by its corners in order, counterclockwise as seen from outside.
pub(super) fn solid(positions: Vec<Vec3>, faces: &[Vec<u32>]) -> Result<Mesh, Error> {
    // A face is a fan of triangles around its first corner.
    let fan = |face: &Vec<u32>| face.windows(2).skip(1).map(|w| [face[0], w[0], w[1]]).collect::<Vec<_>>();
    let triangles = faces.iter().flat_map(fan).collect();
    Mesh::new(&ObjMesh { positions, triangles, ..ObjMesh::default() }, Shading::Flat)
}

/// A scene as a camera sees it.
pub(super) fn view(scene: Scene<Material>, camera: Camera) -> Box<dyn Render> {
    Box::new(Whitted {
        scene,
        camera,
        limits: Limits::DEFAULT,
        terms: Terms::ALL,
        fresnel: Fresnel::Exact,
        offset: Offset::Following,
    })
}
