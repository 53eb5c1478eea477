//! Building an octree: divide a cell, sort its primitives to the eight parts, and do the same with each part.

use ray_casting::aabb::Aabb;

use super::{DIVIDED, MAX_DEPTH, Node};
use crate::{
    primitives::{Primitives, octant},
    subtree::{ROOM, Subtree, TreeNode, growth, number},
};

/// A primitive and the box around the part of it that lies inside the cell.
type Reference = (u32, Aabb);

/// Cells with fewer primitives are not worth a task of their own.
const TASK: usize = 8192;

/// The nodes and the lists of a whole tree.
pub(super) fn build<P: Primitives>(
    primitives: &P,
    few: usize,
    references: Vec<Reference>,
    aabb: Aabb,
) -> (Vec<Node>, Vec<P::Entry>) {
    let mut tree = Subtree::new();
    Builder { primitives, few }.grow(&mut tree, 0, &references, &aabb, MAX_DEPTH, ROOM);
    tree.finish()
}

impl TreeNode for Node {
    const EMPTY: Self = Self { first: 0, count: 0 };

    fn leaf(first: u32, count: u32) -> Self {
        Self { first, count }
    }

    fn moved(self, nodes: u32, lists: u32) -> Self {
        let by = if self.count == DIVIDED { nodes } else { lists };
        Self { first: self.first.wrapping_add(by), ..self }
    }
}

struct Builder<'b, P> {
    primitives: &'b P,
    few: usize,
}

impl<P: Primitives> Builder<'_, P> {
    // ANCHOR: grow
    /// Make `node` a leaf, or divide it and go on with its parts. `depth` says how often it may be divided, and `room` by
    /// which factor its entries may grow in all.
    fn grow(
        &self,
        tree: &mut Subtree<Node, P::Entry>,
        node: usize,
        references: &[Reference],
        cell: &Aabb,
        depth: usize,
        room: f32,
    ) {
        // A cell without size has no parts.
        let is_small = references.len() <= self.few || cell.min == cell.max;
        let parts = if is_small || depth == 0 { None } else { Some(self.part(references, cell)) };
        let growth = |parts: &[Vec<Reference>; 8]| growth(parts.iter().map(Vec::len).sum(), references.len());
        let Some(parts) = parts.filter(|parts| growth(parts) <= room) else {
            tree.set_leaf(node, references.iter().map(|(number, _)| self.primitives.entry(*number)));
            return;
        };
        let room = room / growth(&parts).max(1.0);
        let first = tree.nodes.len();
        tree.nodes.extend([Node::EMPTY; 8]);
        tree.nodes[node] = Node { first: number(first), count: DIVIDED };
        let grow = |tree: &mut _, node, i: usize| {
            self.grow(tree, node, &parts[i], &octant(cell, cell.center(), i), depth - 1, room)
        };
        if references.len() < TASK {
            (0..8).for_each(|i| grow(tree, first + i, i));
        } else {
            // Several cores can build the parts side by side. The result is the same, whoever is done first.
            let subtree = |i| {
                let mut subtree = Subtree::new();
                grow(&mut subtree, 0, i);
                subtree
            };
            for (i, subtree) in common::parallel::map(8, subtree).into_iter().enumerate() {
                tree.hang(first + i, subtree);
            }
        }
    }
    // ANCHOR_END: grow

    // ANCHOR: part
    /// Sort the primitives of a cell to its eight parts.
    fn part(&self, references: &[Reference], cell: &Aabb) -> [Vec<Reference>; 8] {
        let middle = cell.center();
        // On a surface, four of the parts hold about a quarter each.
        let mut parts: [Vec<Reference>; 8] = std::array::from_fn(|_| Vec::with_capacity(references.len() / 3));
        for &(number, aabb) in references {
            // What only touches a plane from below belongs to the part below it.
            let (is_below, is_above) = (aabb.max.cmple(middle), aabb.min.cmpge(middle));
            if (is_below | is_above).all() {
                // Its box lies in one part.
                parts[(!is_below).bitmask() as usize].push((number, aabb));
                continue;
            }
            let shares = self.primitives.octants(number, &aabb, middle);
            for (part, share) in parts.iter_mut().zip(shares) {
                part.extend(share.map(|aabb| (number, aabb)));
            }
        }
        parts
    }
    // ANCHOR_END: part
}
