//! A subtree that grows by itself, perhaps in another thread, and is hung into its tree when it is done.

/// A node of a tree whose nodes and lists are numbered.
pub(crate) trait TreeNode: Copy {
    /// A leaf with nothing in it.
    const EMPTY: Self;

    /// A leaf whose list begins at `first` and has `count` entries.
    fn leaf(first: u32, count: u32) -> Self;

    /// The same node in a tree where its parts have numbers greater by `nodes` and its list begins `lists` later.
    fn moved(self, nodes: u32, lists: u32) -> Self;
}

/// Nodes and lists, both numbered from zero. Node 0 is the whole.
pub(crate) struct Subtree<N, E> {
    pub(crate) nodes: Vec<N>,
    pub(crate) lists: Vec<E>,
}

impl<N: TreeNode, E> Subtree<N, E> {
    /// An empty leaf.
    pub(crate) fn new() -> Self {
        Self { nodes: vec![N::EMPTY], lists: Vec::new() }
    }

    /// Make a node a leaf that lists these entries.
    pub(crate) fn set_leaf(&mut self, node: usize, entries: impl Iterator<Item = E>) {
        let first = self.lists.len();
        self.lists.extend(entries);
        self.nodes[node] = N::leaf(number(first), number(self.lists.len() - first));
    }

    /// Put a subtree in the place of a node.
    // ANCHOR: hang
    pub(crate) fn hang(&mut self, node: usize, subtree: Self) {
        // The subtree's whole goes to the node itself, all else to the end.
        let (nodes, lists) = (number(self.nodes.len()), number(self.lists.len()));
        let mut moved = subtree.nodes.into_iter().map(|node| node.moved(nodes.wrapping_sub(1), lists));
        if let Some(whole) = moved.next() {
            self.nodes[node] = whole;
        }
        self.nodes.extend(moved);
        self.lists.extend(subtree.lists);
    }
    // ANCHOR_END: hang
}

/// A place in a list as a number of 32 bits. There are fewer than 2³⁰ of them: [`crate::structure::MOST_PRIMITIVES`].
#[expect(clippy::cast_possible_truncation, reason = "see above")]
pub(crate) fn number(n: usize) -> u32 {
    n as u32
}
