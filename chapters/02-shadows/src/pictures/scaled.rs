//! One scene in three sizes, with a fixed offset and with one that follows the numbers.

use common::{
    Error,
    film::Size,
    knob::{Knob, Step},
    picture::{ORBIT, Panels, Picture, Render, Settings},
};

use super::table::table;
use crate::offset::Offset;

const EPSILON: Knob =
    Knob::number("epsilon", "the fixed offset of the upper row", [1e-8, 10.0], 1e-3, "units", Step::Times(2.0));

/// How many times as large as in the other pictures everything is.
const SCALES: [f32; 3] = [1e-3, 1.0, 1e4];

pub(super) const PICTURE: Picture = Picture {
    name: "scaled",
    alt: "The table and its things six times, in two rows of three. From left to right everything is a thousandth as \
          large, as it is, and ten thousand times as large; it should look the same. Upper row, with one fixed \
          offset: at the left most shadows are gone, in the middle all is well, at the right everything lit is \
          speckled with acne. Lower row, with the offset that follows the numbers: three equal, faultless pictures.",
    knobs: &[EPSILON, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 440>(),
    samples: 8,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let mut panels: Vec<Box<dyn Render>> = Vec::new();
    for offset in [Offset::Fixed(settings.values.number(&EPSILON)), Offset::Following] {
        for scale in SCALES {
            panels.push(Box::new(table(scale, offset, settings)?));
        }
    }
    Ok(Box::new(Panels::new(SCALES.len(), panels)))
}

#[cfg(test)]
mod tests {
    use common::{
        Stream, Vec2,
        picture::{FilmPoint, Integrator},
        story::Untold,
    };

    use super::*;
    use crate::direct_light::DirectLight;

    /// A power of two changes no digit of an f32, so nothing may change at all.
    #[test]
    fn with_the_following_offset_the_scale_makes_no_difference() {
        let view = |scale| table(scale, Offset::Following, &Settings::default()).unwrap();
        let [small, plain, large] = [1.0 / 1024.0, 1.0, 8192.0].map(view);
        let size = Vec2::new(48.0, 32.0);
        for (x, y) in (0_u8..32).flat_map(|y| (0_u8..48).map(move |x| (x, y))) {
            let point = FilmPoint { position: Vec2::new(f32::from(x) + 0.5, f32::from(y) + 0.5), size };
            let seen = |direct: &DirectLight| direct.radiance(point, &mut Stream::new(0, 0, 0), &mut Untold);
            assert_eq!((seen(&small), seen(&large)), (seen(&plain), seen(&plain)), "at {x}, {y}");
        }
    }
}
