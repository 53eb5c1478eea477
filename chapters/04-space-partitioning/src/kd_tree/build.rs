//! Building a kd-tree from the top: choose a plane, sort the primitives to its two sides, do the same with the halves.

use ray_casting::aabb::Aabb;

use super::{
    LEAF, MAX_DEPTH, Node, halves,
    split::{Rule, Split, Splitter},
};
use crate::{
    primitives::Primitives,
    subtree::{ROOM, Subtree, TreeNode, growth, number},
};

/// A primitive and the box around the part of it that lies inside the cell.
pub(super) type Reference = (u32, Aabb);

/// Cells with fewer primitives are not worth a task of their own.
const TASK: usize = 4096;

/// The nodes and the lists of a whole tree.
pub(super) fn build<P: Primitives>(
    primitives: &P,
    rule: Rule,
    references: Vec<Reference>,
    aabb: Aabb,
) -> (Vec<Node>, Vec<P::Entry>) {
    let builder = Builder { primitives, rule };
    let mut tree = Subtree::new();
    // With n primitives a good tree is little deeper than log₂ n.
    let depth = (8 + 13 * references.len().max(1).ilog2() as usize / 10).min(MAX_DEPTH);
    builder.grow(&mut tree, 0, references, aabb, Limits { depth, room: ROOM }, &mut Splitter::default());
    tree.finish()
}

/// How far a cell may be divided.
#[derive(Clone, Copy)]
struct Limits {
    /// How often it may be halved.
    depth: usize,
    /// By which factor its entries may grow in all.
    room: f32,
}

struct Builder<'b, P> {
    primitives: &'b P,
    rule: Rule,
}

impl<P: Primitives> Builder<'_, P> {
    // ANCHOR: grow
    /// Make `node` a leaf, or halve it and go on with both halves.
    fn grow(
        &self,
        tree: &mut Subtree<Node, P::Entry>,
        node: usize,
        references: Vec<Reference>,
        cell: Aabb,
        limits: Limits,
        splitter: &mut Splitter,
    ) {
        let split = if limits.depth == 0 { None } else { splitter.choose(self.rule, &references, &cell) };
        let growth = |split: &Split| growth(split.lower + split.upper, references.len());
        let Some(split) = split.filter(|split| growth(split) <= limits.room) else {
            tree.set_leaf(node, references.iter().map(|(number, _)| self.primitives.entry(*number)));
            return;
        };
        let limits = Limits { depth: limits.depth - 1, room: limits.room / growth(&split).max(1.0) };
        let is_task = references.len() >= TASK;
        let [lower, upper] = self.part(references, &split);
        let [lower_cell, upper_cell] = halves(&cell, split.axis, split.position);
        let first = tree.nodes.len();
        tree.nodes.extend([Node::EMPTY; 2]);
        tree.nodes[node] = Node::halved(split.axis, split.position, number(first));
        if is_task {
            // Two cores can build the halves side by side. The result is the same, whoever is done first.
            let subtree = |references, cell| {
                let mut subtree = Subtree::new();
                self.grow(&mut subtree, 0, references, cell, limits, &mut Splitter::default());
                subtree
            };
            let both = common::parallel::join(|| subtree(lower, lower_cell), || subtree(upper, upper_cell));
            tree.hang(first, both.0);
            tree.hang(first + 1, both.1);
        } else {
            self.grow(tree, first, lower, lower_cell, limits, splitter);
            self.grow(tree, first + 1, upper, upper_cell, limits, splitter);
        }
    }
    // ANCHOR_END: grow

    // ANCHOR: part
    /// Sort the primitives of a cell into its halves. Those on both sides of the plane are cut by it.
    fn part(&self, references: Vec<Reference>, split: &Split) -> [Vec<Reference>; 2] {
        let Split { axis, position, .. } = *split;
        let mut lower = references;
        let mut upper = Vec::with_capacity(split.upper + split.upper / 16);
        lower.retain_mut(|reference| {
            let (index, aabb) = *reference;
            match split.side(&aabb) {
                Side::Lower => true,
                Side::Upper => {
                    upper.push(*reference);
                    false
                }
                Side::Both => {
                    let [below, above] =
                        halves(&aabb, axis, position).map(|half| self.primitives.clipped(index, &half));
                    upper.extend(above.map(|aabb| (index, aabb)));
                    if let Some(below) = below {
                        reference.1 = below;
                    }
                    below.is_some()
                }
            }
        });
        [lower, upper]
    }
    // ANCHOR_END: part
}

/// On which side of a plane a primitive lies.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Lower,
    Upper,
    Both,
}

impl TreeNode for Node {
    const EMPTY: Self = Self { place: 0, rest: LEAF };

    fn leaf(first: u32, count: u32) -> Self {
        Self { place: first, rest: count << 2 | LEAF }
    }

    fn moved(self, nodes: u32, lists: u32) -> Self {
        if self.is_leaf() {
            Self { place: self.place + lists, ..self }
        } else {
            Self::halved(self.axis(), self.position(), self.number().wrapping_add(nodes))
        }
    }
}
