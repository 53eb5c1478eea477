//! How messages put things: what was tried in full, so that a student can type it off, and what came out and what was
//! expected with equally many digits, so that rounding does not look like a mistake.

use common::{Interval, Vec3};
use glam::DVec3;
use ray_casting::{
    hit::{Hit, Side},
    ray::Ray,
};

use super::crossing::Crossing;

/// A point, a vector or a color.
pub(crate) fn triple(v: Vec3) -> String {
    // Adding zero turns −0 into 0.
    let [x, y, z] = (v + 0.0).to_array();
    format!("({x}, {y}, {z})")
}

/// The same of an f64, rounded to what an f32 could tell.
pub(crate) fn rounded(v: DVec3) -> String {
    let [x, y, z] = v.to_array().map(number);
    format!("({x}, {y}, {z})")
}

/// A number with six digits behind the point, without zeros at the end.
pub(crate) fn number(x: f64) -> String {
    let text = format!("{x:.6}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".into() } else { short.into() }
}

/// A ray.
pub(crate) fn ray(ray: &Ray) -> String {
    format!("the ray from {} in direction {}", triple(ray.origin), triple(ray.direction))
}

/// A range of ray parameters.
pub(crate) fn range(range: Interval) -> String {
    let end = |t: f32| match t {
        f32::INFINITY => "∞".into(),
        f32::NEG_INFINITY => "−∞".into(),
        t => t.to_string(),
    };
    format!("range {} < t < {}", end(range.min), end(range.max))
}

/// What an answer says about a ray.
pub(crate) fn answer(answer: Option<Hit>) -> String {
    answer.map_or("no hit".into(), |hit| {
        format!(
            "a hit at t = {}, position {}, normal {}, {}",
            number(f64::from(hit.t)),
            rounded(hit.position.as_dvec3()),
            rounded(hit.geometric_normal.as_dvec3()),
            side(hit.side)
        )
    })
}

/// What an answer should have said about a ray.
pub(crate) fn crossing(expected: Option<Crossing>, ray: &Ray) -> String {
    expected.map_or("no hit".into(), |c| {
        let (t, normal) = (number(c.t), rounded(c.normal(ray)));
        format!("a hit at t = {t} ({}), normal {normal}, {}", c.part, side(c.side(ray)))
    })
}

/// A side of a surface.
pub(crate) fn side(side: Side) -> &'static str {
    match side {
        Side::Outside => "Side::Outside",
        Side::Inside => "Side::Inside",
    }
}
