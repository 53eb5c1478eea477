//! The field: a lawn mown in stripes, with its lines, and a running track around.

use common::{Vec3, color::srgb, float};
use ray_casting::material::Phong;

use super::super::{
    budget::{number, share},
    builder::Builder,
};

/// Half the length and half the width of the field, in meters.
const HALF: (f32, f32) = (52.5, 34.0);
/// Width of a white line.
const LINE: f32 = 0.12;
/// Radius of the circle in the middle.
const CIRCLE: f32 = 9.15;
/// How high the lines lie above the lawn, that both are seen.
const PAINT: f32 = 0.004;

/// Track, lawn and lines, for a stadium of so many triangles.
pub(super) fn field(builder: &mut Builder, triangles: u32) {
    builder.part("track", Phong::of(srgb(150, 78, 58), 0.0, 1.0));
    level(builder, -95.0, 95.0, -90.0, 90.0, -0.04);

    // Stripes across the field, of two greens.
    let stripes = number(triangles, 40, [2, 22]);
    for (name, color, parity) in [("lawn", srgb(64, 118, 48), 0), ("lawn, mown back", srgb(84, 140, 58), 1)] {
        builder.part(name, Phong::of(color, 0.0, 1.0));
        let at = |stripe: u32| HALF.0 * (2.0 * stripe as f32 / stripes as f32 - 1.0);
        for stripe in (0..stripes).filter(|stripe| stripe % 2 == parity) {
            level(builder, at(stripe), at(stripe + 1), -HALF.1, HALF.1, 0.0);
        }
    }

    builder.part("lines and goals", Phong::of(srgb(238, 240, 236), 0.1, 10.0));
    let half = LINE / 2.0;
    // The one under the teapot is cut where it is seen from near, since long thin triangles are met less precisely.
    for ends in [-HALF.1, -3.0, 3.0, HALF.1].windows(2) {
        level(builder, -half, half, ends[0], ends[1], PAINT);
    }
    if triangles > 300 {
        for side in [-1.0, 1.0] {
            level(builder, -HALF.0, HALF.0, side * HALF.1 - half, side * HALF.1 + half, PAINT);
            level(builder, side * HALF.0 - half, side * HALF.0 + half, -HALF.1, HALF.1, PAINT);
            goal(builder, side * HALF.0);
        }
        // The circle in the middle.
        let pieces = share(triangles, 0.02).clamp(12, 96);
        builder.surface(pieces, 1, |u, v| {
            let angle = std::f32::consts::TAU * u;
            let radius = CIRCLE + half - LINE * v;
            Vec3::new(radius * float::cos(angle), PAINT, -radius * float::sin(angle))
        });
    }
}

/// A level rectangle that is seen from above.
fn level(builder: &mut Builder, left: f32, right: f32, back: f32, front: f32, height: f32) {
    let corner = |x, z| Vec3::new(x, height, z);
    builder.quad([corner(left, front), corner(right, front), corner(right, back), corner(left, back)]);
}

/// The frame of a goal.
fn goal(builder: &mut Builder, x: f32) {
    let (half, height) = (3.66, 2.44);
    for z in [-half, half] {
        builder.beam(Vec3::new(x, 0.0, z), Vec3::new(x, height, z), LINE);
    }
    builder.beam(Vec3::new(x, height, -half), Vec3::new(x, height, half), LINE);
}
