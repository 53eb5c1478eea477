//! The probe: somebody who watches the walk of a ray through a structure.

// ANCHOR: probe
/// Is told each step of a walk. Every method does nothing unless a probe has its own.
pub trait Probe {
    /// The ray visits a cell: a cell of a grid, a node of a tree. Each structure numbers its own.
    fn visit(&mut self, _cell: u32) {}

    /// A primitive is tested.
    fn test(&mut self, _primitive: u32) {}

    /// The test says: hit.
    fn hit(&mut self, _primitive: u32) {}
}

/// Nobody watches, and the compiler leaves nothing of the calls.
impl Probe for () {}
// ANCHOR_END: probe

// ANCHOR: counts
/// Counts the steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Cells visited.
    pub cells: u64,
    /// Primitives tested.
    pub tests: u64,
    /// Tests that said: hit.
    pub hits: u64,
}

impl Probe for Counts {
    fn visit(&mut self, _cell: u32) {
        self.cells += 1;
    }

    fn test(&mut self, _primitive: u32) {
        self.tests += 1;
    }

    fn hit(&mut self, _primitive: u32) {
        self.hits += 1;
    }
}
// ANCHOR_END: counts

impl Counts {
    /// Steps of both kinds: cells visited and primitives tested.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.cells + self.tests
    }
}

impl std::ops::AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.cells += other.cells;
        self.tests += other.tests;
        self.hits += other.hits;
    }
}

/// Writes down which cells were visited and which primitives were tested, in their order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Walk {
    /// Numbers of the cells.
    pub cells: Vec<u32>,
    /// Numbers of the primitives.
    pub tests: Vec<u32>,
}

impl Probe for Walk {
    fn visit(&mut self, cell: u32) {
        self.cells.push(cell);
    }

    fn test(&mut self, primitive: u32) {
        self.tests.push(primitive);
    }
}
