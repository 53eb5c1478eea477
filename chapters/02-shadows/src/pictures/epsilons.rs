//! Three offsets side by side.

use common::{
    Error,
    film::Size,
    picture::{ORBIT, Panels, Picture, Render, Settings},
};

use super::table::table;
use crate::offset::Offset;

/// An offset higher than the table, in scene units.
const FAR_TOO_GREAT: f32 = 0.48;

pub(super) const PICTURE: Picture = Picture {
    name: "epsilons",
    alt: "The table with the ball, the cone and the five smaller balls, three times. Left, with no offset, everything lit \
          is speckled with acne. Middle, with the right offset, shadows are clean and touch the things that cast them. \
          Right, with an offset higher than the table, the floor below the table is lit, the small balls have no \
          shadow, and what shadows are left have moved away from their things.",
    knobs: &ORBIT,
    size: Size::of::<960, 240>(),
    samples: 8,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let view = |offset| -> Result<Box<dyn Render>, Error> { Ok(Box::new(table(1.0, offset, settings)?)) };
    let offsets = [Offset::Fixed(0.0), Offset::Following, Offset::Fixed(FAR_TOO_GREAT)];
    Ok(Box::new(Panels::new(3, offsets.into_iter().map(view).collect::<Result<_, _>>()?)))
}
