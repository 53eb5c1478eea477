//! How messages put hits and colors.

use common::{Rgb, Vec3};
use ray_casting::hit::{Hit, Side};

pub(crate) use common::exercise::words::{number, rounded, triple};

/// A hit, as far as a student needs it to try it again.
pub(crate) fn hit(hit: &Hit) -> String {
    format!("a hit at {}, geometric normal {}, {}", triple(hit.position), triple(hit.geometric_normal), side(hit.side))
}

/// A side of a surface.
pub(crate) fn side(side: Side) -> &'static str {
    match side {
        Side::Outside => "Side::Outside",
        Side::Inside => "Side::Inside",
    }
}

/// A color or a vector, with as many digits as are worth comparing.
pub(crate) fn color(color: Rgb) -> String {
    rounded(color.as_dvec3())
}

/// Whether two colors differ by no more than a share of the greater one, and by rounding. False for what is no number.
pub(crate) fn is_near(a: Rgb, b: Rgb, share: f32) -> bool {
    let slack = (a.abs().max(b.abs()) * share).max(Vec3::splat(1e-6));
    a == b || (a - b).abs().cmple(slack).all()
}
