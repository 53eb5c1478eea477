//! Picture of exercise 2.2: the still life in white clay under a gray sky.

use std::f32::consts::TAU;

use common::{
    Error, Interval, Rgb, Stream, Vec3, float,
    knob::{Knob, Step},
    picture::{FilmPoint, Integrator, ORBIT, Picture, Render, Settings},
    story::{Story, number},
};
use ray_casting::{
    camera::Camera,
    hit::Hit,
    local_illumination::{tell_hit, tell_ray},
    material::Phong,
    pictures::still_life::{scene, view},
    scene::Scene,
};

use super::Make;

const REACH: Knob =
    Knob::number("reach", "what lies farther away hides nothing", [0.01, 100.0], 2.0, "units", Step::Times(1.25));

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "The still life in white clay on a white floor, without any lamp. It is dark where things stand close together, \
               inside the bowl and the tube and in the creases of the crystals, and soft dark rings lie around everything on \
               the floor.";
    let knobs = &[REACH, ORBIT[0], ORBIT[1], ORBIT[2]];
    Picture { knobs, ..super::picture("2.2-ambient-occlusion", alt, make) }
}

/// A scene lit by openness alone.
struct Clay<F> {
    scene: Scene<Phong>,
    camera: Camera,
    reach: f32,
    openness: F,
}

impl<F: Fn(&Scene<Phong>, &Hit, &[Vec3], f32) -> f32 + Send + Sync> Integrator for Clay<F> {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        const OPEN: Rgb = Rgb::new(0.80, 0.79, 0.76);
        let ray = self.camera.ray(point);
        tell_ray(story, &ray);
        let Some((hit, object)) = self.scene.intersect(&ray, Interval::POSITIVE) else { return OPEN };
        tell_hit(story, &hit, object);
        let directions = [(); 4].map(|()| even_direction(random));
        let openness = (self.openness)(&self.scene, &hit, &directions, self.reach);
        story.tell(|| format!("openness {}", number(openness)));
        OPEN * openness
    }
}

/// A unit vector; all directions are equally likely.
fn even_direction(random: &mut Stream) -> Vec3 {
    // Slices of a sphere of equal height have equal area.
    let (height, angle) = (2.0 * random.uniform() - 1.0, TAU * random.uniform());
    let across = (1.0 - height * height).sqrt();
    Vec3::new(across * float::cos(angle), height, across * float::sin(angle))
}

/// The still life, lit by what `openness` says of scene, hit, directions and reach.
pub(crate) fn make<F: Fn(&Scene<Phong>, &Hit, &[Vec3], f32) -> f32 + Send + Sync + 'static>(
    settings: &Settings,
    openness: F,
) -> Result<Box<dyn Render>, Error> {
    let reach = settings.values.number(&REACH);
    Ok(Box::new(Clay { scene: scene()?, camera: view(settings)?, reach, openness }))
}
