//! What each idea of the chapter buys: the room, step by step.

use common::{film::Size, picture::Picture};
use sampling::sky_light::Choice;

use super::comparisons::{HALF, THIRD, picture, sheet};
use crate::method::Method;

pub(super) const STEPS: Picture = picture(
    "steps",
    "The room four times with 8 samples per pixel. Upper left, the plain random walk: dark, and all of it bright and \
     black dots; the lamp is a small white ball that few paths find, and the gold ball is black. Upper right, with \
     direct light: brighter, and what the lamp lights is calm. Lower left, with importance sampling: less grain, and \
     the black ball becomes gold. Lower right, with roulette: as bright, with more grain, for less than a third of the \
     rays.",
    Size::of::<960, 706>(),
    |settings| {
        let [plain, direct, important, roulette] = methods();
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
pub const PLAIN_BOUNCES: u32 = 10;

/// The steps: each has one idea more than the one before.
#[must_use]
pub fn methods() -> [Method; 4] {
    let plain = Method { bounces: 0..=PLAIN_BOUNCES, ..Method::PLAIN };
    let direct = Method { direct: true, ..plain.clone() };
    let important = Method { choice: Choice::CosineAndMirror, ..direct.clone() };
    [plain, direct, important, Method::BEST]
}

pub(super) const ROULETTE: Picture = picture(
    "roulette",
    "The room three times with 32 samples per pixel. Left, without roulette and with at most 3 bounces: too dark, above \
     all in the corners and on the ceiling. Middle, with at most 10 bounces: as bright as it should be. Right, with \
     roulette: just as bright, with more grain.",
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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use common::{
        Stream,
        picture::{FilmPoint, Settings},
    };

    use common::Vec2;

    use super::*;
    use crate::{
        path_tracer::PathTracer,
        pictures::room::{Lamp, view, world},
        probe::RayCounts,
    };

    /// What the picture of the steps says of the last one.
    #[test]
    fn roulette_needs_less_than_a_third_of_the_rays() {
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
        assert!(3 * roulette < cut, "{roulette} {cut}");
    }
}
