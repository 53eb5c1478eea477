//! The crate obvhs: hierarchies of boxes, its `Bvh2` as the preset `medium_build` makes it, with its own triangles.

use std::{sync::Arc, time::Duration};

use common::Vec3;
use obvhs::{
    BvhBuildParams,
    bvh2::{Bvh2, builder::build_bvh2_from_tris},
    ray::{Ray, RayHit},
    triangle::Triangle,
};
use space_partitioning::workload::Cast;

use super::{Failure, Given, Rival, timed, traced};

pub(super) struct Obvhs {
    given: Arc<Given>,
    triangles: Vec<Triangle>,
    tree: Bvh2,
    /// The triangles in the order of the tree, as its documentation advises.
    in_order: Vec<Triangle>,
}

impl Obvhs {
    pub(super) fn new(given: &Arc<Given>) -> Self {
        let triangle = |corners: [Vec3; 3]| {
            let [a, b, c] = corners.map(|corner| corner.to_array());
            Triangle { v0: a.into(), v1: b.into(), v2: c.into() }
        };
        let triangles = given.triangles().into_iter().map(|t| triangle(t.corners)).collect();
        if std::any::type_name_of_val(&Triangle::default().v0).contains("scalar") {
            println!("obvhs is slower than it could be: Cargo.lock makes it share our glam, whose vectors are scalar");
        }
        Self { given: Arc::clone(given), triangles, tree: Bvh2::default(), in_order: Vec::new() }
    }
}

impl Rival for Obvhs {
    fn name(&self) -> &'static str {
        "obvhs"
    }

    fn build(&mut self) -> Result<f64, Failure> {
        let (seconds, tree) =
            timed(|| build_bvh2_from_tris(&self.triangles, BvhBuildParams::medium_build(), &mut Duration::default()));
        self.in_order = tree.primitive_indices.iter().map(|&i| self.triangles[i as usize]).collect();
        self.tree = tree;
        Ok(seconds)
    }

    fn bytes(&self) -> Option<usize> {
        let Bvh2 { nodes, primitive_indices, .. } = &self.tree;
        Some(
            size_of_val(nodes.as_slice())
                + size_of_val(primitive_indices.as_slice())
                + size_of_val(self.in_order.as_slice()),
        )
    }

    fn trace(&mut self) -> Result<f64, Failure> {
        Ok(traced(&self.given.rays, |cast| self.nearest(cast)))
    }

    fn answers(&mut self) -> Result<Vec<f32>, Failure> {
        Ok(self.given.rays.iter().map(|cast| self.nearest(cast)).collect())
    }
}

impl Obvhs {
    #[inline]
    fn nearest(&self, Cast { ray, range }: &Cast) -> f32 {
        let (origin, direction) = (ray.origin.to_array().into(), ray.direction.to_array().into());
        let mut hit = RayHit::none();
        let ray = Ray::new(origin, direction, range.min, range.max);
        self.tree.ray_traverse(ray, &mut hit, |ray, i| self.in_order[i].intersect(ray));
        hit.t
    }
}
