//! Picture of exercise 5.5: a picture made of dots.

use common::{
    Error, Rgb, Stream, Vec2,
    color::luminance,
    drawing::Drawing,
    knob::{Knob, Step},
    parallel,
    picture::{FilmPoint, Picture, Render, Settings},
};

use super::Make;
use crate::checks::{picture_as_density::Answer, table::Table};

const DOTS: Knob = Knob::number("dots", "how many dots are thrown", [100.0, 200_000.0], 80_000.0, "", Step::Times(2.0));

/// The page, and cells of the table along both of its sides.
const PAGE: Vec2 = Vec2::new(960.0, 540.0);
const CELLS: [usize; 2] = [320, 180];

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "Tens of thousands of small dots of nearly the same brightness on black. They show the treasure of chapter 3, large metal balls on a round \
               terrace by the sea: where that picture is bright the dots lie close together, and where it is dark there are few.";
    Picture { knobs: &[DOTS], ..super::picture("5.5-picture-as-density", alt, make) }
}

/// Dots where the student's table puts them.
pub(crate) fn make(settings: &Settings, answer: Answer) -> Result<Box<dyn Render>, Error> {
    let original = whitted::CHAPTER.picture("treasure");
    let render = match original {
        Some(picture) => (picture.make)(&Settings::default())?,
        None => return Err(Error::Picture("chapter 3 has no picture of that name any more".into())),
    };
    let [columns, rows] = CELLS;
    let size = Vec2::new(columns as f32, rows as f32);
    let colors: Vec<Rgb> = parallel::map(rows, |row| {
        let color = |column: usize| {
            let sum: Rgb = (0..4)
                .map(|sample| {
                    let mut random = Stream::new(0, (row * columns + column) as u64, sample);
                    let jitter = Vec2::new(random.uniform(), random.uniform());
                    let position = Vec2::new(column as f32, row as f32) + jitter;
                    render.sample(FilmPoint { position, size }, &mut random)
                })
                .sum();
            sum / 4.0
        };
        (0..columns).map(color).collect::<Vec<_>>()
    })
    .into_iter()
    .flatten()
    .collect();
    // The eye and the screen see no more than 1.
    let weights: Vec<f64> = colors.iter().map(|color| luminance(color.min(Rgb::ONE)).into()).collect();
    let table = Table::new(answer.cumulative, columns, &weights);
    let mut random = Stream::new(5, 5, 0);
    let mut dots: Vec<[f64; 2]> = (0..settings.values.index(&DOTS))
        .map(|_| (answer.sample_table)(&table, [(); 2].map(|()| f64::from(random.uniform()))).0)
        .filter(|point| point.iter().all(|x| (0.0..1.0).contains(x)))
        .collect();
    // Neighbors one after the other, because a drawing looks at several marks together.
    dots.sort_by_key(|[x, y]| ((y * 108.0) as u32, (x * 1e6) as u32));
    let mut drawing = Drawing::new(PAGE, Rgb::splat(0.004));
    for [x, y] in dots {
        let color = colors[(y * rows as f64) as usize * columns + (x * columns as f64) as usize];
        let hue = color / luminance(color).max(1e-6);
        drawing.disc(Vec2::new(x as f32, y as f32) * PAGE, 0.85, (hue * 0.5).min(Rgb::ONE));
    }
    Ok(Box::new(drawing))
}
