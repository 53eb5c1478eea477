//! One view and one fixed offset, from too small to too great.

use common::{
    Error,
    film::Size,
    knob::{Knob, Step},
    picture::{ORBIT, Picture, Render, Settings},
};

use super::table::table;
use crate::offset::Offset;

const EPSILON: Knob =
    Knob::number("epsilon", "how far above the surface shadow rays start", [0.0, 0.6], 0.0, "units", Step::Add(0.01));

pub(super) const PICTURE: Picture = Picture {
    name: "acne",
    alt: "A low table with a ball and a cone on it, and five smaller balls in front. All that should be lit is sprinkled \
          with dark specks: about every other shadow ray hits the very surface that it starts from.",
    knobs: &[EPSILON, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 540>(),
    samples: 4,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let epsilon = settings.values.number(&EPSILON);
    Ok(Box::new(table(1.0, Offset::Fixed(epsilon), settings)?))
}
