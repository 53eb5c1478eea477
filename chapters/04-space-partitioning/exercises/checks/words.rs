//! How messages put rays, boxes and what was found.

use ray_casting::{aabb::Aabb, ray::Ray};
use space_partitioning::query::Found;

pub(crate) use common::exercise::words::{number, range, triple};

/// A ray.
pub(crate) fn ray(ray: &Ray) -> String {
    format!("the ray from {} in direction {}", triple(ray.origin), triple(ray.direction))
}

/// A box.
pub(crate) fn aabb(aabb: &Aabb) -> String {
    format!("the box from {} to {}", triple(aabb.min), triple(aabb.max))
}

/// What was hit.
pub(crate) fn found(found: Option<Found>) -> String {
    match found {
        Some(Found { number, t }) => format!("primitive {number} at t = {t}"),
        None => "nothing".into(),
    }
}

/// So many things of a kind: `no nodes`, `1 node`, `2 nodes`.
pub(crate) fn counted(count: usize, kind: &str) -> String {
    match count {
        0 => format!("no {kind}s"),
        1 => format!("1 {kind}"),
        _ => format!("{count} {kind}s"),
    }
}

/// Numbers of primitives, not too many of them.
pub(crate) fn numbers(numbers: &[u32]) -> String {
    const MOST: usize = 24;
    let mut words: Vec<_> = numbers.iter().take(MOST).map(ToString::to_string).collect();
    if numbers.len() > MOST {
        words.push(format!("and {} more", numbers.len() - MOST));
    }
    if words.is_empty() { "none".into() } else { words.join(", ") }
}
