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
    /// The lists, in pieces that nobody has put together yet.
    done: Vec<Vec<E>>,
    done_count: usize,
    /// The piece that grows.
    growing: Vec<E>,
}

impl<N: TreeNode, E> Subtree<N, E> {
    /// An empty leaf.
    pub(crate) fn new() -> Self {
        Self { nodes: vec![N::EMPTY], done: Vec::new(), done_count: 0, growing: Vec::new() }
    }

    /// Make a node a leaf that lists these entries.
    pub(crate) fn set_leaf(&mut self, node: usize, entries: impl Iterator<Item = E>) {
        let first = self.growing.len();
        self.growing.extend(entries);
        self.nodes[node] = N::leaf(number(self.done_count + first), number(self.growing.len() - first));
    }

    // ANCHOR: hang
    /// Put a subtree in the place of a node.
    pub(crate) fn hang(&mut self, node: usize, subtree: Self) {
        self.end_piece();
        // The subtree's whole goes to the node itself, all else to the end.
        let (nodes, lists) = (number(self.nodes.len()), number(self.done_count));
        let mut moved = subtree.nodes.into_iter().map(|node| node.moved(nodes.wrapping_sub(1), lists));
        if let Some(whole) = moved.next() {
            self.nodes[node] = whole;
        }
        self.nodes.extend(moved);
        // Lists are long: copy them only once, when all is done.
        self.done.extend(subtree.done);
        self.done_count += subtree.done_count;
        self.growing = subtree.growing;
        self.end_piece();
    }
    // ANCHOR_END: hang

    fn end_piece(&mut self) {
        self.done_count += self.growing.len();
        self.done.push(std::mem::take(&mut self.growing));
    }

    /// The nodes, and the lists in one piece.
    pub(crate) fn finish(mut self) -> (Vec<N>, Vec<E>) {
        if self.done.is_empty() {
            return (self.nodes, self.growing);
        }
        self.end_piece();
        let mut lists = Vec::with_capacity(self.done_count);
        self.done.into_iter().for_each(|mut piece| lists.append(&mut piece));
        (self.nodes, lists)
    }
}

// ANCHOR: room
/// By which factor the entries of all lists may be more than the primitives. A primitive that reaches into both halves
/// of a cell becomes two entries; without a limit, needles and overlapping things would fill the memory.
pub(crate) const ROOM: f32 = 3.5;

/// By which factor a division makes the entries more.
#[expect(clippy::cast_precision_loss, reason = "a ratio")]
pub(crate) fn growth(after: usize, before: usize) -> f32 {
    after as f32 / before as f32
}
// ANCHOR_END: room

/// A place in a list as a number of 32 bits. There are fewer than 2³⁰ of them: [`crate::structure::MOST_PRIMITIVES`].
#[expect(clippy::cast_possible_truncation, reason = "see above")]
pub(crate) fn number(n: usize) -> u32 {
    n as u32
}
