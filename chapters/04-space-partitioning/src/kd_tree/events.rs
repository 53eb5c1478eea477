//! Events: where along an axis primitives begin and end. Between two of them the cost of a plane has no minimum.

use common::Vec3;
use ray_casting::aabb::Aabb;

use super::{
    build::Reference,
    split::{CellCost, Split},
};

/// In cells with more primitives planes are compared at equal distances, in others at each event.
const MANY: usize = 128;
/// Number of intervals between the planes at equal distances.
const BINS: usize = 32;

/// Lists of events, kept from one cell to the next, so that not every cell asks for memory.
#[derive(Default)]
pub(super) struct Events {
    begins: Vec<f32>,
    ends: Vec<f32>,
    /// Where primitives begin and end at once.
    flats: Vec<f32>,
}

impl Events {
    /// The cheapest plane of a cell.
    pub(super) fn cheapest(&mut self, references: &[Reference], cost: &CellCost, cell: &Aabb) -> Option<Split> {
        let mut best: Option<Split> = None;
        let mut offer = |split: Split| {
            let is_inside = cell.min[split.axis] < split.position && split.position < cell.max[split.axis];
            if is_inside && best.is_none_or(|best| split.cost < best.cost) {
                best = Some(split);
            }
        };
        if references.len() > MANY {
            in_bins(references, cost, &mut offer);
        } else {
            for axis in 0..3 {
                self.sweep(axis, references, cost, &mut offer);
            }
        }
        best
    }

    // ANCHOR: sweep
    /// Go along an axis from event to event. What begins before a plane reaches below it, what ends behind it above it.
    fn sweep(&mut self, axis: usize, references: &[Reference], cost: &CellCost, offer: &mut impl FnMut(Split)) {
        self.collect(axis, references);
        let Self { begins, ends, flats } = self;
        let all = references.len();
        let (mut begun, mut ended, mut passed) = (0, 0, 0);
        let next = |list: &[f32], i: usize| list.get(i).copied().unwrap_or(f32::INFINITY);
        while ended < ends.len() || passed < flats.len() {
            let position = next(begins, begun).min(next(ends, ended)).min(next(flats, passed));
            let split =
                |lower, upper| Split { axis, position, lower, upper, cost: cost.of(axis, position, lower, upper) };
            // What begins in the plane does not reach below it, and what ends there not above it.
            ended += count(&ends[ended..], position);
            if begun + passed == 0 {
                offer(split(0, all));
            }
            // What lies flat in the plane belongs to the lower half, unless nothing else does.
            passed += count(&flats[passed..], position);
            offer(split(begun + passed, all - ended - passed));
            begun += count(&begins[begun..], position);
        }
    }

    /// Sort the events of an axis into their lists.
    fn collect(&mut self, axis: usize, references: &[Reference]) {
        let Self { begins, ends, flats } = self;
        for list in [&mut *begins, ends, flats] {
            list.clear();
        }
        for (_, aabb) in references {
            let (begin, end) = (aabb.min[axis], aabb.max[axis]);
            if begin == end {
                flats.push(begin);
            } else {
                begins.push(begin);
                ends.push(end);
            }
        }
        for list in [begins, ends, flats] {
            list.sort_unstable_by(f32::total_cmp);
        }
    }
    // ANCHOR_END: sweep
}

/// How many numbers at the head of a sorted list are at most that large.
fn count(list: &[f32], most: f32) -> usize {
    list.iter().take_while(|&&x| x <= most).count()
}

// ANCHOR: bins
/// The same at equal distances only: count the primitives that begin and that end in each interval.
#[expect(clippy::cast_precision_loss, reason = "few intervals")]
fn in_bins(references: &[Reference], cost: &CellCost, offer: &mut impl FnMut(Split)) {
    let mut around = references[0].1;
    for (_, aabb) in references {
        around = Aabb { min: around.min.min(aabb.min), max: around.max.max(aabb.max) };
    }
    let size = around.max - around.min;
    let per_size = Vec3::from_array(size.to_array().map(|s| if s > 0.0 { BINS as f32 / s } else { 0.0 }));
    let mut begins = [[0_u32; BINS]; 3];
    let mut ends = [[0_u32; BINS]; 3];
    for (_, aabb) in references {
        let first = ((aabb.min - around.min) * per_size).to_array();
        let last = ((aabb.max - around.min) * per_size).to_array();
        for axis in 0..3 {
            begins[axis][bin(first[axis])] += 1;
            ends[axis][bin(last[axis])] += 1;
        }
    }
    let all = references.len();
    for axis in 0..3 {
        // Cut off the empty space on both sides.
        let (low, high) = (around.min[axis], around.max[axis]);
        offer(Split { axis, position: low, lower: 0, upper: all, cost: cost.of(axis, low, 0, all) });
        offer(Split { axis, position: high, lower: all, upper: 0, cost: cost.of(axis, high, all, 0) });
        let (mut lower, mut upper) = (0, all);
        for i in 1..BINS {
            lower += begins[axis][i - 1] as usize;
            upper -= ends[axis][i - 1] as usize;
            let position = low + size[axis] * (i as f32 / BINS as f32);
            offer(Split { axis, position, lower, upper, cost: cost.of(axis, position, lower, upper) });
        }
    }
}

/// The interval that a number from 0 to [`BINS`] lies in.
#[inline]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates at 0")]
fn bin(x: f32) -> usize {
    (x as usize).min(BINS - 1)
}
// ANCHOR_END: bins
