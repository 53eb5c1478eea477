//! Picture of exercise 2.1: balls in the evening sun.

use std::f32::consts::TAU;

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    float,
    picture::{Picture, Render, Settings},
};
use ray_casting::{
    light::DirectionalLight,
    material::Phong,
    pictures::stage::{camera, square},
    scene::Scene,
    shape::Shape,
};
use shadows::{direct_light::DirectLight, offset::Offset};

use super::Make;

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A spiral of balls on a pale floor, small and dark red in the middle, larger and yellow, then white outward. A low \
               evening sun draws long blue shadows, which climb over the neighboring balls.";
    super::picture("2.1-any-hit", alt, make)
}

/// The spiral, with balls that `ball` makes of a center and a radius.
pub(crate) fn make<S: Shape + 'static>(
    settings: &Settings,
    ball: impl Fn(Vec3, f32) -> S,
) -> Result<Box<dyn Render>, Error> {
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.14, 0.19, 0.34);
    scene.surround(Rgb::new(0.30, 0.34, 0.46));
    scene.light(DirectionalLight::new(Vec3::new(-0.86, 0.36, -0.36), Rgb::new(4.4, 3.4, 2.3)));
    scene.add("floor", square(0.0, 400.0)?, Phong::of(srgb(196, 186, 172), 0.0, 1.0));
    const BALLS: u8 = 72;
    let colors = [srgb(140, 30, 40), srgb(210, 84, 44), srgb(236, 178, 62), srgb(232, 222, 200)];
    for i in 0..BALLS {
        let share = f32::from(i) / f32::from(BALLS - 1);
        // Each ball turns by the golden angle, like the seeds of a sunflower.
        let angle = f32::from(i) * TAU * 0.381_966;
        let (radius, away) = (0.07 + 0.15 * share, 2.55 * (share + 0.004).sqrt());
        let center = Vec3::new(away * float::cos(angle), radius, away * float::sin(angle));
        scene.add("ball", ball(center, radius), Phong::of(mixed(&colors, share), 0.5, 60.0));
    }
    let camera = camera([0.9, 3.9, 6.4], [0.12, -0.12, 0.2], 31.0, &settings.values)?;
    Ok(Box::new(DirectLight { scene, camera, offset: Offset::Following }))
}

/// A color between the first at share 0 and the last at share 1.
fn mixed(colors: &[Rgb; 4], share: f32) -> Rgb {
    let along = share * 3.0;
    let colors = colors.windows(2).zip([0.0, 1.0, 2.0]);
    colors.fold(Rgb::ZERO, |mixed, (pair, start)| {
        let part = along - start;
        if part >= 0.0 { pair[0].lerp(pair[1], part.min(1.0)) } else { mixed }
    })
}
