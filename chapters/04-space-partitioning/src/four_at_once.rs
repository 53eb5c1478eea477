//! No partition, but four triangles at once: what a processor does with one number it can do with four side by side.

use std::array;

use common::Interval;
use ray_casting::{aabb::Aabb, ray::Ray, triangle_barycentric::Shear};
use wide::{CmpGt as _, CmpLt as _, f32x4};

use crate::{
    primitives::Primitives as _,
    probe::Probe,
    query::{Query, Question},
    structure::{Cell, Contents, Partition, Structure, StructureError},
    triangles::{Numbered, Triangles},
};

/// One cell that lists everything, and looks at four triangles at once.
#[derive(Clone, Debug)]
pub struct FourAtOnce {
    aabb: Option<Aabb>,
    list: Vec<Numbered>,
    /// The same triangles once more, [`BLOCK`] by [`BLOCK`].
    blocks: Vec<[Four; BLOCK / 4]>,
}

/// Four triangles: for each corner and each axis four coordinates side by side, one in each lane.
#[derive(Clone, Copy, Debug)]
struct Four([[f32x4; 3]; 3]);

/// So many triangles are looked at before the first of them is tested: as many as an `u32` has bits.
const BLOCK: usize = 32;

/// A shape of triangles that are all looked at, four at once.
///
/// # Errors
/// [`StructureError`] if a triangle is not finite, or there are too many.
pub fn four_at_once(triangles: Triangles) -> Result<Structure<Triangles, FourAtOnce>, StructureError> {
    let Contents { boxes, around } = Contents::of(&triangles)?;
    let list: Vec<_> = boxes.into_iter().map(|(number, _)| triangles.entry(number)).collect();
    let blocks = list.chunks(BLOCK).map(|block| array::from_fn(|i| Four::of(&block[block.len().min(4 * i)..])));
    let partition = FourAtOnce { aabb: around, blocks: blocks.collect(), list };
    Ok(Structure { primitives: triangles, partition })
}

/// The view along one ray, the same in each lane.
struct View {
    axes: [usize; 3],
    origin: [f32x4; 3],
    slope: [f32x4; 3],
}

impl View {
    fn of(shear: &Shear) -> Self {
        let axes = shear.axes();
        let origin = axes.map(|axis| f32x4::splat(shear.origin.to_array()[axis]));
        Self { axes, origin, slope: shear.slope.to_array().map(f32x4::splat) }
    }

    /// Four points as they look along the ray: as [`Shear::view`].
    #[inline(always)]
    fn view(&self, points: &[f32x4; 3]) -> [f32x4; 3] {
        let [x, y, z] = array::from_fn(|i| points[self.axes[i]] - self.origin[i]);
        [x - self.slope[0] * z, y - self.slope[1] * z, self.slope[2] * z]
    }
}

impl Four {
    /// The first four of some triangles. Where there are fewer, the other lanes hold no number.
    fn of(triangles: &[Numbered]) -> Self {
        let coordinate = |lane: usize, corner: usize, axis: usize| {
            triangles.get(lane).map_or(f32::NAN, |numbered| numbered.triangle().corners[corner][axis])
        };
        Self(array::from_fn(|corner| {
            array::from_fn(|axis| f32x4::from(array::from_fn::<f32, 4, _>(|lane| coordinate(lane, corner, axis))))
        }))
    }

    // ANCHOR: may_be_hit
    /// Which of the four the ray may hit, one bit for each: it surely misses the others.
    #[inline(always)]
    fn may_be_hit(&self, along: &View, range: Interval) -> u32 {
        let [a, b, c] = array::from_fn(|corner| along.view(&self.0[corner]));
        // The ray passes by where two weights differ in sign.
        let area = |p: &[f32x4; 3], q: &[f32x4; 3]| p[0] * q[1] - p[1] * q[0];
        let [u, v, w] = [area(&c, &b), area(&a, &c), area(&b, &a)];
        let zero = f32x4::ZERO;
        let passes_by = u.fast_min(v).fast_min(w).cmp_lt(zero) & u.fast_max(v).fast_max(w).cmp_gt(zero);
        // A hit lies between the nearest corner and the farthest, along the ray.
        let [nearest, farthest] = [a[2].fast_min(b[2]).fast_min(c[2]), a[2].fast_max(b[2]).fast_max(c[2])];
        let is_beyond = nearest.cmp_gt(f32x4::splat(range.max)) | farthest.cmp_lt(f32x4::splat(range.min));
        !(passes_by | is_beyond).move_mask().cast_unsigned() & 0b1111
    }
    // ANCHOR_END: may_be_hit
}

impl Partition<Triangles> for FourAtOnce {
    fn walk<Q: Question, N: Probe>(&self, _ray: &Ray, query: &mut Query<'_, Triangles, Q, N>) {
        query.visit(0);
        let along = View::of(query.view());
        for (fours, list) in self.blocks.iter().zip(self.list.chunks(BLOCK)) {
            let range = query.range();
            let mut candidates = 0;
            for (i, four) in fours.iter().enumerate() {
                candidates |= four.may_be_hit(&along, range) << (4 * i);
            }
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
            let four = Four::of(&triangles.map(|triangle| Numbered::new(triangle, 0)));
            let [a, b, c] = triangles[0].corners;
            let to = if random.uniform() < 0.5 { a.lerp(b, random.uniform()) } else { (a + b + c) / 3.0 };
            let origin = point(random);
            let ray = Ray::new(origin, to - origin);
            let range = Interval::new(0.0, random.uniform() * 4.0);
            let shear = Shear::along(&ray);
            let bits = four.may_be_hit(&View::of(&shear), range);
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
