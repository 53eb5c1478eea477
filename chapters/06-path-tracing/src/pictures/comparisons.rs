//! The room over and over again: what samples, directions, bounces and the roulette do.

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
};
use crate::{
    path_tracer::{Method, PathTracer},
    world::World,
};

/// Size of a panel where three stand in a row, and where two do.
const THIRD: Vec2 = Vec2::new(304.0, 190.0);
const HALF: Vec2 = Vec2::new(462.0, 288.0);

const fn picture(
    name: &'static str,
    alt: &'static str,
    size: Size,
    make: fn(&Settings) -> Result<Box<dyn Render>, Error>,
) -> Picture {
    Picture { name, alt, knobs: &ORBIT, size, samples: 1, takes_mesh: false, make }
}

pub(super) const SAMPLES: Picture = picture(
    "samples",
    "The room three times, with 1, 10 and 100 samples per pixel. With 1 it is a cloud of dots in which the walls, the \
     block and the ball can just be told apart; with 10 all things are there under coarse grain; with 100 the grain is \
     fine.",
    Size::of::<960, 258>(),
    |settings| {
        let panel = |samples: u32, title: &str| (Method::BEST, samples, title.into(), String::new());
        sheet(settings, 3, THIRD, [panel(1, "1 sample per pixel"), panel(10, "10"), panel(100, "100")])
    },
);

pub(super) const STEPS: Picture = picture(
    "steps",
    "The room four times with 8 samples per pixel. Upper left, the plain random walk: dark dots everywhere, and single \
     bright ones, since the lamp is a small ball that few paths find. Upper right, with direct light: the lamp's light \
     and shadows are smooth. Lower left, with importance sampling: less grain, and the black ball becomes gold. Lower \
     right, with roulette: as the last one, with a little more grain, for less than half of the rays.",
    Size::of::<960, 706>(),
    |settings| {
        let plain = Method { bounces: 0..=PLAIN_BOUNCES, ..Method::PLAIN };
        let direct = Method { direct: true, ..plain.clone() };
        let important = Method { choice: Choice::CosineAndMirror, ..direct.clone() };
        let roulette = Method { roulette: true, bounces: Method::BEST.bounces, ..important.clone() };
        let panel = |method: Method, title: &str, caption: &str| (method, 8, title.into(), caption.into());
        sheet(
            settings,
            2,
            HALF,
            [
                panel(plain, "random walk", "the lamp is a glowing ball; 10 bounces"),
                panel(direct, "+ direct light", "the lamp is a point; 10 bounces"),
                panel(important, "+ importance sampling", "10 bounces"),
                panel(roulette, "+ Russian roulette", "any number of bounces"),
            ],
        )
    },
);

/// Where walks are cut off that nothing else ends.
const PLAIN_BOUNCES: u32 = 10;

pub(super) const DIRECTIONS: Picture = picture(
    "uniform-against-cosine",
    "The room three times without roulette. Left, 16 samples per pixel of uniform directions: coarse grain, and the gold ball \
     is black. Middle, 16 samples of cosine-distributed and mirror directions: less grain, and the ball is gold and \
     shows the room. Right, as many of these as take the time of the left one: the same once more.",
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

/// How many samples of cosine and mirror directions take the time of 16 uniform ones in the room, as
/// `cargo bench -p path-tracing` measures it.
const EQUAL_TIME: u32 = 16;

pub(super) const LOCAL: Picture = picture(
    "local-and-global",
    "The room twice. Left, local illumination, light that was reflected at most once: shadows of the lamp are deep, the \
     ceiling is black around the panel, and in the ball only panel and lamp can be seen. Right, global illumination: the ceiling and all shadows are lit by the walls, white \
     things are tinged red and blue, and the ball shows the whole room.",
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
    "The room six times. Only what sends out light itself: the panel. Then light of exactly one bounce, with deep \
     shadows and a black ceiling; of two, dimmer, with the ceiling lit and the ball showing what the last one did; of three, dimmer and without any \
     sharp shadow; of all further ones, an even reddish gray; and the sum of all.",
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

pub(super) const ROULETTE: Picture = picture(
    "roulette",
    "The room three times with 32 samples per pixel. Left, without roulette and with at most 3 bounces: smooth but too dark, \
     above all in the corners and on the ceiling. Middle, with at most 10 bounces: as bright as it should be. Right, with roulette: just as \
     bright, with more grain.",
    Size::of::<960, 258>(),
    |settings| {
        let cut = |most| Method { roulette: false, bounces: 0..=most, ..Method::BEST };
        let panel = |method: Method, title: &str, caption: &str| (method, 32, title.into(), caption.into());
        sheet(
            settings,
            3,
            THIRD,
            [
                panel(cut(3), "cut off after 3 bounces", "too dark on average"),
                panel(cut(PLAIN_BOUNCES), "cut off after 10 bounces", "right but for a trace"),
                panel(Method::BEST, "Russian roulette", "right on average"),
            ],
        )
    },
);

pub(super) const ERROR: Picture = picture(
    "error",
    "Left, the room with 32 samples per pixel. Right, its own error as a picture: the panel is black, since nothing there \
     is left to chance; the ball mirrors that; the walls are violet to red; the lamp's bright spot stands out no more than the \
     rest, since direct light is certain.",
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
fn sheet<const N: usize>(
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

#[cfg(test)]
mod tests {
    use common::{Stream, picture::FilmPoint};

    use super::*;
    use crate::probe::RayCounts;

    /// What the picture of the steps says of the last one.
    #[test]
    fn roulette_needs_less_than_half_of_the_rays() {
        let world = Arc::new(world(Lamp::Abstract).unwrap());
        let camera = view(&Settings::default()).unwrap();
        let rays = |method| {
            let tracer = PathTracer { world: Arc::clone(&world), camera, method };
            let mut counts = RayCounts::default();
            for i in 0..2000 {
                let mut random = Stream::new(1, i, 0);
                let position = HALF * Vec2::new(random.uniform(), random.uniform());
                tracer.trace(camera.ray(FilmPoint { position, size: HALF }), &mut random, &mut counts);
            }
            counts.path_rays + counts.shadow_rays
        };
        let cut = rays(Method { roulette: false, bounces: 0..=PLAIN_BOUNCES, ..Method::BEST });
        let roulette = rays(Method::BEST);
        println!("rays of 2000 paths: {cut} without roulette, {roulette} with it");
        assert!(2 * roulette < cut, "{roulette} {cut}");
    }
}
