//! A chapter to test the window with.

use std::{path::Path, time::Duration};

use crate::{
    cli::{Output, Request},
    color::Rgb,
    error::Error,
    film::Size,
    knob::{Knob, Step},
    picture::{Chapter, FilmPoint, Integrator, PITCH, Picture, Render, Settings, YAW, ZOOM},
    random::Stream,
    renderer::Plan,
    story::Story,
};

const RINGS: Knob = Knob::number("rings", "how many rings", [1.0, 8.0], 4.0, "", Step::Whole);
const BROKEN: Knob = Knob::switch("broken", "whether it cannot be made", false);

/// Two pictures: `rings` with knobs and a camera, whose red is the number of rings / 8, and `plain`, all green and
/// slow.
pub(crate) const CHAPTER: Chapter = Chapter {
    number: 0,
    name: "fixture",
    title: "Fixture",
    pictures: &[
        Picture {
            name: "rings",
            alt: "Rings.",
            knobs: &[RINGS, YAW, PITCH, ZOOM, BROKEN],
            size: Size::of::<40, 20>(),
            samples: 4,
            takes_mesh: false,
            make: |settings| rings(settings),
        },
        Picture {
            name: "plain",
            alt: "Green.",
            knobs: &[],
            size: Size::of::<40, 20>(),
            samples: 100_000_000,
            takes_mesh: false,
            make: |_| Ok(Box::new(Plain)),
        },
    ],
    reports: &[],
};

/// The first picture as the command line would ask for it, to no file.
pub(crate) fn request() -> Request {
    let picture = &CHAPTER.pictures[0];
    Request {
        picture,
        settings: Settings::default(),
        size: picture.size,
        plan: Plan { samples: picture.samples, seed: 0, threads: 2 },
        samples: Some(picture.samples),
        until_error: None,
        save_state: None,
        resume: None,
        exposure: 0.0,
        window: true,
        output: Output::Default,
        quiet: true,
        pixel: None,
        list: false,
    }
}

/// The same, to a file.
pub(crate) fn request_to(file: &Path) -> Request {
    Request { output: Output::File(file.into()), ..request() }
}

fn rings(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    if settings.values.is_on(&BROKEN) {
        return Err(Error::KnobValue { knob: BROKEN.name, given: "on".into(), range: "off".into() });
    }
    Ok(Box::new(Rings(settings.values.number(&RINGS) / 8.0)))
}

struct Rings(f32);

impl Integrator for Rings {
    fn radiance(&self, _point: FilmPoint, _random: &mut Stream, _story: &mut impl Story) -> Rgb {
        Rgb::X * self.0
    }
}

struct Plain;

impl Integrator for Plain {
    fn radiance(&self, _point: FilmPoint, _random: &mut Stream, _story: &mut impl Story) -> Rgb {
        std::thread::sleep(Duration::from_micros(100));
        Rgb::Y
    }
}
