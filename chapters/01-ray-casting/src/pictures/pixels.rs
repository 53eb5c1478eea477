//! The still life with pixels large enough to count.

use common::{
    Error, Rgb, Stream, Vec2,
    film::Size,
    knob::{Knob, Step},
    picture::{FilmPoint, ORBIT, Picture, Render, Settings},
    story::{Story, Told},
};

use super::still_life;
use crate::local_illumination::{LocalIllumination, Terms};

const COLUMNS: Knob = Knob::number("columns", "large pixels in a row", [2.0, 400.0], 64.0, "", Step::Whole);

pub(super) const PICTURE: Picture = Picture {
    name: "pixels",
    alt: "The still life in 64 columns of large square pixels, each of one color: the color that the ray through the \
          pixel's center has found. Edges are staircases.",
    knobs: &[COLUMNS, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 540>(),
    samples: 1,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let (scene, camera) = (still_life::scene()?, still_life::view(settings)?);
    let columns = settings.values.number(&COLUMNS);
    Ok(Box::new(LargePixels { fine: LocalIllumination { scene, camera, terms: Terms::ALL }, columns }))
}

/// Another picture, looked at only in the centers of large pixels.
struct LargePixels {
    fine: LocalIllumination,
    columns: f32,
}

impl LargePixels {
    fn center(&self, point: FilmPoint) -> FilmPoint {
        let side = point.size.x / self.columns;
        FilmPoint { position: ((point.position / side).floor() + Vec2::splat(0.5)) * side, ..point }
    }
}

impl Render for LargePixels {
    fn sample(&self, point: FilmPoint, random: &mut Stream) -> Rgb {
        self.fine.sample(self.center(point), random)
    }

    fn explain(&self, point: FilmPoint, random: &mut Stream, story: &mut Told) -> Rgb {
        let center = self.center(point);
        story.tell(|| format!("taken from the center of its large pixel, {}", center.position));
        self.fine.explain(center, random, story)
    }
}
