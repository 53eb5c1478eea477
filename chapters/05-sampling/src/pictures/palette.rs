//! The colors of the chapter, the same in all its drawings.

use common::{
    Rgb,
    color::{gradient, srgb},
};

/// Regular samples, and uniform directions: blue.
pub(super) const BLUE: Rgb = Rgb::new(0.15, 0.56, 1.0);
/// Random samples: gold.
pub(super) const GOLD: Rgb = Rgb::new(1.0, 0.56, 0.08);
/// Directions in proportion to the cosine: green.
pub(super) const GREEN: Rgb = Rgb::new(0.25, 0.75, 0.35);
/// What is wrong: red.
pub(super) const RED: Rgb = Rgb::new(0.86, 0.09, 0.07);

/// From violet over red and gold to pale yellow, evenly brighter, for a number from 0 to 1.
pub(super) fn ramp(share: f32) -> Rgb {
    let colors = [
        srgb(50, 46, 112),
        srgb(98, 42, 122),
        srgb(160, 48, 104),
        srgb(222, 84, 72),
        srgb(248, 154, 64),
        srgb(252, 234, 150),
    ];
    gradient(&colors, share)
}
