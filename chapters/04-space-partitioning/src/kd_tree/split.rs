//! Where to halve a cell: by the surface area heuristic, or through the median.
//!
//! Sources: MacDonald, Booth, *Heuristics for Ray Tracing Using Space Subdivision*, The Visual Computer 6, 1990;
//! Wald, Havran, *On Building Fast kd-Trees for Ray Tracing, and on Doing That in O(N log N)*, RT 2006.

use common::Vec3;
use ray_casting::aabb::Aabb;

use super::{
    build::{Reference, Side},
    events::Events,
};

// ANCHOR: rule
/// How the plane that halves a cell is chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// The plane of least expected cost.
    SurfaceArea(Costs),
    /// Across the longest side, so that half of the primitives begin below; cells of few primitives stay whole.
    Median {
        /// As many primitives as that are few.
        few: usize,
    },
}

/// What the steps of a walk cost, in units of each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Costs {
    /// Of visiting a halved cell.
    pub traversal: f32,
    /// Of testing a primitive.
    pub intersection: f32,
    /// Which share of the cost is forgiven if one half is empty, 0 to 1.
    pub empty_bonus: f32,
}

impl Default for Costs {
    fn default() -> Self {
        Self { traversal: 1.0, intersection: 0.5, empty_bonus: 0.2 }
    }
}

impl Rule {
    /// As many primitives are few, when nothing is said.
    pub const FEW: usize = 8;
}

impl Default for Rule {
    fn default() -> Self {
        Self::SurfaceArea(Costs::default())
    }
}
// ANCHOR_END: rule

/// A plane that halves a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Split {
    /// The axis that it is at right angles to.
    pub axis: usize,
    /// Where it is on that axis.
    pub position: f32,
    /// How many primitives reach below it.
    pub lower: usize,
    /// How many primitives reach above it.
    pub upper: usize,
    /// Expected cost of a ray that meets the cell.
    pub cost: f32,
}

impl Split {
    /// On which side a box lies. One that lies in the plane belongs to the lower half, unless that is to be empty.
    #[inline]
    pub(super) fn side(&self, aabb: &Aabb) -> Side {
        let (min, max) = (aabb.min[self.axis], aabb.max[self.axis]);
        if min >= self.position && (max > self.position || self.lower == 0) {
            Side::Upper
        } else if max <= self.position {
            Side::Lower
        } else {
            Side::Both
        }
    }
}

// ANCHOR: area
/// Half of the surface of a box: the chance that a ray meets it is in proportion.
#[inline]
#[must_use]
pub fn half_area(size: Vec3) -> f32 {
    size.x * size.y + size.y * size.z + size.z * size.x
}
// ANCHOR_END: area

// ANCHOR: cost
/// Expected cost of a ray that meets a cell which is halved by a plane.
#[derive(Clone, Copy, Debug)]
pub struct CellCost {
    costs: Costs,
    cell: Aabb,
    /// One over half of the surface of the cell.
    per_area: f32,
}

impl CellCost {
    /// Costs in a cell.
    #[must_use]
    pub fn new(costs: Costs, cell: &Aabb) -> Self {
        Self { costs, cell: *cell, per_area: half_area(cell.max - cell.min).recip() }
    }

    /// If the plane `axis = position` leaves that many primitives below it and above it.
    #[inline]
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "an estimate")]
    pub fn of(&self, axis: usize, position: f32, lower: usize, upper: usize) -> f32 {
        let Costs { traversal, intersection, empty_bonus } = self.costs;
        let (mut below, mut above) = (self.cell.max - self.cell.min, self.cell.max - self.cell.min);
        below[axis] = position - self.cell.min[axis];
        above[axis] = self.cell.max[axis] - position;
        // A ray that meets the cell meets a half with the chance of their surfaces' ratio.
        let tests = (half_area(below) * lower as f32 + half_area(above) * upper as f32) * self.per_area;
        let bonus = if lower == 0 || upper == 0 { 1.0 - empty_bonus } else { 1.0 };
        bonus * (traversal + intersection * tests)
    }
}
// ANCHOR_END: cost

/// The plane by which a rule halves a cell of primitives, numbered and in boxes; `None` if it leaves the cell whole.
#[must_use]
pub fn choose(rule: Rule, boxes: &[(u32, Aabb)], cell: &Aabb) -> Option<Split> {
    Splitter::default().choose(rule, boxes, cell)
}

/// Chooses planes. Keeps its memory from one cell to the next.
#[derive(Default)]
pub(super) struct Splitter {
    events: Events,
}

impl Splitter {
    /// The best plane for a cell, or none if it is better left whole.
    pub(super) fn choose(&mut self, rule: Rule, references: &[Reference], cell: &Aabb) -> Option<Split> {
        match rule {
            Rule::SurfaceArea(costs) => {
                let cost = CellCost::new(costs, cell);
                let best = self.events.cheapest(references, &cost, cell)?;
                #[expect(clippy::cast_precision_loss, reason = "an estimate")]
                let whole = costs.intersection * references.len() as f32;
                (best.cost < whole).then_some(best)
            }
            Rule::Median { few } => (references.len() > few).then(|| self.median(references, cell)).flatten(),
        }
    }

    /// The plane through the median across the longest side of a cell.
    fn median(&mut self, references: &[Reference], cell: &Aabb) -> Option<Split> {
        let axis = (cell.max - cell.min).max_position();
        let mut middles: Vec<_> =
            references.iter().map(|(_, aabb)| f32::midpoint(aabb.min[axis], aabb.max[axis])).collect();
        let half = middles.len() / 2;
        let (_, &mut position, _) = middles.select_nth_unstable_by(half, f32::total_cmp);
        let is_inside = cell.min[axis] < position && position < cell.max[axis];
        let count = |is_there: &dyn Fn(&Aabb) -> bool| references.iter().filter(|(_, aabb)| is_there(aabb)).count();
        let lower = count(&|aabb| aabb.min[axis] < position || aabb.max[axis] <= position);
        let upper = count(&|aabb| aabb.max[axis] > position);
        is_inside.then_some(Split { axis, position, lower, upper, cost: 0.0 })
    }
}
