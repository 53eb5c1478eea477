//! Picture of exercise 3.4: a heap of glass balls, twice.

use common::{
    Error, Rgb, Stream, Vec3,
    color::srgb,
    knob::{Knob, Step},
    picture::{FilmPoint, Integrator, ORBIT, Panels, Picture, Render, Settings},
    story::Story,
};
use ray_casting::{light::PointLight, material::Phong, pictures::stage::camera, scene::Scene, sphere::Sphere};
use shadows::offset::Offset;
use whitted::{
    branches::Branch,
    material::{Fresnel, Material},
    whitted::{Limits, Terms, Whitted},
};

use super::studio::{self, Ground, Make, Studio};
use crate::checks::world::{Trace, depth_first};

const BUDGET: Knob = Knob::number("budget", "rays for each camera ray", [0.0, 500.0], 10.0, "rays", Step::Whole);

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A heap of glass and metal balls, twice, with the same number of rays for each point. On the left they are spent \
               depth-first, and the lower balls are full of wrong patches. On the right they are spent on what contributes \
               most, and the balls are clear.";
    let knobs = &[BUDGET, ORBIT[0], ORBIT[1], ORBIT[2]];
    Picture { knobs, samples: 9, ..studio::picture("3.4-budget", alt, make) }
}

/// A scene whose rays are spent by a search.
struct Searched {
    world: Whitted,
    trace: Trace,
    budget: u32,
}

impl Integrator for Searched {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, _story: &mut impl Story) -> Rgb {
        (self.trace)(&self.world, Branch::from_camera(self.world.camera.ray(point)), self.budget)
    }
}

/// The heap by depth-first search, and by the student's.
pub(crate) fn make(settings: &Settings, trace: Trace) -> Result<Box<dyn Render>, Error> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the knob's range")]
    let budget = settings.values.number(&BUDGET) as u32;
    let panel = |trace: Trace| -> Result<Box<dyn Render>, Error> {
        Ok(Box::new(Searched { world: heap(settings)?, trace, budget }))
    };
    Ok(Box::new(Panels::new(2, vec![panel(depth_first)?, panel(trace)?])))
}

/// A pyramid of balls on a table.
fn heap(settings: &Settings) -> Result<Whitted, Error> {
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.5, 0.5, 0.55);
    scene.surround(Studio {
        low: Rgb::new(0.10, 0.13, 0.20),
        high: Rgb::new(0.55, 0.62, 0.80),
        lamps: Rgb::new(2.4, 2.2, 1.9),
    });
    scene.light(PointLight { position: Vec3::new(-4.0, 8.0, 4.0), intensity: Rgb::new(110.0, 104.0, 94.0) });
    let rough = |red, green, blue| Material::rough(Phong::of(srgb(red, green, blue), 0.0, 1.0));
    // Tiles of two colors.
    fn is_red(x: f32, z: f32) -> bool {
        (x.floor() + z.floor()).rem_euclid(2.0) == 0.0
    }
    scene.add("red tiles", Ground { half: 4.0, shows: is_red }, rough(206, 96, 62));
    scene.add("light tiles", Ground { half: 4.0, shows: |x, z| !is_red(x, z) }, rough(236, 222, 196));
    // Balls of radius 1/2 in layers: those of a layer lie in the hollows of the layer below.
    let step = 0.5_f32.sqrt();
    for (layer, count) in [(0.0, 3_u8), (1.0, 2), (2.0, 1)] {
        for i in 0..count {
            for k in 0..count {
                let [x, z] = [i, k].map(|i| f32::from(i) - f32::from(count - 1) / 2.0);
                let material = match (count, i, k) {
                    (3, 0, 2) | (3, 2, 0) => Material::GOLD,
                    (3, 1, 1) => Material::SILVER,
                    _ => Material::glass(1.5),
                };
                scene.add("ball", Sphere::new(Vec3::new(x, 0.5 + layer * step, z), 0.499), material);
            }
        }
    }
    Ok(Whitted {
        scene,
        camera: camera([2.3, 3.1, 5.6], [0.0, 0.78, 0.0], 32.0, &settings.values)?,
        limits: Limits::DEFAULT,
        terms: Terms::ALL,
        fresnel: Fresnel::Exact,
        offset: Offset::Following,
    })
}
