//! A picture that is computed inside a web page: what the page must know of it, and the share of one worker.
//!
//! The page starts several workers, each with an instance of the module of its own. They share no memory: each takes
//! every so-manieth tile of the film and hands over the pixels of a tile whenever it has more samples.

use std::fmt::Write as _;

use common::{
    color::to_byte,
    error::Error,
    film::{Film, Size, Tile},
    knob::{Kind, Knob, Step},
    picture::{Chapter, Picture, Render, Settings},
    renderer::{Plan, fill_tile},
};

/// Greatest length of a side in pixels.
pub const SIDE: u32 = 640;
/// Seed of the random numbers, the same as of the command line.
const SEED: u64 = 0;
/// Most samples per pixel that a tile receives at once, so that a worker soon listens again.
const LARGEST_PASS: u32 = 4;

/// What a page must know of a picture, as JSON: its size, its samples, its knobs.
///
/// The book writes it into the page and the module answers with its own, so a page notices when the two were made from
/// different sources. `None` if there is no such picture.
#[must_use]
pub fn describe(chapters: &[Chapter], chapter: usize, picture: usize) -> Option<String> {
    let owner = chapters.get(chapter)?;
    let shown = owner.pictures.get(picture)?;
    let size = if shown.size.width().max(shown.size.height()) > SIDE { shown.size.scaled_to(SIDE) } else { shown.size };
    let knobs: Vec<_> = shown.knobs.iter().map(knob).collect();
    Some(format!(
        "{{\"name\":{},\"chapter\":{chapter},\"picture\":{picture},\"width\":{},\"height\":{},\"samples\":{},\
         \"knobs\":[{}]}}",
        quote(&format!("{}/{}", owner.name, shown.name)),
        size.width(),
        size.height(),
        shown.samples,
        knobs.join(",")
    ))
}

/// A knob as JSON.
fn knob(knob: &Knob) -> String {
    let kind = match knob.kind {
        Kind::Number { min, max, unit, step, .. } => {
            let (scale, step) = match step {
                Step::Add(step) => ("add", step),
                Step::Times(step) => ("times", step),
                Step::Whole => ("add", 1.0),
            };
            let unit = quote(unit);
            format!(
                "\"kind\":\"number\",\"min\":{min},\"max\":{max},\"unit\":{unit},\"scale\":\"{scale}\",\"step\":{step}"
            )
        }
        Kind::Choice { options, .. } => {
            let options: Vec<_> = options.iter().map(|option| quote(option)).collect();
            format!("\"kind\":\"choice\",\"options\":[{}]", options.join(","))
        }
        Kind::Switch { .. } => "\"kind\":\"switch\"".into(),
    };
    format!("{{\"name\":{},\"what\":{},\"default\":{},{kind}}}", quote(knob.name), quote(knob.what), knob.default())
}

/// Text as JSON.
fn quote(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => drop(write!(quoted, "\\u{:04x}", u32::from(c))),
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

/// The value of a knob that is nearest to what a page has sent.
#[must_use]
pub fn nearest(knob: &Knob, value: f32) -> f32 {
    #[expect(clippy::cast_precision_loss, reason = "a choice has few options")]
    let (min, max, is_whole) = match knob.kind {
        Kind::Number { min, max, step, .. } => (min, max, step == Step::Whole),
        Kind::Choice { options, .. } => (0.0, options.len().saturating_sub(1) as f32, true),
        Kind::Switch { .. } => (0.0, 1.0, true),
    };
    if value.is_nan() {
        return knob.default();
    }
    let value = value.clamp(min, max);
    if is_whole { value.round() } else { value }
}

/// Which tiles of the film are a worker's: those whose index leaves `worker` when divided by `workers`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Share {
    /// Number of the worker, from 0.
    pub worker: usize,
    /// How many workers there are.
    pub workers: usize,
}

/// A picture in the making, as far as one worker makes it.
pub struct Live {
    picture: Box<dyn Render>,
    film: Film,
    plan: Plan,
    share: Share,
    /// Index of the tile that is next.
    next: usize,
    /// Samples per pixel that all tiles of the share have.
    samples: u32,
}

impl Live {
    /// Begin a picture.
    ///
    /// # Errors
    /// As for [`Picture::make`].
    pub fn new(
        picture: &Picture,
        settings: &Settings,
        size: Size,
        samples: u32,
        Share { worker, workers }: Share,
    ) -> Result<Self, Error> {
        let workers = workers.max(1);
        Ok(Self {
            picture: (picture.make)(settings)?,
            film: Film::new(size),
            plan: Plan { samples, seed: SEED, threads: 1 },
            share: Share { worker: worker % workers, workers },
            next: worker % workers,
            samples: 0,
        })
    }

    /// Add samples to one tile, and hand it over; `None` when every tile of the share has all its samples.
    pub fn step(&mut self) -> Option<&Tile> {
        let Self { picture, film, plan, share, next, samples } = self;
        if *samples >= plan.samples {
            return None;
        }
        let until = plan.samples.min(*samples + (*samples).clamp(1, LARGEST_PASS));
        let (size, count, index) = (film.size(), film.tiles().len(), *next);
        // A small film can have fewer tiles than there are workers.
        let Some(tile) = film.tiles_mut().get_mut(index) else {
            *samples = plan.samples;
            return None;
        };
        fill_tile(picture.as_ref(), tile, size, plan, until);
        *next += share.workers;
        if *next >= count {
            *next = share.worker;
            *samples = until;
        }
        Some(tile)
    }

    /// Samples per pixel that all tiles of the share have.
    #[must_use]
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// How many samples were no numbers.
    #[must_use]
    pub fn bad_samples(&self) -> u64 {
        self.film.bad_samples()
    }
}

/// The pixels of a tile for a screen: red, green, blue and full opacity, 8 bits each, row by row from the top.
#[must_use]
pub fn develop(tile: &Tile) -> Vec<u8> {
    let colors = tile.pixels.iter().map(|pixel| pixel.mean().to_array().map(to_byte));
    colors.flat_map(|[red, green, blue]| [red, green, blue, 255]).collect()
}

#[cfg(test)]
mod tests {
    use common::{
        Rgb,
        picture::{FilmPoint, Integrator, YAW},
        random::Stream,
        renderer::render,
        story::Story,
    };

    use super::*;

    /// Radiance that depends on place and chance.
    struct Noise;

    impl Integrator for Noise {
        fn radiance(&self, point: FilmPoint, random: &mut Stream, _: &mut impl Story) -> Rgb {
            Rgb::new(point.ndc().x.abs(), point.ndc().y.abs(), random.uniform())
        }
    }

    const SIZE: Size = Size::of::<70, 37>();
    const BUG: Knob = Knob::switch("bug", "whether \"it\" is \\ wrong", true);
    const TERM: Knob = Knob::choice("term", "which", &["all four", "none"], 1);
    const EXPONENT: Knob = Knob::number("exponent", "how", [1.0, 100.0], 0.1, "", Step::Times(1.5));
    const COUNT: Knob = Knob::number("count", "how many", [1.0, 8.0], 3.0, "", Step::Whole);
    const NOISE: Picture = Picture {
        name: "noise",
        alt: "Noise.",
        knobs: &[YAW, BUG, TERM, EXPONENT],
        size: Size::of::<960, 340>(),
        samples: 11,
        takes_mesh: false,
        make: |_| Ok(Box::new(Noise)),
    };
    const BROKEN: Picture = Picture { name: "broken", make: |_| Err(Error::Picture("no".into())), ..NOISE };
    const CHAPTERS: &[Chapter] =
        &[Chapter { number: 1, name: "toy", title: "Toy", pictures: &[BROKEN, NOISE], reports: &[] }];

    #[test]
    fn workers_together_make_the_picture_of_the_command_line() {
        let mut film = Film::new(SIZE);
        render(&Noise, &mut film, &Plan { samples: 11, seed: SEED, threads: 1 }, &());
        let expected: Vec<_> = film.develop(0.0);
        for workers in [1, 2, 4, 100] {
            let mut pixels = vec![[0; 3]; SIZE.pixels()];
            for worker in 0..workers {
                let share = Share { worker, workers };
                let mut live = Live::new(&NOISE, &Settings::default(), SIZE, 11, share).unwrap();
                while let Some(tile) = live.step() {
                    let rgba = develop(tile);
                    for ((x, y, row), bytes) in tile.rows().zip(rgba.chunks(4 * tile.width as usize)) {
                        let start = y as usize * 70 + x as usize;
                        for (to, from) in pixels[start..start + row.len()].iter_mut().zip(bytes.chunks(4)) {
                            to.copy_from_slice(&from[..3]);
                            assert_eq!(from[3], 255);
                        }
                    }
                }
                assert_eq!((live.samples(), live.bad_samples()), (11, 0));
            }
            assert_eq!(pixels, expected, "{workers} workers");
        }
    }

    #[test]
    fn what_cannot_be_made_says_so() {
        let share = Share { worker: 0, workers: 0 };
        let error = Live::new(&BROKEN, &Settings::default(), SIZE, 1, share).err();
        assert_eq!(error, Some(Error::Picture("no".into())));
        assert!(Live::new(&NOISE, &Settings::default(), SIZE, 0, share).unwrap().step().is_none());
    }

    #[test]
    fn the_page_is_told_everything_it_needs() {
        let expected = "{\"name\":\"toy/noise\",\"chapter\":0,\"picture\":1,\"width\":640,\"height\":227,\
             \"samples\":11,\"knobs\":[\
             {\"name\":\"yaw\",\"what\":\"camera turned around the vertical\",\"default\":0,\"kind\":\"number\",\
             \"min\":-180,\"max\":180,\"unit\":\"°\",\"scale\":\"add\",\"step\":5},\
             {\"name\":\"bug\",\"what\":\"whether \\\"it\\\" is \\\\ wrong\",\"default\":1,\"kind\":\"switch\"},\
             {\"name\":\"term\",\"what\":\"which\",\"default\":1,\"kind\":\"choice\",\"options\":[\"all four\",\"none\"]},\
             {\"name\":\"exponent\",\"what\":\"how\",\"default\":0.1,\"kind\":\"number\",\
             \"min\":1,\"max\":100,\"unit\":\"\",\"scale\":\"times\",\"step\":1.5}]}";
        assert_eq!(describe(CHAPTERS, 0, 1).as_deref(), Some(expected));
        assert_eq!(describe(CHAPTERS, 0, 2), None);
        assert_eq!(describe(CHAPTERS, 1, 0), None);
        assert_eq!(quote("a\nb"), "\"a\\u000ab\"");
    }

    #[test]
    fn values_from_a_page_are_brought_into_range() {
        for (knob, sent, taken) in [
            (YAW, 12.5, 12.5),
            (YAW, 999.0, 180.0),
            (YAW, f32::NAN, 0.0),
            (COUNT, 2.4, 2.0),
            (COUNT, f32::NEG_INFINITY, 1.0),
            (TERM, 7.0, 1.0),
            (BUG, 0.3, 0.0),
        ] {
            assert_eq!(nearest(&knob, sent), taken, "{} {sent}", knob.name);
        }
    }
}
