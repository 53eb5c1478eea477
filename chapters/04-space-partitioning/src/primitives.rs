//! Primitives: what a structure holds, many things that a ray can hit, each known by its number.

use common::{Interval, Vec3};
use ray_casting::{aabb::Aabb, hit::Hit, ray::Ray, shape::Shape};

// ANCHOR: primitives
/// Many things that a ray can hit, each with a box around it. Structures are made of them.
pub trait Primitives: Send + Sync {
    /// What is computed once for a ray, before it meets any of them.
    type View;
    /// What the list of a cell holds of each of them: its number, or all that a test needs, in one place in memory.
    type Entry: Copy + Send + Sync;

    /// How many there are. They have the numbers from 0 up.
    fn count(&self) -> u32;

    /// The box around one of them.
    fn aabb(&self, number: u32) -> Aabb;

    /// The box around the part of one of them that lies inside a cell; `None` if no part does. It lies inside the cell.
    fn clipped(&self, number: u32, cell: &Aabb) -> Option<Aabb> {
        overlap(&self.aabb(number), cell)
    }

    /// The boxes around the parts of one of them inside the eight octants of a cell around its middle.
    fn octants(&self, number: u32, cell: &Aabb, middle: Vec3) -> [Option<Aabb>; 8] {
        std::array::from_fn(|i| self.clipped(number, &octant(cell, middle, i)))
    }

    /// What a list holds of one of them.
    fn entry(&self, number: u32) -> Self::Entry;

    /// The number of an entry.
    fn number(&self, entry: &Self::Entry) -> u32;

    /// Prepare a ray.
    fn view(&self, ray: &Ray) -> Self::View;

    /// The `t` inside `range` at which a ray first hits one of them.
    fn intersect(&self, entry: &Self::Entry, view: &Self::View, range: Interval) -> Option<f32>;

    /// All that is known about the hit that [`Primitives::intersect`] found at `t`.
    fn hit(&self, number: u32, ray: &Ray, t: f32) -> Option<Hit>;
}
// ANCHOR_END: primitives

/// The box that two boxes have in common.
#[must_use]
#[inline]
pub fn overlap(a: &Aabb, b: &Aabb) -> Option<Aabb> {
    let common = Aabb { min: a.min.max(b.min), max: a.max.min(b.max) };
    common.min.cmple(common.max).all().then_some(common)
}

// ANCHOR: octant
/// One of the eight parts of a cell. Bit 0 of its number says whether it lies in the upper half along x, bits 1 and 2
/// say the same for y and z.
#[must_use]
#[inline]
pub fn octant(cell: &Aabb, middle: Vec3, number: usize) -> Aabb {
    let along = |lower: Vec3, upper: Vec3| {
        Vec3::from_array([0, 1, 2].map(|axis| if number >> axis & 1 == 1 { upper[axis] } else { lower[axis] }))
    };
    Aabb { min: along(cell.min, middle), max: along(middle, cell.max) }
}
// ANCHOR_END: octant

// ANCHOR: bounded
/// A shape that knows a box around itself.
pub trait Bounded: Shape {
    /// The box.
    fn aabb(&self) -> Aabb;
}

/// A list of such shapes is a set of primitives: spheres, other structures, anything.
impl<S: Bounded> Primitives for Vec<S> {
    type View = Ray;
    type Entry = u32;

    #[expect(clippy::cast_possible_truncation, reason = "structures refuse more")]
    fn count(&self) -> u32 {
        self.len() as u32
    }

    fn aabb(&self, number: u32) -> Aabb {
        self[number as usize].aabb()
    }

    fn entry(&self, number: u32) -> u32 {
        number
    }

    fn number(&self, entry: &u32) -> u32 {
        *entry
    }

    fn view(&self, ray: &Ray) -> Ray {
        *ray
    }

    fn intersect(&self, entry: &u32, ray: &Ray, range: Interval) -> Option<f32> {
        self[*entry as usize].intersect(ray, range).map(|hit| hit.t)
    }

    fn hit(&self, number: u32, ray: &Ray, t: f32) -> Option<Hit> {
        self[number as usize].intersect(ray, Interval::new(t.next_down(), t.next_up()))
    }
}
// ANCHOR_END: bounded
