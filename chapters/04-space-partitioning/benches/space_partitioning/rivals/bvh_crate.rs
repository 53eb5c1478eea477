//! The crate bvh: a hierarchy of boxes that hands out shapes. Its own triangles can be hit from one side only, so it gets
//! the test of chapter 1, as the structures of this chapter do.

use std::{cell::Cell, sync::Arc};

use bvh::{
    aabb::{Aabb, Bounded, IntersectsAabb},
    bounding_hierarchy::BHShape,
    bvh::{Bvh, rayon_executor},
    ray::Ray,
};
use common::{Interval, Vec3};
use nalgebra::{Point3, Vector3};
use ray_casting::{triangle::Triangle, triangle_barycentric::Shear};
use space_partitioning::workload::Cast;

use super::{Failure, Given, Rival, timed, traced};

pub(super) struct BvhCrate {
    search: Search,
    given: Arc<Given>,
    shapes: Vec<Shape>,
    tree: Bvh<f32, 3>,
}

/// How the nearest hit is found.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Search {
    /// As the crate offers it: shapes by the distance of their boxes.
    Sorted,
    /// Faster, though the crate has no word for it: shapes in the tree's order, but no box behind the nearest hit so far.
    Pruned,
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
    pub(super) fn new(given: &Arc<Given>, search: Search) -> Self {
        let shapes = given.triangles().into_iter().map(|triangle| Shape { triangle, node: 0 }).collect();
        Self { search, given: Arc::clone(given), shapes, tree: Bvh { nodes: Vec::new() } }
    }

    #[inline]
    fn nearest(&self, Cast { ray, range }: &Cast) -> f32 {
        let view = Shear::along(ray);
        let ray = Ray::new(point(ray.origin), Vector3::from(ray.direction.to_array()));
        let query = NotBehind { ray: &ray, nearest: Cell::new(*range) };
        let test = |shape: &Shape| {
            if let Some(hit) = shape.triangle.hit_by_barycentric(&view, query.nearest.get()) {
                query.nearest.set(range.up_to(hit.t));
            }
        };
        match self.search {
            Search::Pruned => self.tree.traverse_iterator(&query, &self.shapes).for_each(test),
            // None whose box begins behind the nearest hit can come before it.
            Search::Sorted => self
                .tree
                .nearest_traverse_iterator(&ray, &self.shapes)
                .take_while(|shape| query.intersects_aabb(&shape.aabb()))
                .for_each(test),
        }
        query.nearest.get().max
    }
}

/// A ray that misses whatever lies behind its nearest hit so far.
struct NotBehind<'r> {
    ray: &'r Ray<f32, 3>,
    nearest: Cell<Interval>,
}

impl IntersectsAabb<f32, 3> for NotBehind<'_> {
    #[inline]
    fn intersects_aabb(&self, aabb: &Aabb<f32, 3>) -> bool {
        let inside = self.ray.intersection_slice_for_aabb(aabb);
        inside.is_some_and(|(enter, _)| enter <= self.nearest.get().max)
    }
}

impl Rival for BvhCrate {
    fn name(&self) -> &'static str {
        match self.search {
            Search::Sorted => "bvh",
            Search::Pruned => "bvh, pruned",
        }
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
        Ok(traced(&self.given.rays, |cast| self.nearest(cast)))
    }

    fn answers(&mut self) -> Result<Vec<f32>, Failure> {
        Ok(self.given.rays.iter().map(|cast| self.nearest(cast)).collect())
    }
}
