//! A choice among all structures, made while the program runs: for knobs, tables, and whoever compares them.

use std::sync::Arc;

use common::Interval;
use ray_casting::{hit::Hit, mesh::Mesh, ray::Ray, shape::Shape};

use crate::{
    eight_at_once::eight_at_once,
    every_one::every_one,
    grid::grid,
    kd_tree::{KdTree, kd_tree, split::Rule},
    octree::octree,
    primitives::Primitives,
    probe::Counts,
    query::Found,
    structure::{Partition, Structure, StructureError},
    triangles::Triangles,
};

/// Which structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// None: every triangle is tested.
    BruteForce,
    /// None: every triangle is looked at, but eight at once.
    EightAtOnce,
    /// The regular grid.
    Grid,
    /// The octree.
    Octree,
    /// The kd-tree by the surface area heuristic.
    KdTree,
    /// The kd-tree that halves through the median.
    MedianKdTree,
}

impl Choice {
    /// All of them.
    pub const ALL: [Choice; 6] =
        [Choice::BruteForce, Choice::EightAtOnce, Choice::Grid, Choice::Octree, Choice::KdTree, Choice::MedianKdTree];
    /// The three that the chapter teaches.
    pub const STRUCTURES: [Choice; 3] = [Choice::Grid, Choice::Octree, Choice::KdTree];
    /// Their names, in the order of [`Choice::ALL`].
    pub const NAMES: [&str; 6] = ["brute-force", "eight-at-once", "grid", "octree", "kd-tree", "median-kd-tree"];

    /// Whether it looks at everything: no structure at all.
    #[must_use]
    pub fn looks_at_everything(self) -> bool {
        matches!(self, Self::BruteForce | Self::EightAtOnce)
    }

    /// Its name, as in tables and on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }

    /// The structure over a mesh.
    ///
    /// # Errors
    /// [`StructureError`] if a triangle is not finite, or there are too many.
    pub fn over(self, mesh: Arc<Mesh>) -> Result<Arc<dyn Countable>, StructureError> {
        let triangles = Triangles(mesh);
        Ok(match self {
            Self::BruteForce => Arc::new(every_one(triangles)?),
            Self::EightAtOnce => Arc::new(eight_at_once(triangles)?),
            Self::Grid => Arc::new(grid(triangles)?),
            Self::Octree => Arc::new(octree(triangles)?),
            Self::KdTree => Arc::new(kd_tree(triangles)?),
            Self::MedianKdTree => {
                let partition = KdTree::over(&triangles, Rule::Median { few: Rule::FEW })?;
                Arc::new(Structure { primitives: triangles, partition })
            }
        })
    }
}

/// Any structure, behind a pointer. The call through the pointer happens once a ray, not once a step.
pub trait Countable: Shape {
    /// The nearest hit.
    fn find(&self, ray: &Ray, range: Interval) -> Option<Found>;

    /// The nearest hit, and what it took to find it.
    fn count_nearest(&self, ray: &Ray, range: Interval) -> (Option<Found>, Counts);

    /// Whether there is any hit, and what it took to find out.
    fn count_any(&self, ray: &Ray, range: Interval) -> (bool, Counts);

    /// All that is known about a hit that was found.
    fn hit(&self, ray: &Ray, found: Found) -> Option<Hit>;

    /// Memory, in bytes, beside the primitives.
    fn bytes(&self) -> usize;

    /// Number of cells that are not divided any further.
    fn cell_count(&self) -> usize;
}

impl<P: Primitives, T: Partition<P>> Countable for Structure<P, T> {
    fn find(&self, ray: &Ray, range: Interval) -> Option<Found> {
        self.nearest(ray, range, &mut ())
    }

    fn count_nearest(&self, ray: &Ray, range: Interval) -> (Option<Found>, Counts) {
        let mut counts = Counts::default();
        (self.nearest(ray, range, &mut counts), counts)
    }

    fn count_any(&self, ray: &Ray, range: Interval) -> (bool, Counts) {
        let mut counts = Counts::default();
        (self.any(ray, range, &mut counts).is_some(), counts)
    }

    fn hit(&self, ray: &Ray, found: Found) -> Option<Hit> {
        self.primitives.hit(found.number, ray, found.t)
    }

    fn bytes(&self) -> usize {
        self.partition.bytes()
    }

    fn cell_count(&self) -> usize {
        self.partition.cells().len()
    }
}
