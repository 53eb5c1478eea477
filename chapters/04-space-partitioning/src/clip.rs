//! Clipping: the part of a triangle that lies inside a cell, and the box around it.
//!
//! Source: Sutherland, Hodgman, *Reentrant Polygon Clipping*, Communications of the ACM 17(1), 1974.

use common::Vec3;
use glam::DVec3;
use ray_casting::{aabb::Aabb, triangle::Triangle};

use crate::{
    primitives::overlap,
    rounding::{down, up},
};

/// Each of the six faces can add one corner to the three that there are.
const MOST_CORNERS: usize = 9;

/// A convex polygon with few corners, kept without asking the heap for memory.
struct Polygon {
    corners: [DVec3; MOST_CORNERS],
    count: usize,
}

/// The two sides of a plane.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Below,
    Above,
}

impl Polygon {
    const EMPTY: Self = Self { corners: [DVec3::ZERO; MOST_CORNERS], count: 0 };

    /// The part of a triangle inside a cell. It is cut by those faces alone that the triangle reaches through.
    fn of(triangle: &Triangle, cell: &Aabb) -> Self {
        let [a, b, c] = triangle.corners;
        let (min, max) = (a.min(b).min(c), a.max(b).max(c));
        let mut polygon = Self::EMPTY;
        for corner in triangle.corners {
            polygon.push(corner.as_dvec3());
        }
        for axis in 0..3 {
            if min[axis] < cell.min[axis] {
                polygon = polygon.part(axis, cell.min[axis], Side::Above);
            }
            if max[axis] > cell.max[axis] {
                polygon = polygon.part(axis, cell.max[axis], Side::Below);
            }
        }
        polygon
    }

    fn corners(&self) -> &[DVec3] {
        &self.corners[..self.count]
    }

    #[inline]
    fn push(&mut self, corner: DVec3) {
        // Rounding could add a corner too many only to a polygon without area.
        if self.count < MOST_CORNERS {
            self.corners[self.count] = corner;
            self.count += 1;
        }
    }

    // ANCHOR: part
    /// The part on one side of the plane `axis = position`. Corners in the plane belong to both sides.
    fn part(&self, axis: usize, position: f32, side: Side) -> Self {
        let position = f64::from(position);
        let depth = |corner: DVec3| match side {
            Side::Below => position - corner[axis],
            Side::Above => corner[axis] - position,
        };
        let mut part = Self::EMPTY;
        let Some(&last) = self.corners().last() else { return part };
        let (mut from, mut from_depth) = (last, depth(last));
        for &to in self.corners() {
            let to_depth = depth(to);
            // An edge that changes sides has a new corner in the plane.
            if from_depth * to_depth < 0.0 {
                let mut corner = from + (to - from) * (from_depth / (from_depth - to_depth));
                corner[axis] = position;
                part.push(corner);
            }
            if to_depth >= 0.0 {
                part.push(to);
            }
            (from, from_depth) = (to, to_depth);
        }
        part
    }
    // ANCHOR_END: part

    /// The box around it, rounded outward; `None` if it has no corner.
    fn aabb(&self) -> Option<Aabb> {
        let (&first, others) = self.corners().split_first()?;
        let (low, high) = others.iter().fold((first, first), |(low, high), &c| (low.min(c), high.max(c)));
        let min = Vec3::new(down(low.x), down(low.y), down(low.z));
        Some(Aabb { min, max: Vec3::new(up(high.x), up(high.y), up(high.z)) })
    }
}

// ANCHOR: clip
/// The box around the part of a triangle that lies inside a cell; `None` if no part does.
#[must_use]
pub fn clip(triangle: &Triangle, cell: &Aabb) -> Option<Aabb> {
    overlap(&Polygon::of(triangle, cell).aabb()?, cell)
}
// ANCHOR_END: clip

// ANCHOR: octants
/// The same for the eight parts of a cell around its middle: bit 0, 1, 2 of a part's number says whether it is the upper
/// one along x, y, z. A triangle that only touches a part is left out of it.
#[must_use]
pub fn clip_to_octants(triangle: &Triangle, cell: &Aabb, middle: Vec3) -> [Option<Aabb>; 8] {
    let mut parts = [None; 8];
    share(&Polygon::of(triangle, cell), cell, middle, 0, 0, &mut parts);
    parts
}

/// Halve a polygon along the axes from `axis` on.
fn share(part: &Polygon, cell: &Aabb, middle: Vec3, axis: usize, number: usize, parts: &mut [Option<Aabb>; 8]) {
    if axis == 3 {
        parts[number] = part.aabb().and_then(|aabb| overlap(&aabb, cell));
        return;
    }
    let plane = f64::from(middle[axis]);
    let [reaches_down, reaches_up] = part
        .corners()
        .iter()
        .fold([false; 2], |[down, up], corner| [down | (corner[axis] < plane), up | (corner[axis] > plane)]);
    if reaches_down && reaches_up {
        let half = |side| part.part(axis, middle[axis], side);
        share(&half(Side::Below), cell, middle, axis + 1, number, parts);
        share(&half(Side::Above), cell, middle, axis + 1, number | 1 << axis, parts);
    } else {
        share(part, cell, middle, axis + 1, number | usize::from(reaches_up) << axis, parts);
    }
}
// ANCHOR_END: octants

#[cfg(test)]
mod tests {
    use common::Stream;

    use super::*;

    const CELL: Aabb = Aabb { min: Vec3::ZERO, max: Vec3::ONE };

    #[test]
    fn a_triangle_inside_keeps_its_box() {
        let triangle = Triangle::new(Vec3::splat(0.2), Vec3::new(0.9, 0.3, 0.4), Vec3::new(0.5, 0.8, 0.6));
        let aabb = clip(&triangle, &CELL);
        assert_eq!(aabb, Aabb::around(&triangle.corners));
    }

    #[test]
    fn a_triangle_whose_box_overlaps_may_miss_the_cell() {
        // Passes the corner (1, 1) of the cell: the boxes overlap, the triangle does not.
        let triangle = Triangle::new(Vec3::new(2.0, 0.1, 0.5), Vec3::new(0.1, 2.0, 0.5), Vec3::new(2.0, 2.0, 0.6));
        assert!(overlap(&Aabb::around(&triangle.corners).unwrap(), &CELL).is_some());
        assert_eq!(clip(&triangle, &CELL), None);
        // A face touched from outside counts, in a point or in an edge.
        let beside = Triangle::new(Vec3::new(1.0, 0.5, 0.5), Vec3::new(2.0, 0.0, 0.0), Vec3::new(2.0, 1.0, 0.0));
        assert_eq!(clip(&beside, &CELL), Some(Aabb { min: Vec3::new(1.0, 0.5, 0.5), max: Vec3::new(1.0, 0.5, 0.5) }));
    }

    /// The corners of the part of a triangle inside the cell, found in another way: corners of the triangle inside the
    /// cell, edges of the triangle through its faces, and edges of the cell through the triangle.
    fn corners_of_part(triangle: &Triangle) -> Vec<DVec3> {
        const NEAR: f64 = 1e-9;
        let [a, b, c] = triangle.corners.map(Vec3::as_dvec3);
        let mut corners = vec![a, b, c];
        for (from, to) in [(a, b), (b, c), (c, a)] {
            for axis in 0..3 {
                let through = |plane: f64| from + (to - from) * ((plane - from[axis]) / (to[axis] - from[axis]));
                corners.extend([0.0, 1.0].map(through).into_iter().filter(|p| {
                    let along = (*p - from).dot(to - from) / (to - from).length_squared();
                    (0.0..=1.0).contains(&along)
                }));
            }
        }
        let normal = (b - a).cross(c - a);
        let is_inside = |p: DVec3| {
            let left = |from: DVec3, to: DVec3| (to - from).cross(p - from).dot(normal) >= -NEAR;
            left(a, b) && left(b, c) && left(c, a)
        };
        for axis in 0..3 {
            for (u, v) in [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)] {
                let mut edge = DVec3::ZERO;
                edge[(axis + 1) % 3] = u;
                edge[(axis + 2) % 3] = v;
                edge[axis] = (a - edge).dot(normal) / normal[axis];
                corners.extend(is_inside(edge).then_some(edge));
            }
        }
        corners.retain(|p| p.min_element() >= -NEAR && p.max_element() <= 1.0 + NEAR);
        corners
    }

    #[test]
    fn the_box_holds_the_part_inside_and_nothing_more() {
        let mut random = Stream::new(4, 0, 0);
        let mut corner = || Vec3::from_array([(); 3].map(|()| 3.0 * random.uniform() - 1.0));
        let mut boxes = 0;
        for _ in 0..5000 {
            let triangle = Triangle::new(corner(), corner(), corner());
            let corners: Vec<Vec3> = corners_of_part(&triangle).iter().map(|p| p.as_vec3()).collect();
            let (expected, found) = (Aabb::around(&corners), clip(&triangle, &CELL));
            assert_eq!(expected.is_some(), found.is_some(), "{triangle:?}");
            if let Some((expected, found)) = expected.zip(found) {
                let off = (expected.min - found.min).abs().max((expected.max - found.max).abs()).max_element();
                assert!(off < 1e-6, "{triangle:?}: {found:?} instead of {expected:?}");
                boxes += 1;
            }
        }
        assert!(boxes > 1000);
    }

    #[test]
    fn eight_octants_are_clipped_as_one_by_one() {
        let mut random = Stream::new(5, 0, 0);
        let mut corner = || Vec3::from_array([(); 3].map(|()| 3.0 * random.uniform() - 1.0));
        let middle = CELL.center();
        for _ in 0..2000 {
            let triangle = Triangle::new(corner(), corner(), corner());
            let parts = clip_to_octants(&triangle, &CELL, middle);
            for (i, part) in parts.into_iter().enumerate() {
                let alone = clip(&triangle, &crate::primitives::octant(&CELL, middle, i));
                assert_eq!(part.is_some(), alone.is_some(), "octant {i} of {triangle:?}");
                if let Some((part, alone)) = part.zip(alone) {
                    let off = (part.min - alone.min).abs().max((part.max - alone.max).abs()).max_element();
                    assert!(off < 1e-6, "octant {i} of {triangle:?}");
                }
            }
        }
    }
}
