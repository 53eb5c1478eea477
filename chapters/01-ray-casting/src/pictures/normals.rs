//! Normals as colors.

use common::{
    Error, Rgb,
    film::Size,
    picture::{ORBIT, Picture, Render, Settings},
};

use super::by_hit::still_life_by;
use crate::hit::Hit;

pub(super) const PICTURE: Picture = Picture {
    name: "normals",
    alt: "The still life with each point colored by the direction of its normal: red grows to the right, green \
          upward, blue toward the viewer. The floor is one even green, round shapes blend through all colors, each \
          facet of the crystals has one color.",
    knobs: &ORBIT,
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    still_life_by(normal_as_color, settings)
}

// ANCHOR: normals
/// Coordinates run from −1 to 1, colors from 0 to 1. The square makes the steps look even on a screen.
fn normal_as_color(hit: &Hit) -> Rgb {
    let color = (hit.shading_normal + 1.0) / 2.0;
    color * color
}
// ANCHOR_END: normals
