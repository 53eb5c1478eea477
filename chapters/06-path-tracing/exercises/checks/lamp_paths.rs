//! Checks paths that ask a lamp, for exercise 6.2.

use common::{
    Rgb, Stream, Vec3,
    exercise::{Finding, Verdict, trying},
    parallel,
};
use ray_casting::ray::Ray;
use sampling::estimate::Estimate;

use super::{
    lamp_rooms::{ROOMS, Room},
    lamp_world::LampWorld,
    words::{about, is_near, triple},
};

/// All light, by world and ray.
pub(super) type Radiance = fn(&LampWorld, Ray, &mut Stream) -> Rgb;

/// Paths of each scene.
const COUNT: u64 = 40_000;
/// And of those that find all light by chance: they are noisier.
const BY_CHANCE: u64 = 160_000;

/// Accept paths, or name what is wrong with them.
pub(super) fn paths(radiance: Radiance) -> Verdict {
    ROOMS.iter().try_for_each(|room| one_room(radiance, room))
}

/// Many paths along the ray of a room.
fn one_room(radiance: Radiance, room: &Room) -> Verdict {
    let scene = (room.make)();
    let (world, ray) = (scene.world, scene.ray);
    let tried = || {
        let (origin, direction) = (triple(ray.origin), triple(ray.direction));
        format!("`radiance` of a ray from {origin} in direction {direction}: {}", room.tells)
    };
    let one = |i| trying(tried, || radiance(&world, ray, &mut Stream::new(624, i, 0)));
    let samples = || (0..COUNT).map(one);
    // Where the lamp is in full view each path brings light, if it is asked.
    if room.is_open && samples().take(1000).filter(|sample| *sample == Rgb::ZERO).count() > 500 {
        let got = "no light at all in most samples".into();
        let advice = "The lamp is found by chance only, or it is asked too late. Add what `lamp_light` returns, times the throughput, at \
                      every hit, and before `world.step`: where roulette ends the path there, the hit was lit all the same.";
        return Err(Finding { tried: tried(), got, expected: "light in each sample".into(), advice: advice.into() }
            .named("lamp-not-asked"));
    }
    let mut measured = Estimate::default();
    samples().for_each(|sample| measured.add(sample.x.into()));
    let (expected, slack) = match scene.expected {
        Some(expected) => (expected, 0.0),
        None => by_chance(&world, ray),
    };
    let three_sigma = (measured.three_sigma() * measured.three_sigma() + slack * slack).sqrt();
    // Five standard deviations, and rounding.
    let is = |other: f64| is_near(measured.mean(), other, three_sigma * 5.0 / 3.0 + 1e-4 * other.abs());
    if is(expected) {
        return Ok(());
    }
    let rival = room.rivals.iter().find(|rival| {
        // A rival that was only estimated is met within a tenth.
        let other = rival.times * expected;
        is(other) || scene.expected.is_none() && is_near(measured.mean(), other, 0.1 * other)
    });
    let (name, advice) = rival.map_or((room.name, room.advice), |rival| (rival.name, rival.advice));
    let got = format!("the mean {} of {COUNT} paths, ± {}", about(measured.mean()), about(measured.three_sigma()));
    let expected = match scene.expected {
        Some(_) => about(expected),
        None => format!("{}, as by paths that find the lamp by chance", about(expected)),
    };
    Err(Finding { tried: tried(), got, expected, advice: advice.into() }.named(name))
}

/// The mean of paths that find all light by chance, and its three standard deviations.
fn by_chance(world: &LampWorld, ray: Ray) -> (f64, f64) {
    const PARTS: u64 = 16;
    let part = |part: usize| {
        let mut estimate = Estimate::default();
        for i in 0..BY_CHANCE / PARTS {
            estimate.add(world.by_chance(ray, &mut Stream::new(625, part as u64, i)).x.into());
        }
        estimate
    };
    let parts = parallel::map(PARTS as usize, part);
    let estimate = parts.into_iter().fold(Estimate::default(), Estimate::merge);
    (estimate.mean(), estimate.three_sigma())
}

/// A ray that looks from one point to another.
pub(super) fn look(from: Vec3, to: Vec3) -> Ray {
    Ray::new(from, (to - from).normalize())
}
