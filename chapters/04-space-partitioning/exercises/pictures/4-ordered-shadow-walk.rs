//! Picture of exercise 4.4: a bush in the sun, and how many tests its shadows take.

use common::{
    Error, Interval, Vec3,
    picture::{Panels, Picture, Render, Settings},
};
use ray_casting::{
    pictures::stage::{camera, square},
    ray::Ray,
    shape::Shape,
};
use space_partitioning::kd_tree::kd_tree;

use super::{
    Make,
    steps::{Scale, Steps},
};
use crate::checks::{
    hierarchy::{Asker, Asking, Node, boxes, median_tree},
    meshes::bush,
    walks::{AnyHit, Order},
};

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A bush of small and large pointed leaves on a floor, twice side by side. Each point is as bright as the number of tests that it took \
               to find out whether it lies in shadow. The shadow on the floor is brighter on the left than on the right.";
    super::picture("4.4-ordered-shadow-walk", alt, make)
}

/// Whether a ray hits anything in a tree.
type Walk = fn(&[Node], Interval, &mut dyn Asking) -> bool;

/// The number of tests, with the nearer half first and by `is_occluded`.
pub(crate) fn make(settings: &Settings, is_occluded: Walk) -> Result<Box<dyn Render>, Error> {
    let near_first: Walk =
        |nodes, range, ray| AnyHit { order: Order::Nearer, is_endless: false }.walk(nodes, range, ray, &mut false);
    let panels = [near_first, is_occluded].map(|walk| panel(settings, walk));
    let panels = panels.into_iter().collect::<Result<Vec<_>, _>>()?;
    Ok(Box::new(Panels::new(2, panels)))
}

/// The bush with shadows by one walk.
fn panel(settings: &Settings, walk: Walk) -> Result<Box<dyn Render>, Error> {
    let camera = camera([1.2, 2.6, 5.6], [0.35, 0.8, 0.0], 30.0, &settings.values)?;
    let triangles = bush(4000);
    let nodes = median_tree(&boxes(&triangles), 4);
    let leaves = kd_tree(triangles.clone())?;
    let floor = square(0.0, 100.0)?;
    let to_sun = Vec3::new(-0.75, 0.6, 0.25);
    let count = move |ray: &Ray| {
        let on_leaf = leaves.intersect(ray, Interval::POSITIVE);
        let range = Interval::POSITIVE.up_to(on_leaf.map_or(f32::INFINITY, |hit| hit.t));
        let Some(hit) = floor.intersect(ray, range).or(on_leaf) else { return 0 };
        let shadow_ray = Ray::new(hit.position + hit.geometric_normal * 1e-3, to_sun);
        let mut asker = Asker::new(&triangles, &shadow_ray);
        walk(&nodes, Interval::POSITIVE, &mut asker);
        asker.tests.len() as u64
    };
    Ok(Box::new(Steps { camera, most: 80.0, scale: Scale::Even, count }))
}
