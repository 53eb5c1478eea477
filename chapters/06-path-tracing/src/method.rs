//! The method: how paths are chosen, each idea of the chapter a knob of its own.

use std::ops::RangeInclusive;

use sampling::sky_light::Choice;
use whitted::material::Fresnel;

// ANCHOR: method
/// How paths are chosen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Method {
    /// Which directions are followed.
    pub choice: Choice,
    /// Whether the abstract lights are asked at every hit. Without that they give no light at all.
    pub direct: bool,
    /// Whether chance may end a path. Without that only the greatest number of bounces does, and a picture whose paths
    /// are cut off is too dark.
    pub roulette: bool,
    /// Which formula says how much is mirrored.
    pub fresnel: Fresnel,
    /// Which light is shown, by how often it was reflected between its source and the eye: 0 is what sources send
    /// straight to the eye, 1 is reflected once, as in chapters 1 and 2.
    pub bounces: RangeInclusive<u32>,
}
// ANCHOR_END: method

impl Method {
    /// No path is ever longer. Roulette ends all but one in 10⁴ of those that see nothing but an albedo of 0.99.
    pub const MOST_BOUNCES: u32 = 1000;
    /// The random walk in its plainest form.
    pub const PLAIN: Self = Self {
        choice: Choice::Uniform,
        direct: false,
        roulette: false,
        fresnel: Fresnel::Exact,
        bounces: 0..=Self::MOST_BOUNCES,
    };
    /// Everything that makes it better.
    pub const BEST: Self = Self { choice: Choice::CosineAndMirror, direct: true, roulette: true, ..Self::PLAIN };
}
