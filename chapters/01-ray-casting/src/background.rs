//! The background: what a ray sees that hits nothing.

use common::{Rgb, Vec3};

// ANCHOR: background
/// The surroundings of a scene, infinitely far away.
pub trait Background: Send + Sync {
    /// The radiance that comes from the direction in which a ray leaves. The direction may have any length but zero.
    fn radiance(&self, direction: Vec3) -> Rgb;
}

/// One color is a background too: the same in all directions.
impl Background for Rgb {
    fn radiance(&self, _direction: Vec3) -> Rgb {
        *self
    }
}
// ANCHOR_END: background

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_color_is_the_same_everywhere() {
        let dusk = Rgb::new(0.1, 0.2, 0.4);
        assert_eq!((dusk.radiance(Vec3::X), dusk.radiance(-Vec3::Y * 9.0)), (dusk, dusk));
    }
}
