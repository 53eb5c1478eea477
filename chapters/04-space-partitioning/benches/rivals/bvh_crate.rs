//! The crate bvh: a hierarchy of boxes that hands out shapes. It has no triangles that can be hit from both sides, so it
//! gets the test of chapter 1, as the structures of this chapter do.

use std::sync::Arc;

use bvh::{
    aabb::{Aabb, Bounded, IntersectsAabb},
    bounding_hierarchy::BHShape,
    bvh::{Bvh, rayon_executor},
    ray::Ray,
};
use common::Vec3;
use nalgebra::{Point3, Vector3};
use ray_casting::{triangle::Triangle, triangle_barycentric::Shear};
use space_partitioning::workload::Cast;

use super::{Failure, Given, Rival, timed, traced};

pub(super) struct BvhCrate {
    given: Arc<Given>,
    shapes: Vec<Shape>,
    tree: Bvh<f32, 3>,
}

/// A triangle that knows its place in the tree.
struct Shape {
    triangle: Triangle,
    node: usize,
}

impl Bounded<f32, 3> for Shape {
    fn aabb(&self) -> Aabb<f32, 3> {
        self.triangle.corners.iter().fold(Aabb::empty(), |aabb, corner| aabb.grow(&point(*corner)))
    }
}

impl BHShape<f32, 3> for Shape {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

fn point(v: Vec3) -> Point3<f32> {
    Point3::new(v.x, v.y, v.z)
}

impl BvhCrate {
    pub(super) fn new(given: &Arc<Given>) -> Self {
        let shapes = given.triangles().into_iter().map(|triangle| Shape { triangle, node: 0 }).collect();
        Self { given: Arc::clone(given), shapes, tree: Bvh { nodes: Vec::new() } }
    }

    #[inline]
    fn nearest(&self, Cast { ray, range }: &Cast) -> f32 {
        let view = Shear::along(ray);
        let ray = Ray::new(point(ray.origin), Vector3::from(ray.direction.to_array()));
        let mut range = *range;
        // By the distance of their boxes: none whose box begins behind the nearest hit can come before it.
        for shape in self.tree.nearest_traverse_iterator(&ray, &self.shapes) {
            if ray.intersection_slice_for_aabb(&shape.aabb()).is_some_and(|(enter, _)| enter > range.max) {
                break;
            }
            if let Some(hit) = shape.triangle.hit_by_barycentric(&view, range) {
                range = range.up_to(hit.t);
            }
        }
        range.max
    }
}

impl Rival for BvhCrate {
    fn name(&self) -> &'static str {
        "bvh"
    }

    fn build(&mut self) -> Result<f64, Failure> {
        let (seconds, tree) = timed(|| Bvh::build_with_executor(&mut self.shapes, rayon_executor));
        self.tree = tree;
        Ok(seconds)
    }

    fn bytes(&self) -> Option<usize> {
        Some(size_of_val(self.tree.nodes.as_slice()) + size_of_val(self.shapes.as_slice()))
    }

    fn trace(&mut self) -> Result<f64, Failure> {
        Ok(traced(&self.given.rays, |cast| {
            if std::env::var_os("PRUNED").is_some() { self.pruned(cast) } else { self.nearest(cast) }
        }))
    }

    fn answers(&mut self) -> Result<Vec<f32>, Failure> {
        Ok(self.given.rays.iter().map(|cast| self.nearest(cast)).collect())
    }
}

struct Pruned<'r> {
    ray: &'r Ray<f32, 3>,
    best: std::cell::Cell<f32>,
}
impl IntersectsAabb<f32, 3> for Pruned<'_> {
    #[inline]
    fn intersects_aabb(&self, aabb: &Aabb<f32, 3>) -> bool {
        self.ray.intersection_slice_for_aabb(aabb).is_some_and(|(enter, _)| enter <= self.best.get())
    }
}
impl BvhCrate {
    fn pruned(&self, Cast { ray, range }: &Cast) -> f32 {
        let view = Shear::along(ray);
        let ray = Ray::new(point(ray.origin), Vector3::from(ray.direction.to_array()));
        let query = Pruned { ray: &ray, best: range.max.into() };
        let mut range = *range;
        for shape in self.tree.traverse_iterator(&query, &self.shapes) {
            if let Some(hit) = shape.triangle.hit_by_barycentric(&view, range) {
                range = range.up_to(hit.t);
                query.best.set(hit.t);
            }
        }
        range.max
    }
}
