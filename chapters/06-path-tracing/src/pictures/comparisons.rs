//! The room over and over again: what samples, directions and bounces do, and how large the error is.

use std::sync::Arc;

use common::{
    Error, Vec2,
    film::Size,
    picture::{ORBIT, Picture, Render, Settings},
};
use sampling::sky_light::Choice;

use super::{
    room::{Lamp, view, world},
    sheet::{Panel, Sheet, Shown},
    steps::PLAIN_BOUNCES,
};
use crate::{method::Method, path_tracer::PathTracer, world::World};

/// Size of a panel where three stand in a row, and where two do.
pub(super) const THIRD: Vec2 = Vec2::new(304.0, 190.0);
pub(super) const HALF: Vec2 = Vec2::new(462.0, 288.0);

/// A sheet with the camera's knobs.
pub(super) const fn picture(
    name: &'static str,
    alt: &'static str,
    size: Size,
    make: fn(&Settings) -> Result<Box<dyn Render>, Error>,
) -> Picture {
    Picture { name, alt, knobs: &ORBIT, size, samples: 1, takes_mesh: false, make }
}

pub(super) const SAMPLES: Picture = picture(
    "samples",
    "The room three times, with 1, 10 and 100 samples per pixel. With 1 the light of the lamp is there, strewn with white \
     dots, and what the lamp does not reach is nearly black; with 10 all is there under coarse grain; with 100 the grain \
     is fine.",
    Size::of::<960, 258>(),
    |settings| {
        let panel = |samples: u32, title: &str| (Method::BEST, samples, title.into(), String::new());
        sheet(settings, 3, THIRD, [panel(1, "1 sample per pixel"), panel(10, "10"), panel(100, "100")])
    },
);

pub(super) const DIRECTIONS: Picture = picture(
    "uniform-against-cosine",
    "The room three times without roulette. Left, 16 samples per pixel of uniform directions: coarse grain, and the \
     gold ball is black. Middle, 16 samples of cosine-distributed and mirror directions: less grain, and the ball is \
     gold and shows the room. Right, as many of these as take the time of the left one: the same once more.",
    Size::of::<960, 258>(),
    |settings| {
        let of = |choice| Method { choice, roulette: false, bounces: 0..=PLAIN_BOUNCES, ..Method::BEST };
        let panel = |choice, samples: u32, title: &str, caption: String| (of(choice), samples, title.into(), caption);
        let name = |samples: u32| format!("{samples} samples per pixel");
        sheet(
            settings,
            3,
            THIRD,
            [
                panel(Choice::Uniform, 16, "uniform", name(16)),
                panel(Choice::CosineAndMirror, 16, "cosine and mirror, equal samples", name(16)),
                panel(Choice::CosineAndMirror, EQUAL_TIME, "cosine and mirror, equal time", name(EQUAL_TIME)),
            ],
        )
    },
);

/// How many samples of cosine and mirror directions take the time of 16 uniform ones in the room. Measured with one thread,
/// three runs each: 1.10 times as long for each sample, since paths that meet the ball go on from there.
const EQUAL_TIME: u32 = 15;

pub(super) const LOCAL: Picture = picture(
    "local-and-global",
    "The room twice. Left, local illumination, light that was reflected at most once: the ball is black but for the \
     panel in it, the ceiling is lit on the left by the lamp alone, and the ball's shadow is nearly black. Right, \
     global illumination: the ceiling and all shadows are filled, the white things are tinged red and blue, and the \
     ball shows the whole room.",
    Size::of::<960, 356>(),
    |settings| {
        let of = |most| Method { bounces: 0..=most, roulette: most > 1, ..Method::BEST };
        let panel = |most, title: &str, caption: &str| (of(most), 64, title.into(), caption.into());
        sheet(
            settings,
            2,
            HALF,
            [
                panel(1, "local illumination", "light that was reflected at most once"),
                panel(Method::MOST_BOUNCES, "global illumination", "all light"),
            ],
        )
    },
);

pub(super) const BOUNCES: Picture = picture(
    "bounces",
    "The room six times. With 0 bounces only the panel is there, which sends out light itself. Light of exactly one \
     bounce has deep shadows, a ceiling that only the lamp reaches, and a black ball with the panel in it. Of \
     two bounces it is dimmer and fills the shadows, and the ball is gold; of three dimmer again; of four and more, \
     dim reddish grain. The sixth is the sum of all.",
    Size::of::<960, 510>(),
    |settings| {
        let panel = |bounces: std::ops::RangeInclusive<u32>, title: &str| {
            // So many bounces and no more need no roulette: nothing is left out.
            let roulette = *bounces.end() == Method::MOST_BOUNCES;
            let samples = if roulette { 64 } else { 32 };
            (Method { bounces, roulette, ..Method::BEST }, samples, title.into(), String::new())
        };
        let most = Method::MOST_BOUNCES;
        sheet(
            settings,
            3,
            THIRD,
            [
                panel(0..=0, "0 bounces"),
                panel(1..=1, "1 bounce"),
                panel(2..=2, "2 bounces"),
                panel(3..=3, "3 bounces"),
                panel(4..=most, "4 and more"),
                panel(0..=most, "all"),
            ],
        )
    },
);

pub(super) const ERROR: Picture = picture(
    "error",
    "Left, the room with 32 samples per pixel. Right, its own error as a picture: the panel is black, since nothing \
     is left to chance there; the far wall is orange, where the light is strong; the side walls are violet with \
     bright dots; the crystals and the shadows are dark violet.",
    Size::of::<960, 356>(),
    |settings| {
        let world = Arc::new(world(Lamp::Abstract)?);
        let tracer = Arc::new(PathTracer { world, camera: view(settings)?, method: Method::BEST });
        let panel = |shown, title: &str, caption: &str| Panel {
            tracer: Arc::clone(&tracer),
            samples: 32,
            shown,
            title: title.into(),
            caption: caption.into(),
        };
        let panels = vec![
            panel(Shown::Mean, "mean of 32 samples", ""),
            panel(Shown::Error(0.25), "standard error of the mean", "black 0, red 0.125, white 0.25"),
        ];
        Ok(Box::new(Sheet::new(2, HALF, panels)))
    },
);

/// The room in several ways: method, samples, what stands above and what below.
pub(super) fn sheet<const N: usize>(
    settings: &Settings,
    columns: u8,
    size: Vec2,
    ways: [(Method, u32, String, String); N],
) -> Result<Box<dyn Render>, Error> {
    let worlds: [Arc<World>; 2] = [Arc::new(world(Lamp::Glowing)?), Arc::new(world(Lamp::Abstract)?)];
    let camera = view(settings)?;
    let panel = |(method, samples, title, caption): (Method, u32, String, String)| {
        let world = Arc::clone(&worlds[usize::from(method.direct)]);
        let tracer = Arc::new(PathTracer { world, camera, method });
        Panel { tracer, samples, shown: Shown::Mean, title, caption }
    };
    Ok(Box::new(Sheet::new(columns, size, ways.into_iter().map(panel).collect())))
}
