//! How messages put rays and hits.

use ray_casting::{
    hit::{Hit, Side},
    ray::Ray,
};

pub(crate) use common::exercise::words::{number, range, rounded, triple};

use super::crossing::Crossing;

/// A ray.
pub(crate) fn ray(ray: &Ray) -> String {
    format!("the ray from {} in direction {}", triple(ray.origin), triple(ray.direction))
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
