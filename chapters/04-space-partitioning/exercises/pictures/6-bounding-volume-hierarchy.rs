//! Picture of exercise 4.6: a teapot in a stadium, found by a tree, and the steps of its rays.

use std::sync::Arc;

use common::{
    Error, Interval, Rgb,
    color::srgb,
    picture::{Panels, Picture, Render, Settings},
};
use ray_casting::aabb::Aabb;
use ray_casting::{
    hit::Hit, light::DirectionalLight, material::Phong, pictures::stage::camera, ray::Ray, scene::Scene, shape::Shape,
};
use shadows::{direct_light::DirectLight, offset::Offset};
use space_partitioning::{primitives::Primitives, query::Found, scenes::builder::Builder, triangles::Triangles};

use super::{
    Make,
    steps::{Scale, Steps},
};
use crate::checks::{
    hierarchy::{Asker, Asking, Node, boxes},
    meshes::{field, pot, seats, triangles},
};

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A white teapot on the green field of a stadium, with gray rings of seats behind it and a strip of blue sky. On the right the same view \
               by the number of steps of each ray: violet and red for the seats and the field, orange for the teapot, and pale along its rim and \
               in its handle.";
    super::picture("4.6-bounding-volume-hierarchy", alt, make)
}

/// Finds what a ray hits first.
type Nearest = fn(&[Node], Interval, &mut dyn Asking) -> Option<Found>;

/// Triangles behind a tree.
#[derive(Clone)]
struct Tree {
    triangles: Triangles,
    nodes: Arc<Vec<Node>>,
    nearest: Nearest,
}

impl Tree {
    fn new(mesh: &Builder, build: fn(&[Aabb]) -> Vec<Node>, nearest: Nearest) -> Self {
        let triangles = triangles(&mesh.mesh);
        let nodes = Arc::new(build(&boxes(&triangles)));
        Self { triangles, nodes, nearest }
    }

    /// What is hit first, and the number of steps to find it.
    fn find(&self, ray: &Ray, range: Interval) -> (Option<Found>, u64) {
        let mut asker = Asker::new(&self.triangles, ray);
        let found = (self.nearest)(&self.nodes, range, &mut asker);
        (found, asker.boxes + asker.tests.len() as u64)
    }
}

impl Shape for Tree {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let Found { number, t } = self.find(ray, range).0?;
        self.triangles.hit(number, ray, t)
    }
}

/// The stadium with a tree that `build` makes, in which `nearest` searches.
pub(crate) fn make(
    settings: &Settings,
    build: fn(&[Aabb]) -> Vec<Node>,
    nearest: Nearest,
) -> Result<Box<dyn Render>, Error> {
    let camera = camera([0.8, 1.6, 4.6], [0.05, 1.15, 0.0], 42.0, &settings.values)?;
    let [mut teapot, mut ground, mut stadium, mut whole] = [(); 4].map(|()| Builder::default());
    pot(&mut teapot);
    field(&mut ground);
    seats(&mut stadium);
    field(&mut whole);
    seats(&mut whole);
    pot(&mut whole);
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.30, 0.36, 0.46);
    scene.surround(srgb(150, 186, 222));
    scene.light(DirectionalLight::new(common::Vec3::new(0.6, 0.7, 0.5), Rgb::new(2.6, 2.3, 1.8)));
    scene.add("field", Tree::new(&ground, build, nearest), Phong::of(srgb(104, 140, 84), 0.0, 1.0));
    scene.add("stadium", Tree::new(&stadium, build, nearest), Phong::of(srgb(176, 170, 160), 0.0, 1.0));
    scene.add("teapot", Tree::new(&teapot, build, nearest), Phong::of(srgb(236, 232, 224), 0.5, 60.0));
    let left = DirectLight { scene, camera, offset: Offset::Following };
    let tree = Tree::new(&whole, build, nearest);
    let count = move |ray: &Ray| tree.find(ray, Interval::POSITIVE).1;
    let right = Steps { camera, most: 280.0, scale: Scale::Even, count };
    Ok(Box::new(Panels::new(2, vec![Box::new(left), Box::new(right)])))
}
