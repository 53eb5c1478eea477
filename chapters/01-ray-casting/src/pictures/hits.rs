//! What a hit knows: how far, and on which side.

use common::{
    Error, Rgb,
    film::Size,
    picture::{ORBIT, Picture, Render, Settings},
};

use super::by_hit::still_life_by;
use crate::hit::{Hit, Side};

pub(super) const PICTURE: Picture = Picture {
    name: "hits",
    alt: "The still life drawn by what each hit knows: blue where a ray met the outside of a surface, orange where it \
          met the inside, as in the open tube, the bowl and the vase; darker the farther away.",
    knobs: &ORBIT,
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    still_life_by(side_and_distance, settings)
}

// ANCHOR: hits
/// Blue outside, orange inside; the farther, the darker.
fn side_and_distance(hit: &Hit) -> Rgb {
    /// Distances at which the color is full and at which it is gone, in scene units.
    const FADE: [f32; 2] = [7.0, 12.0];
    let color = match hit.side {
        Side::Outside => Rgb::new(0.19, 0.43, 0.83),
        Side::Inside => Rgb::new(1.0, 0.3, 0.045),
    };
    color * ((FADE[1] - hit.t) / (FADE[1] - FADE[0])).clamp(0.0, 1.0)
}
// ANCHOR_END: hits
