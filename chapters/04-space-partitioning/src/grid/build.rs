//! Filling a grid: note what each cell will list, then write the lists one after the other.

use std::sync::atomic::{AtomicU64, Ordering};

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
    let room = Room { entries: AtomicU64::new(0), most: SMALL.max(MOST_ENTRIES * boxes.len() as u64) };
    let blocks = Reach::blocks(cells);
    let filled = common::parallel::map(blocks.len(), |i| fill_block(primitives, cells, boxes, blocks[i], &room));
    // Put the blocks together, and copy into the lists what a test needs.
    let filled = filled.into_iter().collect::<Option<Vec<_>>>()?;
    let (lengths, numbers): (Vec<_>, Vec<_>) = filled.into_iter().unzip();
    let lists = common::parallel::map_slice(&numbers.concat(), |&number| primitives.entry(number));
    Some((begins(lengths.into_iter().flatten()), lists))
}

/// How long the list of each cell of a block is, and the numbers in these lists, one list after the other; `None` if
/// there is no room for them.
fn fill_block<P: Primitives>(
    primitives: &P,
    cells: &Cells,
    boxes: &[(u32, Aabb)],
    block: Reach,
    room: &Room,
) -> Option<(Vec<u32>, Vec<u32>)> {
    // Note who is in which cell, and count how long the cell's list will be.
    let first = block.first(cells);
    let mut lengths = vec![0; block.count()];
    let mut notes: Vec<(u32, u32)> = Vec::new();
    for (number, aabb) in block.touched(cells, boxes) {
        let before = notes.len();
        for_each_cell(primitives, cells, number, aabb, block, &mut |cell| {
            lengths[(cell - first) as usize] += 1;
            notes.push((cell - first, number));
        });
        if !room.has(notes.len() - before) {
            return None;
        }
    }
    // Sort the notes by cell: each goes to where its cell's list has come to.
    let mut next = begins(lengths.iter().copied());
    let mut numbers = vec![0; notes.len()];
    for (cell, number) in notes {
        let place = &mut next[cell as usize];
        numbers[*place as usize] = number;
        *place += 1;
    }
    Some((lengths, numbers))
}

/// How many entries all lists have together, and how many they may have.
struct Room {
    entries: AtomicU64,
    most: u64,
}

impl Room {
    /// Whether there is room for so many entries more.
    fn has(&self, more: usize) -> bool {
        let more = more as u64;
        self.entries.fetch_add(more, Ordering::Relaxed) + more <= self.most
    }
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
    fn first(&self, cells: &Cells) -> u32 {
        cells.number(self.0.map(|[first, _]| first))
    }

    /// The space that the cells take, and a hair more on all sides.
    fn aabb(&self, cells: &Cells, hair: f32) -> Aabb {
        let [first, last] = [0, 1].map(|end| self.0.map(|ends| ends[end]));
        Aabb { min: cells.cell(first).min - hair, max: cells.cell(last).max + hair }
    }

    /// The boxes that touch it.
    fn touched(&self, cells: &Cells, boxes: &[(u32, Aabb)]) -> impl Iterator<Item = (u32, Aabb)> {
        let Aabb { min, max } = self.aabb(cells, 0.0);
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
    tell: &mut impl FnMut(u32),
) {
    let whole = Reach::of(cells, &aabb);
    let here = whole.within(block);
    if here.is_empty() {
        return;
    }
    // Of a primitive that sticks out of the block, only the part inside counts.
    let part = match here == whole || whole.count() <= FEW {
        true => Some(aabb),
        false => overlap(&aabb, &here.aabb(cells, cells.hair())).and_then(|inside| primitives.clipped(number, &inside)),
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
    tell: &mut impl FnMut(u32),
) {
    if reach.count() <= FEW {
        let [[x1, x2], [y1, y2], [z1, z2]] = reach.0;
        for z in z1..=z2 {
            for y in y1..=y2 {
                for x in x1..=x2 {
                    tell(cells.number([x, y, z]));
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
    // A ray along an axis sees corners a little beside their places: the halves overlap by more than that.
    lower.max[axis] = position + cells.hair();
    upper.min[axis] = position - cells.hair();
    for (half, side) in [(lower, [first, middle]), (upper, [middle + 1, last])] {
        if let Some(part) = primitives.clipped(number, &half) {
            let part_reach = Reach::of(cells, &part).within(reach.with(axis, side));
            list_in(primitives, cells, number, part, part_reach, tell);
        }
    }
}
// ANCHOR_END: cells
