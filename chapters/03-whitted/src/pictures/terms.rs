//! The terms of the formula, one by one and together.

use common::{
    Error, Interval, Rgb, Stream,
    film::Size,
    knob::Knob,
    picture::{FilmPoint, Integrator, ORBIT, Panels, Picture, Render, Settings},
    story::Story,
};

use super::{
    studio::{DEPTH, limits, seen},
    treasure,
};
use crate::whitted::{Terms, Whitted};

const TERM: Knob =
    Knob::choice("term", "which terms are shown", &["all four", "rough", "reflective", "refractive", "sum"], 0);

pub(super) const PICTURE: Picture = Picture {
    name: "terms",
    alt: "The treasure four times. Upper left, the rough term only: the floor, the pearls, the egg and the red ball \
          without gloss; metal and glass are black. Upper right, what is reflected: the metals and two rings of gold \
          in the floor as usual, a faint gloss on glass and porcelain, the rest black. Lower left, what is refracted: \
          two glass balls on black. Lower right, the sum of the three.",
    knobs: &[TERM, DEPTH, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    const ONE_BY_ONE: [Terms; 4] = [
        Terms { rough: true, ..Terms::NONE },
        Terms { reflective: true, ..Terms::NONE },
        Terms { refractive: true, ..Terms::NONE },
        Terms::ALL,
    ];
    let view = |terms: Terms| -> Result<Box<dyn Render>, Error> {
        let (camera, limits) = (treasure::view(settings)?, limits(settings, &DEPTH));
        let whitted = Whitted { terms, ..seen(treasure::scene(), camera, limits) };
        // What lies behind everything counts with the rough term, so that the parts add up to the sum.
        Ok(if terms.rough { Box::new(whitted) } else { Box::new(WithoutBackground(whitted)) })
    };
    Ok(match settings.values.index(&TERM) {
        i @ 1..=4 => view(ONE_BY_ONE[i - 1])?,
        _ => Box::new(Panels::new(2, ONE_BY_ONE.into_iter().map(view).collect::<Result<_, _>>()?)),
    })
}

/// Black where the eye sees no surface.
struct WithoutBackground(Whitted);

impl Integrator for WithoutBackground {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let Whitted { scene, camera, .. } = &self.0;
        if scene.intersect(&camera.ray(point), Interval::POSITIVE).is_none() {
            story.tell(|| "hits nothing: the background counts with the rough term".into());
            return Rgb::ZERO;
        }
        self.0.radiance(point, random, story)
    }
}
