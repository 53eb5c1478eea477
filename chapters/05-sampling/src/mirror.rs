//! A mirror: the choice of a direction where there is none to choose.

use common::Vec3;
use whitted::reflection::reflect;

use crate::direction_sample::{Density, DirectionSample};

// ANCHOR: mirror
/// The one direction from which a mirror with the unit normal `normal` shows light to a viewer in direction
/// `to_viewer`, a unit vector. It is taken with probability 1.
#[must_use]
pub fn sample_mirror(normal: Vec3, to_viewer: Vec3) -> DirectionSample {
    DirectionSample { direction: reflect(-to_viewer, normal), density: Density::Discrete(1.0) }
}
// ANCHOR_END: mirror

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mirror_direction_is_certain() {
        let sample = sample_mirror(Vec3::Y, Vec3::new(0.6, 0.8, 0.0));
        assert_eq!(sample.direction, Vec3::new(-0.6, 0.8, 0.0));
        assert_eq!((sample.density.weight(), sample.density.per_steradian()), (1.0, None));
    }
}
