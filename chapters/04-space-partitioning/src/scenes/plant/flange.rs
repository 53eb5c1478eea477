//! Flanges: where two pieces of a pipe are bolted together.

use common::{Basis, Vec2, Vec3, float};

use super::super::builder::Builder;

/// Number of bolts of a flange that has any.
const BOLTS: u32 = 8;

/// Two discs around a pipe of that radius, with bolts through them or not.
pub(super) fn flange(builder: &mut Builder, center: Vec3, axis: Vec3, radius: f32, sides: u32, bolts: bool) {
    let (out, half) = (radius * 1.6, radius * 0.22);
    let profile = [(radius, -half), (out, -half), (out, -half), (out, half), (out, half), (radius, half)]
        .map(|(x, y)| Vec2::new(x, y));
    builder.turned_around(center, axis, &profile, sides);
    if bolts {
        let basis = Basis::around(axis);
        for bolt in 0..BOLTS {
            let angle = std::f32::consts::TAU * bolt as f32 / BOLTS as f32;
            let place = (basis.tangent * float::cos(angle) + basis.bitangent * float::sin(angle)) * (radius * 1.32);
            let along = axis * (half * 1.9);
            builder.beam(center + place - along, center + place + along, radius * 0.22);
        }
    }
}
