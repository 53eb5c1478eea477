//! No partition, but eight triangles at once: what a processor does with one number it can do with several side by side.

use std::array;

use common::{Interval, Vec3};
use multiversion::multiversion;
use ray_casting::{
    aabb::Aabb,
    ray::Ray,
    triangle_barycentric::{Shear, area},
};

use crate::{
    primitives::Primitives as _,
    probe::Probe,
    query::{Query, Question},
    structure::{Cell, Contents, Partition, Structure, StructureError},
    triangles::{Numbered, Triangles},
};

/// One cell that lists everything, and looks at eight triangles at once.
#[derive(Clone, Debug)]
pub struct EightAtOnce {
    aabb: Option<Aabb>,
    list: Vec<Numbered>,
    /// The same triangles once more.
    blocks: Vec<Block>,
}

/// Some triangles: for each corner and each axis their coordinates, side by side in memory.
#[derive(Clone, Debug)]
struct Block([[[f32; BLOCK]; 3]; 3]);

/// So many triangles are looked at before the first of them is tested: as many as an `u32` has bits.
const BLOCK: usize = 32;

/// A shape of triangles that are all looked at, eight at once.
///
/// # Errors
/// [`StructureError`] if a triangle is not finite, or there are too many.
pub fn eight_at_once(triangles: Triangles) -> Result<Structure<Triangles, EightAtOnce>, StructureError> {
    let Contents { boxes, around } = Contents::of(&triangles)?;
    let list: Vec<_> = boxes.into_iter().map(|(number, _)| triangles.entry(number)).collect();
    let partition = EightAtOnce { aabb: around, blocks: list.chunks(BLOCK).map(Block::of).collect(), list };
    Ok(Structure { primitives: triangles, partition })
}

impl Block {
    /// Up to [`BLOCK`] triangles. Where there are fewer, coordinates are NaN.
    fn of(triangles: &[Numbered]) -> Self {
        let coordinate = |i: usize, corner: usize, axis: usize| {
            triangles.get(i).map_or(f32::NAN, |numbered| numbered.triangle().corners[corner][axis])
        };
        Self(array::from_fn(|corner| array::from_fn(|axis| array::from_fn(|i| coordinate(i, corner, axis)))))
    }
}

/// The bit that stands for each triangle of a block. A table, since not every processor shifts eight numbers at once.
const BITS: [u32; BLOCK] = {
    let mut bits = [1; BLOCK];
    let mut i = 1;
    while i < BLOCK {
        bits[i] = bits[i - 1] << 1;
        i += 1;
    }
    bits
};

// ANCHOR: may_be_hit
/// Which triangles of a block the ray may hit, one bit for each: it surely misses the others.
///
/// The loop does the same with each triangle, and has no branch. So the compiler makes it do eight of them at once, or
/// four on a processor that cannot do more. Each number is computed as ever, so the bits are the same everywhere.
#[multiversion(targets("x86_64+avx+avx2"))]
fn may_be_hit(block: &Block, along: &Shear, range: Interval) -> u32 {
    let axes = along.axes();
    let [a, b, c] = [in_order(&block.0[0], axes), in_order(&block.0[1], axes), in_order(&block.0[2], axes)];
    let origin = axes.map(|axis| along.origin[axis]);
    let mut bits = 0;
    for (i, bit) in BITS.into_iter().enumerate() {
        let [a, b, c] =
            [view(a, i, origin, along.slope), view(b, i, origin, along.slope), view(c, i, origin, along.slope)];
        // The ray passes by where two weights differ in sign.
        let [least, most] = extremes(area(c, b), area(a, c), area(b, a));
        let passes_by = (least < 0.0) & (most > 0.0);
        // A hit lies between the nearest corner and the farthest, along the ray.
        let [nearest, farthest] = extremes(a.z, b.z, c.z);
        let is_beyond = (nearest > range.max) | (farthest < range.min);
        bits |= if passes_by | is_beyond { 0 } else { bit };
    }
    bits
}
// ANCHOR_END: may_be_hit

/// Coordinates of points, one list for each axis, in another order of the axes.
#[inline(always)]
fn in_order(points: &[[f32; BLOCK]; 3], axes: [usize; 3]) -> [&[f32; BLOCK]; 3] {
    [&points[axes[0]], &points[axes[1]], &points[axes[2]]]
}

/// The point of that index as it looks along the ray: as [`Shear::view`], with the axes in order already.
#[inline(always)]
fn view(points: [&[f32; BLOCK]; 3], i: usize, origin: [f32; 3], slope: Vec3) -> Vec3 {
    let [x, y, z] = [points[0][i] - origin[0], points[1][i] - origin[1], points[2][i] - origin[2]];
    Vec3::new(x - slope.x * z, y - slope.y * z, slope.z * z)
}

/// The least and the greatest of three numbers. `f32::min` and `max` would look for NaN as well.
#[inline(always)]
fn extremes(a: f32, b: f32, c: f32) -> [f32; 2] {
    let less = |a: f32, b: f32| if a < b { a } else { b };
    let more = |a: f32, b: f32| if a > b { a } else { b };
    [less(less(a, b), c), more(more(a, b), c)]
}

impl Partition<Triangles> for EightAtOnce {
    fn walk<Q: Question, N: Probe>(&self, _ray: &Ray, query: &mut Query<'_, Triangles, Q, N>) {
        query.visit(0);
        for (block, list) in self.blocks.iter().zip(self.list.chunks(BLOCK)) {
            let mut candidates = may_be_hit(block, query.view(), query.range());
            // Test those that are left, from the lowest bit up. The last block may not be full.
            while let Some(candidate) = list.get(candidates.trailing_zeros() as usize) {
                candidates &= candidates - 1;
                if query.test_likely(candidate) {
                    return;
                }
            }
        }
    }

    fn aabb(&self) -> Option<Aabb> {
        self.aabb
    }

    fn cells(&self) -> Vec<Cell<'_, Numbered>> {
        self.aabb.into_iter().map(|aabb| Cell { number: 0, aabb, list: &self.list }).collect()
    }

    fn bytes(&self) -> usize {
        size_of_val(self.list.as_slice()) + size_of_val(self.blocks.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use common::{Stream, Vec3};
    use ray_casting::triangle::Triangle;

    use super::*;

    /// A point of the cube from −1 to 1, some of them in a plane through the middle.
    fn point(random: &mut Stream) -> Vec3 {
        let coordinates = [(); 3].map(|()| random.uniform() * 2.0 - 1.0);
        if random.uniform() < 0.2 {
            Vec3::from_array(coordinates) * Vec3::new(1.0, 0.0, 1.0)
        } else {
            coordinates.into()
        }
    }

    #[test]
    fn what_is_hit_is_never_left_out() {
        let random = &mut Stream::new(5, 0, 0);
        let (mut hits, mut candidates) = (0, 0);
        for _ in 0..20_000 {
            // Each triangle in another lane, and a ray toward a point of one of them, or beside.
            let triangles = [(); 3].map(|()| Triangle::new(point(random), point(random), point(random)));
            let block = Block::of(&triangles.map(|triangle| Numbered::new(triangle, 0)));
            let [a, b, c] = triangles[0].corners;
            let to = if random.uniform() < 0.5 { a.lerp(b, random.uniform()) } else { (a + b + c) / 3.0 };
            let origin = point(random);
            let ray = Ray::new(origin, to - origin);
            let range = Interval::new(0.0, random.uniform() * 4.0);
            let shear = Shear::along(&ray);
            let bits = may_be_hit(&block, &shear, range);
            for (lane, triangle) in triangles.iter().enumerate() {
                let is_hit = triangle.hit_by_barycentric(&shear, range).is_some();
                assert!(!is_hit || bits >> lane & 1 == 1, "lane {lane} of {triangles:?} by {ray:?} in {range:?}");
                hits += u32::from(is_hit);
                candidates += bits >> lane & 1;
            }
        }
        // Nearly all that are left are hit.
        assert!(hits > 5_000 && candidates < hits * 3 / 2, "{hits} of {candidates}");
    }
}
