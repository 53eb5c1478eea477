//! The offset: a ray that leaves a surface starts a little above it, so that it does not hit it at once.

use common::Vec3;
use ray_casting::hit::Hit;

// ANCHOR: offset
/// How far above a surface a new ray starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Offset {
    /// The same distance everywhere, in scene units.
    Fixed(f32),
    /// A small part of the greatest number that went into computing the hit.
    Following,
    /// A few steps of each coordinate's own precision.
    Bits,
}
// ANCHOR_END: offset

impl Offset {
    // ANCHOR: origin
    /// Where a ray starts that leaves `hit` toward the side to which the unit vector `normal` points.
    #[must_use]
    #[inline]
    pub fn origin(self, hit: &Hit, normal: Vec3) -> Vec3 {
        match self {
            Offset::Fixed(epsilon) => hit.position + normal * epsilon,
            Offset::Following => hit.position + normal * (hit.magnitude * FOLLOWING),
            Offset::Bits => offset_by_bits(hit.position, normal),
        }
    }
    // ANCHOR_END: origin
}

// ANCHOR: following
/// The offset that follows, as a share of the hit's magnitude: 16 times the distance from 1 to the next f32.
pub const FOLLOWING: f32 = 16.0 * f32::EPSILON;
// ANCHOR_END: following

// ANCHOR: bits
/// Each coordinate moved by up to 256 of its own smallest steps; near zero, by up to 1/65536 scene units.
///
/// Source: Wächter, Binder, *A Fast and Robust Method for Avoiding Self-Intersection*, Ray Tracing Gems chapter 6, 2019.
fn offset_by_bits(position: Vec3, normal: Vec3) -> Vec3 {
    let moved = |p: f32, n: f32| {
        if p.abs() < 1.0 / 32.0 {
            return p + n / 65536.0;
        }
        #[expect(clippy::cast_possible_truncation, reason = "at most 256")]
        let steps = (256.0 * n) as i32;
        // The bits of a float, read as a whole number, grow by one from each float to the next larger in size.
        let steps = if p < 0.0 { -steps } else { steps };
        f32::from_bits(p.to_bits().wrapping_add_signed(steps))
    };
    Vec3::new(moved(position.x, normal.x), moved(position.y, normal.y), moved(position.z, normal.z))
}
// ANCHOR_END: bits
