//! Wrong points of a lamp, and wrong light of it.

use std::f32::consts::PI;

use common::{Rgb, Stream, Vec2, Vec3};
use path_tracing::material::Material;
use ray_casting::hit::Hit;
use sampling::unit_square::sample_unit_square;

use crate::{
    checks::{
        area_light::{Answer, check},
        lamp::{Lamp, LampSample},
        lamp_world::LampWorld,
    },
    lamp_paths::radiance,
    name,
};

type SampleLamp = fn(&Lamp, Vec3, Vec2) -> LampSample;
type LampLight = fn(&LampWorld, &Material, &Hit, &mut Stream) -> Rgb;

/// What the lamp looks like from somewhere: unit vector, distance, area, and the cosine at the lamp, with its sign.
fn seen(lamp: &Lamp, from: Vec3, u: Vec2) -> (Vec3, f32, f32, f32) {
    let offset = lamp.at(u) - from;
    let cross = lamp.edges[0].cross(lamp.edges[1]);
    let direction = offset.normalize_or_zero();
    (direction, offset.length(), cross.length(), cross.normalize_or_zero().dot(direction))
}

pub(crate) fn sample_lamp(lamp: &Lamp, from: Vec3, u: Vec2) -> LampSample {
    let (direction, distance, area, cosine) = seen(lamp, from, u);
    let density = if cosine == 0.0 { 0.0 } else { distance * distance / (area * cosine.abs()) };
    LampSample { direction, distance, density }
}

/// What a hit sends on of a sample.
fn reflected(world: &LampWorld, material: &Material, hit: &Hit, sample: &LampSample) -> Rgb {
    let cosine = sample.direction.dot(hit.shading_normal).max(0.0);
    let is_lit = sample.density > 0.0 && world.sees(hit, sample);
    if is_lit { material.diffuse * world.lamp.radiance * cosine / sample.density } else { Rgb::ZERO }
}

pub(crate) fn lamp_light(world: &LampWorld, material: &Material, hit: &Hit, random: &mut Stream) -> Rgb {
    reflected(world, material, hit, &sample_lamp(&world.lamp, hit.position, sample_unit_square(random)))
}

pub(crate) const RIGHT: Answer = Answer { sample_lamp, lamp_light, radiance };

/// The diagnosis of such points.
fn points(sample_lamp: SampleLamp) -> &'static str {
    name(check(Answer { sample_lamp, ..RIGHT }))
}

/// The diagnosis of right points with a density of distance, area and cosine.
macro_rules! density {
    ($density:expr) => {
        points(|lamp, from, u| {
            let (direction, distance, area, cosine) = seen(lamp, from, u);
            let density: fn(f32, f32, f32) -> f32 = $density;
            LampSample { direction, distance, density: density(distance, area, cosine) }
        })
    };
}

/// The diagnosis of such light.
fn light(lamp_light: LampLight) -> &'static str {
    name(check(Answer { lamp_light, ..RIGHT }))
}

/// The diagnosis of light that takes a sample by its density, its cosine at the surface and that at the lamp.
macro_rules! weight {
    ($weight:expr) => {
        light(|world, material, hit, random| {
            let u = sample_unit_square(random);
            let sample = sample_lamp(&world.lamp, hit.position, u);
            let (.., there) = seen(&world.lamp, hit.position, u);
            let weight: fn(f32, f32, f32) -> f32 = $weight;
            let weight = weight(sample.density, sample.direction.dot(hit.shading_normal), there.abs());
            if world.sees(hit, &sample) { material.diffuse * world.lamp.radiance * weight } else { Rgb::ZERO }
        })
    };
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(check(RIGHT), Ok(()));
    // The numbers of u may serve the other way round.
    let other: SampleLamp = |lamp, from, u| sample_lamp(lamp, from, Vec2::new(1.0 - u.x, 1.0 - u.y));
    assert_eq!(check(Answer { sample_lamp: other, ..RIGHT }), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    let nothing: SampleLamp = |_, _, _| LampSample { direction: Vec3::Y, distance: 1.0, density: 0.0 };
    let dark: LampLight = |_, _, _, _| Rgb::ZERO;
    let by_chance = |world: &LampWorld, ray, random: &mut Stream| world.by_chance(ray, random);
    let answer = Answer { sample_lamp: nothing, lamp_light: dark, radiance: by_chance };
    assert_eq!(name(check(answer)), "not-started");
    assert_eq!(name(check(Answer { sample_lamp, ..answer })), "light-not-started");
    assert_eq!(name(check(Answer { sample_lamp, lamp_light, ..answer })), "lamp-not-asked");
}

#[test]
fn wrong_points() {
    assert_eq!(
        points(|lamp, from, u| LampSample { direction: lamp.at(u) - from, ..sample_lamp(lamp, from, u) }),
        "not-a-unit-vector"
    );
    assert_eq!(
        points(|lamp, from, u| {
            let right = sample_lamp(lamp, from, u);
            LampSample { direction: -right.direction, ..right }
        }),
        "points-away"
    );
    assert_eq!(
        points(|lamp, from, u| {
            let right = sample_lamp(lamp, from, u);
            LampSample { distance: right.distance * right.distance, ..right }
        }),
        "distance-squared"
    );
    assert_eq!(points(|lamp, from, u| sample_lamp(lamp, from, u * 2.0)), "not-on-the-lamp");
    assert_eq!(points(|lamp, from, u| sample_lamp(lamp, from, Vec2::splat(u.x))), "not-uniform");
    assert_eq!(points(|lamp, from, u| sample_lamp(lamp, from, u * u)), "not-uniform");
    assert_eq!(points(|lamp, from, u| sample_lamp(lamp, from, u / 2.0)), "not-uniform");
}

#[test]
fn wrong_densities() {
    assert_eq!(density!(|_, area, _| 1.0 / area), "area-not-solid-angle");
    assert_eq!(density!(|d, area, _| d * d / area), "cosine-at-the-lamp-forgotten");
    assert_eq!(density!(|_, area, cosine| 1.0 / (area * cosine.abs())), "distance-forgotten");
    assert_eq!(density!(|d, area, cosine| d / (area * cosine.abs())), "distance-not-squared");
    assert_eq!(density!(|d, area, cosine| area * cosine.abs() / (d * d)), "upside-down");
    assert_eq!(density!(|d, area, cosine| d * d * cosine.abs() / area), "cosine-on-the-wrong-side");
    assert_eq!(density!(|d, area, cosine| d * d * area / cosine.abs()), "area-on-the-wrong-side");
    assert_eq!(density!(|d, _, cosine| d * d / cosine.abs()), "area-forgotten");
    assert_eq!(density!(|d, area, cosine| 2.0 * d * d / (area * cosine.abs())), "half-the-area");
    assert_eq!(density!(|d, area, cosine| d * d / (area * cosine.abs() * PI)), "pi-too-many");
    assert_eq!(density!(|d, area, cosine| d * d / (area * cosine)), "one-sided");
    assert_eq!(density!(|d, area, cosine| if cosine > 0.0 { d * d / (area * cosine) } else { 0.0 }), "one-sided");
    assert_eq!(density!(|_, _, _| f32::NAN), "wrong-density");
    assert_eq!(density!(|d, area, cosine| d * d / (area * cosine.abs())), "divided-by-zero");
}

#[test]
fn wrong_light() {
    assert_eq!(weight!(|p, c, _| c.max(0.0) / p * PI), "pi-in-the-light");
    assert_eq!(weight!(|p, c, _| c.max(0.0) / p / PI), "pi-in-the-light");
    assert_eq!(weight!(|p, c, _| if c > 0.0 { 1.0 / p } else { 0.0 }), "cosine-at-the-surface-forgotten");
    assert_eq!(weight!(|p, c, _| c / p), "below-the-horizon");
    assert_eq!(weight!(|p, c, _| c.abs() / p), "below-the-horizon");
    assert_eq!(weight!(|_, c, _| c.max(0.0)), "density-forgotten");
    assert_eq!(weight!(|p, c, _| c.max(0.0) * p), "density-multiplied");
    assert_eq!(weight!(|p, c, there| c.max(0.0) * there / p), "cosine-at-the-lamp-twice");
    assert_eq!(weight!(|p, c, _| 0.8 * c.max(0.0) / p), "wrong-light");
    assert_eq!(weight!(|_, _, _| f32::NAN), "wrong-light");
    assert_eq!(
        light(|world, material, hit, random| lamp_light(world, material, hit, random) / world.lamp.radiance),
        "radiance-forgotten"
    );
    assert_eq!(
        light(|world, material, hit, random| {
            let white = Material { diffuse: Rgb::ONE, ..*material };
            lamp_light(world, &white, hit, random)
        }),
        "surface-forgotten"
    );
}

#[test]
fn wrong_shadows() {
    assert_eq!(
        light(|world, material, hit, random| {
            let sample = sample_lamp(&world.lamp, hit.position, sample_unit_square(random));
            reflected(&LampWorld::new(world.lamp), material, hit, &sample)
        }),
        "no-shadow"
    );
    assert_eq!(
        light(|world, material, hit, random| {
            let sample = sample_lamp(&world.lamp, hit.position, sample_unit_square(random));
            let is_lit = world.sees(hit, &LampSample { distance: f32::INFINITY, ..sample });
            if is_lit { reflected(world, material, hit, &sample) } else { Rgb::ZERO }
        }),
        "shadow-from-behind"
    );
    assert_eq!(
        light(|world, material, hit, random| {
            let diffuse = if material.diffuse == Rgb::ZERO { Rgb::splat(0.1) } else { material.diffuse };
            lamp_light(world, &Material { diffuse, ..*material }, hit, random)
        }),
        "mirror-asked"
    );
}
