//! Wrong paths that ask a lamp: each is a loop with other answers to two questions.

use common::{Rgb, Stream};
use path_tracing::roulette::Kind;
use ray_casting::ray::Ray;

use crate::{
    area_light::{RIGHT, lamp_light},
    checks::{
        area_light::{Answer, check},
        lamp_world::{LampWorld, Surface},
    },
    name,
};

/// How far a path has come: the kinds of its steps so far.
type Steps<'s> = &'s [Kind];

/// A loop that is told when emission counts, and how the lamp's light is multiplied at each hit, by throughput.
fn walk(
    (world, ray): (&LampWorld, Ray),
    random: &mut Stream,
    counts: impl Fn(Steps<'_>, &Surface) -> bool,
    asked: impl Fn(Steps<'_>, Rgb) -> Rgb,
) -> Rgb {
    let (mut ray, mut radiance, mut throughput, mut steps) = (ray, Rgb::ZERO, Rgb::ONE, Vec::new());
    for _ in 0..LampWorld::MOST_BOUNCES {
        let Some((hit, surface)) = world.intersect(&ray) else {
            return radiance + throughput * world.sky(ray.direction);
        };
        if counts(&steps, surface) {
            radiance += throughput * surface.material.emission;
        }
        radiance += asked(&steps, throughput) * lamp_light(world, &surface.material, &hit, random);
        let Some((step, kind)) = world.step(&surface.material, &hit, -ray.direction, random) else { break };
        steps.push(kind);
        throughput *= step.weight;
        ray = world.next_ray(&hit, &step);
    }
    radiance
}

/// Whether emission counts, as it should.
fn right(steps: Steps<'_>, surface: &Surface) -> bool {
    !surface.is_lamp || steps.last() != Some(&Kind::Diffuse)
}

pub(crate) fn radiance(world: &LampWorld, ray: Ray, random: &mut Stream) -> Rgb {
    walk((world, ray), random, right, |_, throughput| throughput)
}

fn diagnosis(radiance: fn(&LampWorld, Ray, &mut Stream) -> Rgb) -> &'static str {
    name(check(Answer { radiance, ..RIGHT }))
}

/// The diagnosis of such answers to the question when emission counts.
macro_rules! counts {
    ($counts:expr) => {
        diagnosis(|world, ray, random| {
            let counts: fn(Steps<'_>, &Surface) -> bool = $counts;
            walk((world, ray), random, counts, |_, throughput| throughput)
        })
    };
}

/// Pitfall 23: a light that is asked and found by chance.
#[test]
fn light_that_counts_twice() {
    assert_eq!(counts!(|_, _| true), "counted-twice");
}

#[test]
fn light_that_does_not_count() {
    assert_eq!(counts!(|_, surface| !surface.is_lamp), "black-lamp");
    assert_eq!(counts!(|_, _| false), "black-lamp");
    assert_eq!(counts!(|steps, surface| !surface.is_lamp || steps.is_empty()), "black-in-the-mirror");
    assert_eq!(counts!(|steps, _| steps.last() != Some(&Kind::Diffuse)), "other-light-lost");
    // Once diffuse, never again.
    assert_eq!(counts!(|steps, surface| !surface.is_lamp || !steps.contains(&Kind::Diffuse)), "caustic-lost");
}

#[test]
fn lamps_that_are_asked_wrongly() {
    assert_eq!(
        diagnosis(|world, ray, random| {
            // After the first hit the lamp is neither asked nor found.
            walk((world, ray), random, right, |steps, throughput| if steps.is_empty() { throughput } else { Rgb::ZERO })
        }),
        "first-hit-only"
    );
    assert_eq!(
        diagnosis(|world, ray, random| walk((world, ray), random, right, |_, _| Rgb::ONE)),
        "throughput-forgotten"
    );
    assert_eq!(
        diagnosis(|world, ray, random| walk((world, ray), random, right, |_, throughput| throughput * 0.9)),
        "wrong-direct-light"
    );
    assert_eq!(diagnosis(|_, _, _| Rgb::NAN), "wrong-direct-light");
    // A sky that is lost.
    assert_eq!(
        diagnosis(|world, ray, random| {
            let light = radiance(world, ray, random);
            if world.sky(ray.direction) == Rgb::ZERO { light } else { light * 0.8 }
        }),
        "differs-from-chance"
    );
}

/// What the step was is known by the material alone: the lamp is missing in porcelain.
#[test]
fn a_kind_that_is_guessed() {
    assert_eq!(
        diagnosis(|world, ray, random| {
            let porcelain = world.intersect(&ray).map(|(_, surface)| surface.material);
            let is_coated = porcelain.is_some_and(|m| m.mirror.is_some() && m.diffuse != Rgb::ZERO);
            let counts = |steps: Steps<'_>, surface: &Surface| right(steps, surface) && !(is_coated && surface.is_lamp);
            walk((world, ray), random, counts, |_, throughput| throughput)
        }),
        "kind-ignored"
    );
}
