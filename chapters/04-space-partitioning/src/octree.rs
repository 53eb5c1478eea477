//! The octree: a cube in eight equal parts, and each of them in eight again where many primitives are.
//!
//! Sources: Glassner, *Space Subdivision for Fast Ray Tracing*, IEEE CG&A 4(10), 1984; Revelles, Ureña, Lastra, *An
//! Efficient Parametric Algorithm for Octree Traversal*, WSCG 2000, for the order of the parts.

mod build;

use common::Interval;
use ray_casting::{aabb::Aabb, ray::Ray};

use crate::{
    primitives::{Primitives, octant},
    probe::Probe,
    query::{Query, Question},
    rounding::{greater, lesser},
    slabs::Slabs,
    structure::{Cell, Contents, Partition, Structure, StructureError},
};

// ANCHOR: octree
/// An octree over primitives.
#[derive(Clone, Debug)]
pub struct Octree<E> {
    aabb: Option<Aabb>,
    /// The whole is number 0. The eight parts of a cell follow each other.
    nodes: Vec<Node>,
    /// The lists of all leaves, one after the other.
    lists: Vec<E>,
}

/// A cell: either it is divided, or it lists primitives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Node {
    /// Number of the first of its parts, or where its list begins.
    first: u32,
    /// Length of its list, or [`DIVIDED`].
    count: u32,
}

/// Stands where a leaf has the length of its list.
const DIVIDED: u32 = u32::MAX;
/// Cells with more primitives are divided.
pub const FEW: usize = 32;
/// How often the whole is divided at most. Deeper cells could not be told apart in `f32`.
pub const MAX_DEPTH: usize = 20;
// ANCHOR_END: octree

/// A shape of many primitives behind an octree.
///
/// # Errors
/// [`StructureError`] if a primitive has no finite box, or there are too many.
pub fn octree<P: Primitives>(primitives: P) -> Result<Structure<P, Octree<P::Entry>>, StructureError> {
    let partition = Octree::over(&primitives, FEW)?;
    Ok(Structure { primitives, partition })
}

impl<E: Copy + Send + Sync> Octree<E> {
    /// An octree over primitives that divides cells with more than `few` of them.
    ///
    /// # Errors
    /// [`StructureError`] if a primitive has no finite box, or there are too many.
    pub fn over<P: Primitives<Entry = E>>(primitives: &P, few: usize) -> Result<Self, StructureError> {
        let Contents { boxes, around } = Contents::of(primitives)?;
        let around = around.map(|aabb| cube(&aabb));
        let (nodes, lists) = match around {
            Some(aabb) => build::build(primitives, few, boxes, aabb),
            None => (vec![Node { first: 0, count: 0 }], Vec::new()),
        };
        Ok(Self { aabb: around, nodes, lists })
    }

    /// The list of a leaf.
    #[inline(always)]
    fn list(&self, leaf: Node) -> &[E] {
        &self.lists[leaf.first as usize..][..leaf.count as usize]
    }
}

/// A cube around a box, with the same lower corner.
fn cube(aabb: &Aabb) -> Aabb {
    let side = (aabb.max - aabb.min).max_element();
    // Rounding must not make it smaller than the box.
    Aabb { min: aabb.min, max: (aabb.min + side).max(aabb.max) }
}

/// What does not change during a walk.
struct Walker<'w, E> {
    octree: &'w Octree<E>,
    slabs: Slabs,
    /// How far beside its place the ray may see something.
    hair: f32,
    /// Number of the part that a ray of this direction comes to first.
    first: usize,
}

impl<E: Copy + Send + Sync> Walker<'_, E> {
    // ANCHOR: walk
    /// Visit a cell that the ray is in during `inside`. Returns whether the search is over.
    fn visit<P: Primitives<Entry = E>, Q: Question, N: Probe>(
        &self,
        number: u32,
        cell: &Aabb,
        inside: Interval,
        query: &mut Query<'_, P, Q, N>,
    ) -> bool {
        query.visit(number);
        let node = self.octree.nodes[number as usize];
        if node.count != DIVIDED {
            return query.test(self.octree.list(node));
        }
        // Along each axis the ray is in the half that it comes to first until it meets the plane in the middle.
        let middle = cell.center();
        let meets = [0, 1, 2].map(|axis| self.slabs.meets(axis, middle[axis], self.hair));
        let first_half = meets.map(|[_, latest]| lesser(latest, inside.max));
        let second_half = meets.map(|[earliest, _]| greater(earliest, inside.min));
        for order in 0..8 {
            // Bit by bit: 0 for the half that comes first, 1 for the other. So no part comes before one that hides it.
            let mut part = inside;
            for axis in 0..3 {
                if order >> axis & 1 == 0 {
                    part.max = lesser(first_half[axis], part.max);
                } else {
                    part.min = greater(second_half[axis], part.min);
                }
            }
            let is_met = part.min <= part.max && part.min <= query.range().max;
            let octant_number = order ^ self.first;
            #[expect(clippy::cast_possible_truncation, reason = "at most 7")]
            if is_met
                && self.visit(node.first + octant_number as u32, &octant(cell, middle, octant_number), part, query)
            {
                return true;
            }
        }
        false
    }
    // ANCHOR_END: walk
}

impl<P: Primitives> Partition<P> for Octree<P::Entry> {
    fn walk<Q: Question, N: Probe>(&self, ray: &Ray, query: &mut Query<'_, P, Q, N>) {
        let slabs = Slabs::of(ray);
        let Some(aabb) = &self.aabb else { return };
        let Some(inside) = slabs.cross(aabb, query.range()) else { return };
        let first = (0..3).filter(|&axis| slabs.inverse[axis] < 0.0).map(|axis| 1 << axis).sum();
        Walker { octree: self, slabs, hair: slabs.hair(aabb), first }.visit(0, aabb, inside, query);
    }

    fn aabb(&self) -> Option<Aabb> {
        self.aabb
    }

    fn cells(&self) -> Vec<Cell<'_, P::Entry>> {
        let mut cells = Vec::new();
        let mut waiting: Vec<_> = self.aabb.into_iter().map(|aabb| (0, aabb)).collect();
        while let Some((number, aabb)) = waiting.pop() {
            let node = self.nodes[number as usize];
            if node.count == DIVIDED {
                waiting.extend((0..8).map(|i| (node.first + i, octant(&aabb, aabb.center(), i as usize))));
            } else {
                cells.push(Cell { number, aabb, list: self.list(node) });
            }
        }
        cells
    }

    fn bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice()) + size_of_val(self.lists.as_slice())
    }
}
