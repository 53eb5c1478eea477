//! The kd-tree: space halved by one plane after the other, each at right angles to an axis.
//!
//! Sources: Kaplan 1985 (as an axis-aligned BSP tree); Havran, *Heuristic Ray Shooting Algorithms*, 2000, for the walk.

mod build;
mod events;
mod layout;
pub mod split;

use arrayvec::ArrayVec;
use common::Interval;
use ray_casting::{aabb::Aabb, ray::Ray};

use self::{layout::Layout, split::Rule};
use crate::{
    primitives::Primitives,
    probe::Probe,
    query::{Query, Question},
    rounding::{greater, lesser},
    slabs::Slabs,
    structure::{Cell, Contents, Partition, Structure, StructureError},
    subtree::TreeNode as _,
};

// ANCHOR: node
/// A cell, in eight bytes: either it is halved by a plane, or it lists primitives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Node {
    /// A halved cell: where the plane is, as the bits of an `f32`. A leaf: where its list begins.
    place: u32,
    /// In the two lowest bits the axis that the plane is at right angles to, or [`LEAF`]. Above them, in a halved cell,
    /// the number of its lower half, the upper one being the next; in a leaf, the length of its list.
    rest: u32,
}

/// Stands where other nodes have their axis.
const LEAF: u32 = 3;
// ANCHOR_END: node

impl Node {
    fn halved(axis: usize, position: f32, lower: u32) -> Self {
        #[expect(clippy::cast_possible_truncation, reason = "0, 1 or 2")]
        Self { place: position.to_bits(), rest: lower << 2 | axis as u32 }
    }

    /// Let its halves have other numbers.
    fn lower_half_is(&mut self, number: u32) {
        self.rest = number << 2 | self.rest & 3;
    }

    fn is_leaf(self) -> bool {
        self.rest & 3 == LEAF
    }

    fn axis(self) -> usize {
        (self.rest & 3) as usize
    }

    fn position(self) -> f32 {
        f32::from_bits(self.place)
    }

    /// The number of the lower half, or the length of the list.
    fn number(self) -> u32 {
        self.rest >> 2
    }
}

// ANCHOR: kd_tree
/// A kd-tree over numbered primitives.
#[derive(Clone, Debug)]
pub struct KdTree<E> {
    aabb: Option<Aabb>,
    /// The whole is number 0. Halves come in pairs.
    nodes: Layout,
    /// The lists of all leaves, one after the other.
    lists: Vec<E>,
}

/// No leaf is deeper: as many halves wait at most while a ray walks.
pub const MAX_DEPTH: usize = 64;
// ANCHOR_END: kd_tree

/// A shape of many primitives behind a kd-tree.
///
/// # Errors
/// [`StructureError`] if a primitive has no finite box, or there are too many.
pub fn kd_tree<P: Primitives>(primitives: P) -> Result<Structure<P, KdTree<P::Entry>>, StructureError> {
    let partition = KdTree::over(&primitives, Rule::default())?;
    Ok(Structure { primitives, partition })
}

impl<E: Copy + Send + Sync> KdTree<E> {
    /// A tree over primitives whose planes are chosen by a rule.
    ///
    /// # Errors
    /// [`StructureError`] if a primitive has no finite box, or there are too many.
    pub fn over<P: Primitives<Entry = E>>(primitives: &P, rule: Rule) -> Result<Self, StructureError> {
        let Contents { boxes, around } = Contents::of(primitives)?;
        let (nodes, lists) = match around {
            Some(aabb) => build::build(primitives, rule, boxes, aabb),
            None => (vec![Node::EMPTY], Vec::new()),
        };
        Ok(Self { aabb: around, nodes: Layout::of(&nodes), lists })
    }

    /// The list of a leaf.
    #[inline(always)]
    fn list(&self, leaf: Node) -> &[E] {
        &self.lists[leaf.place as usize..][..leaf.number() as usize]
    }
}

/// A half that waits while the nearer one is visited, and the interval in which the ray is inside.
#[derive(Clone, Copy)]
struct Waiting {
    node: u32,
    inside: Interval,
}

impl<P: Primitives> Partition<P> for KdTree<P::Entry> {
    // ANCHOR: walk
    fn walk<Q: Question, N: Probe>(&self, ray: &Ray, query: &mut Query<'_, P, Q, N>) {
        let slabs = Slabs::of(ray);
        let Some(aabb) = &self.aabb else { return };
        let Some(mut inside) = slabs.cross(aabb, query.range()) else { return };
        let hair = slabs.hair(aabb);
        // Seen along the ray, the lower half of a cell comes second where the ray runs downward.
        // Four of each, so that two bits always are a valid index.
        let [origin, inverse] = [slabs.origin, slabs.inverse].map(|v| [v.x, v.y, v.z, 0.0]);
        let downward = inverse.map(|inverse| u32::from(inverse < 0.0));
        let hairs = inverse.map(|inverse| hair.copysign(inverse));
        let mut waiting = ArrayVec::<Waiting, MAX_DEPTH>::new();
        let mut number = 0;
        loop {
            query.visit(number);
            let node = self.nodes.node(number);
            if !node.is_leaf() {
                let axis = node.axis();
                // Between which t it meets the plane: as `Slabs::meets`.
                let distance = node.position() - origin[axis];
                let earliest = (distance - hairs[axis]) * inverse[axis];
                let latest = (distance + hairs[axis]) * inverse[axis];
                let near = node.number() + downward[axis];
                let far = node.number() + (downward[axis] ^ 1);
                if earliest > inside.max {
                    // The ray leaves the cell before it comes to the plane.
                    number = near;
                } else if latest < inside.min {
                    // It enters the cell behind the plane.
                    number = far;
                } else {
                    // It meets both halves: the nearer one first, the other one waits.
                    let farther = Interval::new(greater(earliest, inside.min), inside.max);
                    waiting.push(Waiting { node: far, inside: farther });
                    inside.max = lesser(latest, inside.max);
                    number = near;
                }
                continue;
            }
            if query.test(self.list(node)) {
                return;
            }
            // Go on with the half that waited last, unless a hit lies before it.
            loop {
                let Some(last) = waiting.pop() else { return };
                Waiting { node: number, inside } = last;
                if inside.min <= query.range().max {
                    break;
                }
            }
        }
    }
    // ANCHOR_END: walk

    fn aabb(&self) -> Option<Aabb> {
        self.aabb
    }

    fn cells(&self) -> Vec<Cell<'_, P::Entry>> {
        let mut cells = Vec::new();
        let mut waiting: Vec<_> = self.aabb.into_iter().map(|aabb| (0, aabb)).collect();
        while let Some((number, aabb)) = waiting.pop() {
            let node = self.nodes.node(number);
            if node.is_leaf() {
                cells.push(Cell { number, aabb, list: self.list(node) });
                continue;
            }
            let [lower, upper] = halves(&aabb, node.axis(), node.position());
            waiting.extend([(node.number() + 1, upper), (node.number(), lower)]);
        }
        cells
    }

    fn bytes(&self) -> usize {
        self.nodes.bytes() + size_of_val(self.lists.as_slice())
    }
}

/// A box, cut by a plane.
#[inline]
fn halves(aabb: &Aabb, axis: usize, position: f32) -> [Aabb; 2] {
    let [mut lower, mut upper] = [*aabb; 2];
    lower.max[axis] = position;
    upper.min[axis] = position;
    [lower, upper]
}
