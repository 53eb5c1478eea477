//! Picture of exercise 3.5: soap bubbles in the evening.

use std::f32::consts::TAU;

use common::{
    Error, Rgb, Vec3, float,
    knob::{Knob, Step},
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{background::Background, pictures::stage::camera, scene::Scene, sphere::Sphere};

use super::studio::{self, Make};
use crate::checks::{
    soap_film::{Answer, Film},
    tracer::Tracer,
};

const THICKNESS: Knob =
    Knob::number("thickness", "thickness of the films at the bottom", [0.0, 2000.0], 780.0, "nm", Step::Add(10.0));

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "Soap bubbles float before an evening sky. Bands of magenta, green, gold and blue run around them, narrower \
               toward the bottom; at the very top the films are so thin that they are black.";
    let knobs = &[THICKNESS, ORBIT[0], ORBIT[1], ORBIT[2]];
    Picture { knobs, ..studio::picture("3.5-soap-film", alt, make) }
}

/// Evening: dark in front of the viewer, with a bright sky behind.
struct Evening;

impl Background for Evening {
    fn radiance(&self, direction: Vec3) -> Rgb {
        let d = direction.normalize_or(Vec3::Y);
        let dusk = Rgb::new(0.030, 0.022, 0.040).lerp(Rgb::new(0.006, 0.010, 0.030), studio::smooth(-0.2, 0.5, d.y));
        // The bright sky, with a window's bars before it.
        let sky = studio::smooth(-0.75, 0.7, d.z) * studio::smooth(-0.9, -0.1, d.y);
        let bars = |x: f32| studio::smooth(0.012, 0.035, (x - x.round()).abs());
        let window = bars(1.5 * d.x / (0.3 + d.z.abs())) * bars(1.5 * d.y / (0.3 + d.z.abs()));
        dusk + Rgb::new(6.0, 6.0, 6.2) * (sky * (0.35 + 0.65 * window))
    }
}

/// A film that gets thicker toward the bottom of its bubble, with a slow swirl.
fn film(center: Vec3, radius: f32, bottom: f32, turned: f32) -> Film {
    Box::new(move |point| {
        let p = (point - center) / radius;
        let around = float::atan2(p.x, p.z) + turned;
        let wave = 0.05 * float::sin(2.0 * around + 5.0 * p.y) + 0.03 * float::sin(5.0 * around - 9.0 * p.y + turned);
        let down = (0.97 - p.y) / 1.97;
        let edge = 1.0 - p.y * p.y;
        bottom * (down + wave * edge.max(0.0)).max(0.0)
    })
}

/// The bubbles, by what the student has written.
pub(crate) fn make(settings: &Settings, answer: Answer) -> Result<Box<dyn Render>, Error> {
    let bottom = settings.values.number(&THICKNESS);
    let mut scene = Scene::new();
    scene.surround(Evening);
    for (i, (center, radius)) in (0_u8..).zip([
        ([-1.35, 0.05, 0.0], 1.25),
        ([1.25, 0.55, -0.6], 0.9),
        ([0.55, -0.85, 0.7], 0.5),
        ([2.55, -0.75, 0.1], 0.62),
        ([-3.1, -0.75, 0.3], 0.36),
        ([-2.95, 1.15, -0.8], 0.45),
        ([0.25, 1.35, -1.5], 0.34),
        ([2.75, 1.35, -1.2], 0.3),
        ([-0.25, -1.3, -0.3], 0.2),
        ([1.55, -1.35, 0.4], 0.16),
    ]) {
        let center = Vec3::from_array(center);
        let turned = TAU * 0.37 * f32::from(i);
        let bottom = bottom * (0.8 + 0.3 * float::sin(7.0 * turned));
        scene.add("bubble", Sphere::new(center, radius), film(center, radius, bottom, turned));
    }
    Ok(Box::new(Tracer {
        scene,
        camera: camera([0.0, 0.2, 9.0], [0.0, 0.0, 0.0], 26.0, &settings.values)?,
        optics: answer,
        max_depth: 12,
        min_weight: 1.0 / 256.0,
    }))
}
