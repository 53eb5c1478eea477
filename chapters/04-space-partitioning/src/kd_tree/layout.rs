//! The layout: nodes that a ray visits one after the other lie side by side in memory.
//!
//! Source: Havran, *Heuristic Ray Shooting Algorithms*, 2000 (there: subtree representation).

use std::collections::VecDeque;

use super::Node;
use crate::subtree::TreeNode as _;

/// A processor fetches memory in lines of 64 bytes: four pairs of halves.
const PAIRS: usize = 4;

/// As many nodes as one line of memory holds, and at its beginning.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Line([Node; 2 * PAIRS]);

// ANCHOR: layout
/// The nodes of a tree, arranged in lines of memory: each line holds a small tree of pairs.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    lines: Vec<Line>,
}

/// A pair of halves that has no place yet: its number now, and that of the cell whose halves they are in the new order.
#[derive(Clone, Copy)]
struct Pair {
    old: u32,
    parent: u32,
}

impl Layout {
    /// Arrange nodes. The whole is number 0 in both orders.
    pub(super) fn of(nodes: &[Node]) -> Self {
        let mut layout = Self { lines: Vec::with_capacity(nodes.len() / (2 * PAIRS) + 1) };
        let mut next = 0;
        let mut near = VecDeque::new();
        // Those that found no place in the line of their parents wait for a line of their own.
        let mut waiting = Vec::new();
        layout.put(&mut next, nodes[0], &mut near);
        next += 1;
        while let Some(Pair { old, parent }) = near.pop_front().or_else(|| waiting.pop()) {
            layout.node_mut(parent).lower_half_is(next);
            for half in 0..2 {
                layout.put(&mut next, nodes[old as usize + half], &mut near);
            }
            if (next as usize).is_multiple_of(2 * PAIRS) {
                waiting.extend(near.drain(..).rev());
            }
        }
        layout
    }

    /// Give a node the next number, and let its halves follow.
    fn put(&mut self, next: &mut u32, node: Node, near: &mut VecDeque<Pair>) {
        if (*next as usize).is_multiple_of(2 * PAIRS) {
            self.lines.push(Line([Node::EMPTY; 2 * PAIRS]));
        }
        *self.node_mut(*next) = node;
        if !node.is_leaf() {
            near.push_back(Pair { old: node.number(), parent: *next });
        }
        *next += 1;
    }

    fn node_mut(&mut self, number: u32) -> &mut Node {
        &mut self.lines[number as usize / (2 * PAIRS)].0[number as usize % (2 * PAIRS)]
    }

    /// The node of a number.
    #[inline]
    pub(super) fn node(&self, number: u32) -> Node {
        self.lines[number as usize / (2 * PAIRS)].0[number as usize % (2 * PAIRS)]
    }

    /// Memory, in bytes.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(self.lines.as_slice())
    }
}
// ANCHOR_END: layout
