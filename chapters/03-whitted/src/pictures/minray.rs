//! The picture of the business card, enlarged and sharp.

use common::{
    Error, Rgb, Stream,
    color::srgb_decode,
    film::Size,
    knob::{Knob, Step},
    picture::{FilmPoint, Integrator, Panels, Picture, Render, Settings},
    story::{Story, triple},
};

use crate::minray::{self, LEVELS, SIDE};

const LEVELS_KNOB: Knob =
    Knob::number("levels", "how many surfaces a ray may hit", [0.0, 12.0], LEVELS as f32, "surfaces", Step::Add(1.0));
const VIEW: Knob = Knob::choice("view", "what is shown", &["both", "card", "sharp"], 0);

pub(super) const PICTURE: Picture = Picture {
    name: "minray",
    alt: "The same picture twice: left in 32 by 32 coarse pixels, right at full resolution. On black, a large dark glass \
          ball floats before an orange ball on the left and a teal one on the right, each with pale reflections of two \
          lamps and the shadows of the others. At the upper rim of the glass both appear once more, upside down and with \
          sides changed.",
    knobs: &[VIEW, LEVELS_KNOB],
    size: Size::of::<960, 480>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the knob's range")]
    let levels = settings.values.number(&LEVELS_KNOB) as u32;
    let card = |is_coarse| -> Box<dyn Render> { Box::new(Card { is_coarse, levels }) };
    Ok(match settings.values.index(&VIEW) {
        1 => card(true),
        2 => card(false),
        _ => Box::new(Panels::new(2, vec![card(true), card(false)])),
    })
}

/// The card's picture as large as the film allows.
struct Card {
    /// Whether the card's own pixels are shown, and not the finer ones of the film.
    is_coarse: bool,
    levels: u32,
}

// ANCHOR: card
impl Integrator for Card {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        // Find the place in pixels of the card, whose first pixel is (0, 0) in its middle.
        let side = SIDE as f32;
        let place = (point.position - point.size / 2.0) * side / point.size.min_element() + side / 2.0;
        let place = if self.is_coarse { place.floor() } else { place - 0.5 };
        story.tell(|| format!("column {} and row {} of the card", place.x, place.y));
        let color = minray::color(place.x.into(), place.y.into(), self.levels).as_vec3();
        story.tell(|| format!("the card's color {}, times 255 {}", triple(color), triple(color * 255.0)));
        // The card's numbers go to the screen as they are: undo the encoding that the film will apply.
        Rgb::from_array(color.to_array().map(srgb_decode))
    }
}
// ANCHOR_END: card
