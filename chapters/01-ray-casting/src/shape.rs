//! The shape: anything that a ray can hit.

use std::sync::Arc;

use common::Interval;

use crate::{hit::Hit, ray::Ray};

// ANCHOR: shape
/// Anything that a ray can hit. It knows neither materials nor lights nor other shapes.
pub trait Shape: Send + Sync {
    /// The nearest hit whose `t` lies inside the open interval `range`.
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit>;

    // ANCHOR: occluded
    /// Whether there is any hit at all inside `range`: the question of a shadow ray (chapter 2).
    ///
    /// A shape made of many parts may stop at the first of them that is hit.
    fn occluded(&self, ray: &Ray, range: Interval) -> bool {
        self.intersect(ray, range).is_some()
    }
    // ANCHOR_END: occluded
}
// ANCHOR_END: shape

/// A shape behind a pointer is a shape: one that is stored on the heap, ...
impl<S: Shape + ?Sized> Shape for Box<S> {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        (**self).intersect(ray, range)
    }

    fn occluded(&self, ray: &Ray, range: Interval) -> bool {
        (**self).occluded(ray, range)
    }
}

/// ... and one that stands in several places at once.
impl<S: Shape + ?Sized> Shape for Arc<S> {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        (**self).intersect(ray, range)
    }

    fn occluded(&self, ray: &Ray, range: Interval) -> bool {
        (**self).occluded(ray, range)
    }
}
