//! The march of a ray through the cells of a grid.

use common::Interval;
use ray_casting::ray::Ray;

use super::Cells;
use crate::{
    rounding::{after, before, lesser},
    slabs::Slabs,
};

// ANCHOR: march
/// Where a ray is on its way through a grid.
pub(super) struct March<'g> {
    cells: &'g Cells,
    slabs: Slabs,
    /// The cell that the ray is in.
    index: [u32; 3],
    /// Whether the ray runs upward along each axis: +1, or downward: −1.
    step: [i32; 3],
    /// For each axis the `t` at which the ray leaves the cell by it.
    leaves: [f32; 3],
    /// The `t` at which the ray entered the cell, or a little before.
    enters: f32,
    /// Cells beside the way that the ray may touch, still to be visited.
    beside: [u32; 3],
    beside_count: usize,
}
// ANCHOR_END: march

impl<'g> March<'g> {
    // ANCHOR: start
    /// A ray in the first cell that it visits in the interval `inside`.
    pub(super) fn new(cells: &'g Cells, ray: &Ray, slabs: &Slabs, inside: Interval) -> Self {
        let start = ray.at(inside.min);
        let step = slabs.inverse.to_array().map(|inverse| if inverse < 0.0 { -1 } else { 1 });
        let mut march = Self {
            cells,
            slabs: *slabs,
            index: [0, 1, 2].map(|axis| cells.index(axis, start[axis])),
            step,
            leaves: [0.0; 3],
            enters: inside.min,
            beside: [0; 3],
            beside_count: 0,
        };
        for axis in 0..3 {
            // The start is rounded: go back while the ray may enter the cell only later.
            while march.face(axis, false) > before(inside.min) && march.go(axis, -1) {}
            march.leaves[axis] = lesser(march.face(axis, true), f32::INFINITY);
        }
        march
    }
    // ANCHOR_END: start

    /// The `t` of the face across an axis by which the ray enters its cell, or by which it leaves.
    fn face(&self, axis: usize, leaves: bool) -> f32 {
        let is_upper = (self.step[axis] > 0) == leaves;
        self.slabs.plane(axis, self.cells.plane(axis, self.index[axis] + u32::from(is_upper)))
    }

    /// Move on by one cell along an axis, or back for `direction` −1. Says whether the grid goes on there.
    fn go(&mut self, axis: usize, direction: i32) -> bool {
        let next = self.index[axis].wrapping_add_signed(self.step[axis] * direction);
        let is_inside = next < self.cells.resolution[axis];
        if is_inside {
            self.index[axis] = next;
        }
        is_inside
    }

    /// The number of the cell.
    #[inline]
    pub(super) fn number(&self) -> u32 {
        self.cells.number(self.index)
    }

    /// The `t` before which no cell that is still to come can be hit.
    #[inline]
    pub(super) fn enters(&self) -> f32 {
        self.enters
    }

    // ANCHOR: next
    /// The number of the next cell; `None` behind the last one.
    #[inline]
    pub(super) fn next(&mut self) -> Option<u32> {
        if self.beside_count > 0 {
            self.beside_count -= 1;
            return Some(self.beside[self.beside_count]);
        }
        // Two comparisons find the face by which the ray leaves.
        let [x, y, z] = self.leaves;
        let axis = match (x < y, x < z, y < z) {
            (true, true, _) => 0,
            (false, _, true) => 1,
            _ => 2,
        };
        let t = self.leaves[axis];
        let others = [(axis + 1) % 3, (axis + 2) % 3];
        if others.iter().any(|&other| before(self.leaves[other]) <= after(t)) {
            self.look_beside(others, t);
        }
        self.enters = before(t);
        if !self.go(axis, 1) {
            // Only cells beside the way are left.
            self.leaves = [f32::INFINITY; 3];
            return if self.beside_count > 0 { self.next() } else { None };
        }
        self.leaves[axis] = lesser(self.face(axis, true), f32::INFINITY);
        Some(self.number())
    }
    // ANCHOR_END: next

    // ANCHOR: beside
    /// The ray passes an edge or a corner so near that rounding decides which face it leaves by: visit the cells behind
    /// the other faces too.
    #[cold]
    fn look_beside(&mut self, others: [usize; 2], t: f32) {
        let is_near = others.map(|axis| before(self.leaves[axis]) <= after(t) && self.leaves[axis] < f32::INFINITY);
        for goes in [[true, false], [false, true], [true, true]] {
            let mut index = self.index;
            for i in (0..2).filter(|&i| goes[i]) {
                index[others[i]] = index[others[i]].wrapping_add_signed(self.step[others[i]]);
            }
            let is_on_the_way = (0..2).all(|i| is_near[i] || !goes[i]);
            let is_inside = others.iter().all(|&axis| index[axis] < self.cells.resolution[axis]);
            if is_on_the_way && is_inside {
                self.beside[self.beside_count] = self.cells.number(index);
                self.beside_count += 1;
            }
        }
    }
    // ANCHOR_END: beside
}
