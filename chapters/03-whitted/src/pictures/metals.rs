//! Gold, silver and copper side by side.

use common::{
    Error, Rgb, Stream, Vec3,
    film::Size,
    knob::Knob,
    picture::{FilmPoint, Integrator, ORBIT, Picture, Render, Settings},
    story::Story,
};
use ray_casting::{frame::Frame, pictures::stage, quadric::Quadric, sphere::Sphere};

use super::studio::{paper, seen};
use crate::{
    material::{Fresnel, Material},
    whitted::{Limits, Whitted},
};

const FRESNEL: Knob = Knob::choice(
    "fresnel",
    "which formula says how much is reflected, or ten times their difference",
    &["exact", "approximate", "difference"],
    0,
);

pub(super) const PICTURE: Picture = Picture {
    name: "metals",
    alt: "Three balls of gold, silver and copper in a row on white paper, each with a small bowl of the same metal in \
          front of it. They mirror the paper, two bright soft boxes and each other: gold yellow, silver nearly white, \
          copper reddish. Toward its rim each ball loses its color and becomes as light as the paper behind.",
    knobs: &[FRESNEL, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 480>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    Ok(match settings.values.index(&FRESNEL) {
        0 => Box::new(view(settings, Fresnel::Exact)?),
        1 => Box::new(view(settings, Fresnel::Approximate)?),
        _ => Box::new(Difference([view(settings, Fresnel::Exact)?, view(settings, Fresnel::Approximate)?])),
    })
}

fn view(settings: &Settings, fresnel: Fresnel) -> Result<Whitted, Error> {
    let mut scene = paper();
    for (name, metal, x) in
        [("gold", Material::GOLD, -2.45), ("silver", Material::SILVER, -0.2), ("copper", Material::COPPER, 2.05)]
    {
        let bowl = Quadric::paraboloid(0.36, 0.3);
        scene.add(name, Sphere::new(Vec3::new(x, 0.85, 0.0), 0.85), metal);
        scene.add(name, bowl.placed(Frame::at(Vec3::new(x + 0.6, 0.0, 1.25))), metal);
    }
    let camera = stage::camera([0.1, 2.0, 9.0], [0.1, 0.85, 0.0], 25.0, &settings.values)?;
    Ok(Whitted { fresnel, ..seen(scene, camera, Limits::DEFAULT) })
}

/// How much two pictures differ, ten times as bright.
struct Difference([Whitted; 2]);

impl Integrator for Difference {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let [exact, approximate] = &self.0;
        (exact.radiance(point, random, story) - approximate.radiance(point, random, story)).abs() * 10.0
    }
}
