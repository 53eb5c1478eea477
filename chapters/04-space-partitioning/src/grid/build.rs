//! Filling a grid: count what each cell will list, then write the lists one after the other.

use ray_casting::aabb::Aabb;

use super::Cells;
use crate::primitives::Primitives;

/// Grids with more entries for each primitive than this are too fine for what they hold, unless they are small.
const MOST_ENTRIES: u64 = 24;
/// Grids with fewer entries are small.
const SMALL: u64 = 1 << 16;

// ANCHOR: fill
/// For each cell where its list begins, and all lists; `None` if the cells are too many for primitives so large.
pub(super) fn fill<P: Primitives>(
    primitives: &P,
    cells: &Cells,
    boxes: &[(u32, Aabb)],
) -> Option<(Vec<u32>, Vec<P::Entry>)> {
    // Count what each cell will list, and from that where each list begins.
    let mut begins = vec![0_u32; cells.count() + 1];
    let mut entries = 0_u64;
    let most = SMALL.max(MOST_ENTRIES * boxes.len() as u64);
    for &(number, aabb) in boxes {
        for_each_cell(primitives, cells, number, aabb, &mut |cell| {
            begins[cell] += 1;
            entries += 1;
        });
        if entries > most {
            return None;
        }
    }
    let mut sum = 0;
    for begin in &mut begins {
        sum += std::mem::replace(begin, sum);
    }
    // Write the lists. Where one begins moves on with each entry, and stands in the end where the next one begins.
    let mut lists = match boxes.first() {
        Some(&(any, _)) => vec![primitives.entry(any); sum as usize],
        None => Vec::new(),
    };
    for &(number, aabb) in boxes {
        let entry = primitives.entry(number);
        for_each_cell(primitives, cells, number, aabb, &mut |cell| {
            lists[begins[cell] as usize] = entry;
            begins[cell] += 1;
        });
    }
    begins.rotate_right(1);
    begins[0] = 0;
    Some((begins, lists))
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
        self.0[axis][1] - self.0[axis][0] + 1
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
/// Tell in which cells a primitive is to be listed.
fn for_each_cell<P: Primitives>(primitives: &P, cells: &Cells, number: u32, aabb: Aabb, tell: &mut impl FnMut(usize)) {
    list_in(primitives, cells, number, aabb, Reach::of(cells, &aabb), tell);
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
    /// In so many cells a primitive is listed without looking closer.
    const FEW: u64 = 4;
    let all: u64 = (0..3).map(|axis| u64::from(reach.along(axis))).product();
    if all <= FEW {
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
