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
    beside: [u32; 6],
    beside_count: usize,
    has_left: bool,
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
            beside: [0; 6],
            beside_count: 0,
            has_left: false,
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
        if self.has_left {
            return None;
        }
        // Two comparisons find the face by which the ray leaves.
        let [x, y, z] = self.leaves;
        let axis = if x < y {
            if x < z { 0 } else { 2 }
        } else if y < z {
            1
        } else {
            2
        };
        let t = self.leaves[axis];
        let others = [(axis + 1) % 3, (axis + 2) % 3];
        if others.iter().any(|&other| before(self.leaves[other]) <= after(t)) {
            return self.pass_edge(t);
        }
        self.enters = before(t);
        if !self.go(axis, 1) {
            return None;
        }
        self.leaves[axis] = lesser(self.face(axis, true), f32::INFINITY);
        Some(self.number())
    }
    // ANCHOR_END: next

    // ANCHOR: edge
    /// The ray passes an edge or a corner so near that rounding decides on which side: visit all cells around it.
    #[cold]
    fn pass_edge(&mut self, t: f32) -> Option<u32> {
        self.enters = before(t);
        let from = self.index;
        let is_passed = self.leaves.map(|leaves| before(leaves) <= after(t) && leaves < f32::INFINITY);
        let has_passed = |axes: usize, axis: usize| axes >> axis & 1 == 1;
        for axes in 1..7_usize {
            let to = [0, 1, 2]
                .map(|axis| from[axis].wrapping_add_signed(self.step[axis] * i32::from(has_passed(axes, axis))));
            let is_on_the_way = (0..3).all(|axis| is_passed[axis] || !has_passed(axes, axis));
            let is_inside = (0..3).all(|axis| to[axis] < self.cells.resolution[axis]);
            if is_on_the_way && is_inside {
                self.beside[self.beside_count] = self.cells.number(to);
                self.beside_count += 1;
            }
        }
        // The last of them is the cell behind all faces that the ray passes.
        for axis in (0..3).filter(|&axis| is_passed[axis]) {
            self.has_left |= !self.go(axis, 1);
            self.leaves[axis] = lesser(self.face(axis, true), f32::INFINITY);
        }
        if !self.has_left {
            return Some(self.number());
        }
        self.next()
    }
    // ANCHOR_END: edge
}
