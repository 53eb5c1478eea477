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
#[derive(Clone, Copy)]
struct Polygon {
    corners: [DVec3; MOST_CORNERS],
    count: usize,
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
                polygon = polygon.halves(axis, cell.min[axis])[1];
            }
            if max[axis] > cell.max[axis] {
                polygon = polygon.halves(axis, cell.max[axis])[0];
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

    // ANCHOR: halves
    /// The parts below and above the plane `axis = position`. Corners in the plane belong to both.
    fn halves(&self, axis: usize, position: f32) -> [Self; 2] {
        let [mut below, mut above] = [Self::EMPTY; 2];
        let height = |corner: DVec3| corner[axis] - f64::from(position);
        let Some(&last) = self.corners().last() else { return [below, above] };
        let (mut from, mut from_height) = (last, height(last));
        for &to in self.corners() {
            let to_height = height(to);
            // An edge that changes sides has a new corner in the plane.
            if from_height < 0.0 && to_height > 0.0 || from_height > 0.0 && to_height < 0.0 {
                let mut corner = from + (to - from) * (from_height / (from_height - to_height));
                corner[axis] = f64::from(position);
                below.push(corner);
                above.push(corner);
            }
            if to_height <= 0.0 {
                below.push(to);
            }
            if to_height >= 0.0 {
                above.push(to);
            }
            (from, from_height) = (to, to_height);
        }
        [below, above]
    }
    // ANCHOR_END: halves

    /// The box around it, rounded outward; `None` if it has no corner.
    fn aabb(&self) -> Option<Aabb> {
        let (first, others) = self.corners().split_first()?;
        let (low, high) = others.iter().fold((*first, *first), |(low, high), c| (low.min(*c), high.max(*c)));
        let min = Vec3::from_array(low.to_array().map(down));
        Some(Aabb { min, max: Vec3::from_array(high.to_array().map(up)) })
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
    let reaches_down = part.corners().iter().any(|corner| corner[axis] < plane);
    let reaches_up = part.corners().iter().any(|corner| corner[axis] > plane);
    if reaches_down && reaches_up {
        let [below, above] = part.halves(axis, middle[axis]);
        share(&below, cell, middle, axis + 1, number, parts);
        share(&above, cell, middle, axis + 1, number | 1 << axis, parts);
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

    /// Points of random triangles: those inside the cell are inside the box, and no box without any point near it.
    #[test]
    fn the_box_holds_exactly_the_part_inside() {
        let mut random = Stream::new(4, 0, 0);
        let mut corner = || Vec3::from_array([(); 3].map(|()| 3.0 * random.uniform() - 1.0));
        for round in 0..500 {
            let triangle = Triangle::new(corner(), corner(), corner());
            let [a, b, c] = triangle.corners;
            const STEPS: u16 = 60;
            let points = (0..=STEPS).flat_map(|i| (0..=STEPS - i).map(move |j| (i, j))).map(|(i, j)| {
                let (u, v) = (f32::from(i) / f32::from(STEPS), f32::from(j) / f32::from(STEPS));
                a + (b - a) * u + (c - a) * v
            });
            let inside: Vec<_> = points.filter(|&p| CELL.contains(p)).collect();
            let Some(seen) = Aabb::around(&inside) else { continue };
            let aabb = clip(&triangle, &CELL).unwrap();
            let grown = |by: f32| Aabb { min: aabb.min - by, max: aabb.max + by };
            assert!(inside.iter().all(|&p| grown(1e-6).contains(p)), "round {round}");
            // The points lie at most this far apart, and so does the box from them.
            let gap = (b - a).length().max((c - a).length()) / f32::from(STEPS) * 2.0;
            assert!((seen.min - aabb.min).max_element() < gap && (aabb.max - seen.max).max_element() < gap);
        }
    }
}
