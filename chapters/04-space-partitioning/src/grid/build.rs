//! Filling a grid: count what each cell will list, then write the lists one after the other.

use ray_casting::aabb::Aabb;

use super::Cells;
use crate::primitives::{Primitives, overlap};

/// Grids with more entries for each primitive than this are too fine for what they hold, unless they are small.
const MOST_ENTRIES: u64 = 24;
/// Grids with fewer entries are small.
const SMALL: u64 = 1 << 16;

/// In so many cells a primitive is listed without looking closer.
const FEW: usize = 4;
/// A grid is filled in so many blocks of layers at most, side by side.
const BLOCKS: u32 = 16;

// ANCHOR: fill
/// For each cell where its list begins, and all lists; `None` if the cells are too many for primitives so large.
pub(super) fn fill<P: Primitives>(
    primitives: &P,
    cells: &Cells,
    boxes: &[(u32, Aabb)],
) -> Option<(Vec<u32>, Vec<P::Entry>)> {
    // Count what each cell will list.
    let blocks = Reach::blocks(cells);
    let counts = common::parallel::map(blocks.len(), |i| count(primitives, cells, boxes, blocks[i]));
    let entries: u64 = counts.iter().flatten().map(|&n| u64::from(n)).sum();
    if entries > SMALL.max(MOST_ENTRIES * boxes.len() as u64) {
        return None;
    }
    // Write the lists of each block, and put the blocks together.
    let lists = common::parallel::map(blocks.len(), |i| write(primitives, cells, boxes, blocks[i], &counts[i]));
    let mut all = Vec::with_capacity(lists.iter().map(Vec::len).sum());
    lists.into_iter().for_each(|mut list| all.append(&mut list));
    Some((begins(counts.into_iter().flatten()), all))
}

/// How long the list of each cell of a block will be.
fn count<P: Primitives>(primitives: &P, cells: &Cells, boxes: &[(u32, Aabb)], block: Reach) -> Vec<u32> {
    let first = block.first(cells);
    let mut counts = vec![0; block.count()];
    for (number, aabb) in block.touched(cells, boxes) {
        for_each_cell(primitives, cells, number, aabb, block, &mut |cell| counts[cell - first] += 1);
    }
    counts
}

/// The lists of the cells of a block, one after the other.
fn write<P: Primitives>(
    primitives: &P,
    cells: &Cells,
    boxes: &[(u32, Aabb)],
    block: Reach,
    counts: &[u32],
) -> Vec<P::Entry> {
    let Some(&(any, _)) = boxes.first() else { return Vec::new() };
    let first = block.first(cells);
    // Where the next entry of each list goes.
    let mut next = begins(counts.iter().copied());
    let mut lists = vec![primitives.entry(any); next[counts.len()] as usize];
    for (number, aabb) in block.touched(cells, boxes) {
        for_each_cell(primitives, cells, number, aabb, block, &mut |cell| {
            lists[next[cell - first] as usize] = primitives.entry(number);
            next[cell - first] += 1;
        });
    }
    lists
}

/// Where lists of these lengths begin, and where the last one ends.
fn begins(counts: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut end = 0;
    let ends = counts.map(|count| {
        end += count;
        end
    });
    std::iter::once(0).chain(ends).collect()
}
// ANCHOR_END: fill

/// Cells along three axes, from the first to the last index of each.
#[derive(Clone, Copy, PartialEq)]
struct Reach([[u32; 2]; 3]);

impl Reach {
    /// The cells that a box touches. Their faces belong to them.
    fn of(cells: &Cells, aabb: &Aabb) -> Self {
        Self([0, 1, 2].map(|axis| {
            let (mut first, mut last) = (cells.index(axis, aabb.min[axis]), cells.index(axis, aabb.max[axis]));
            // An index is computed with rounding: go to where the faces are.
            while first > 0 && cells.plane(axis, first) >= aabb.min[axis] {
                first -= 1;
            }
            while last + 1 < cells.resolution[axis] && cells.plane(axis, last + 1) <= aabb.max[axis] {
                last += 1;
            }
            [first, last]
        }))
    }

    /// How many there are along an axis.
    fn along(&self, axis: usize) -> u32 {
        (self.0[axis][1] + 1).saturating_sub(self.0[axis][0])
    }

    /// All cells, in blocks of layers.
    fn blocks(cells: &Cells) -> Vec<Self> {
        let layers = cells.resolution[2];
        let count = layers.min(BLOCKS);
        let whole = Self(cells.resolution.map(|n| [0, n - 1]));
        (0..count).map(|i| whole.with(2, [layers * i / count, layers * (i + 1) / count - 1])).collect()
    }

    /// How many cells there are.
    fn count(&self) -> usize {
        (0..3).map(|axis| self.along(axis) as usize).product()
    }

    /// Whether there is none.
    fn is_empty(&self) -> bool {
        self.0.iter().any(|[first, last]| first > last)
    }

    /// The number of its first cell.
    fn first(&self, cells: &Cells) -> usize {
        cells.number(self.0.map(|[first, _]| first)) as usize
    }

    /// The space that the cells take.
    fn aabb(&self, cells: &Cells) -> Aabb {
        let [first, last] = [0, 1].map(|end| self.0.map(|ends| ends[end]));
        Aabb { min: cells.cell(first).min, max: cells.cell(last).max }
    }

    /// The boxes that touch it.
    fn touched(&self, cells: &Cells, boxes: &[(u32, Aabb)]) -> impl Iterator<Item = (u32, Aabb)> {
        let Aabb { min, max } = self.aabb(cells);
        // Blocks are layers: only z tells them apart.
        boxes.iter().copied().filter(move |(_, aabb)| aabb.min.z <= max.z && aabb.max.z >= min.z)
    }

    /// The same cells, but along one axis only those from `first` to `last`.
    fn with(mut self, axis: usize, ends: [u32; 2]) -> Self {
        self.0[axis] = ends;
        self
    }

    /// What two blocks of cells have in common.
    fn within(self, other: Self) -> Self {
        let common = |axis: usize| [self.0[axis][0].max(other.0[axis][0]), self.0[axis][1].min(other.0[axis][1])];
        Self([0, 1, 2].map(common))
    }
}

// ANCHOR: cells
/// Tell in which cells of a block a primitive is to be listed.
fn for_each_cell<P: Primitives>(
    primitives: &P,
    cells: &Cells,
    number: u32,
    aabb: Aabb,
    block: Reach,
    tell: &mut impl FnMut(usize),
) {
    let whole = Reach::of(cells, &aabb);
    let here = whole.within(block);
    if here.is_empty() {
        return;
    }
    // Of a primitive that sticks out of the block, only the part inside counts.
    let part = match here == whole || whole.count() <= FEW {
        true => Some(aabb),
        false => overlap(&aabb, &here.aabb(cells)).and_then(|inside| primitives.clipped(number, &inside)),
    };
    if let Some(part) = part {
        list_in(primitives, cells, number, part, Reach::of(cells, &part).within(here), tell);
    }
}

/// The same among the cells of a block. A primitive that reaches into many of them is cut in two.
fn list_in<P: Primitives>(
    primitives: &P,
    cells: &Cells,
    number: u32,
    aabb: Aabb,
    reach: Reach,
    tell: &mut impl FnMut(usize),
) {
    if reach.count() <= FEW {
        let [[x1, x2], [y1, y2], [z1, z2]] = reach.0;
        for z in z1..=z2 {
            for y in y1..=y2 {
                for x in x1..=x2 {
                    tell(cells.number([x, y, z]) as usize);
                }
            }
        }
        return;
    }
    // Halve the block across its longest side, and see what part of the primitive lies in each half.
    let axis = (0..3).max_by_key(|&axis| reach.along(axis)).unwrap_or(0);
    let [first, last] = reach.0[axis];
    let middle = first + (last - first) / 2;
    let position = cells.plane(axis, middle + 1);
    let [mut lower, mut upper] = [aabb; 2];
    lower.max[axis] = position;
    upper.min[axis] = position;
    for (half, side) in [(lower, [first, middle]), (upper, [middle + 1, last])] {
        if let Some(part) = primitives.clipped(number, &half) {
            let part_reach = Reach::of(cells, &part).within(reach.with(axis, side));
            list_in(primitives, cells, number, part, part_reach, tell);
        }
    }
}
// ANCHOR_END: cells
