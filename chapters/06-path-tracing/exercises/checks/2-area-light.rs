//! Checks exercise 6.2, a lamp with a size.

use common::{
    Rgb, Stream, Vec2, Vec3,
    exercise::{Diagnosis, Verdict},
};
use path_tracing::material::Material;
use ray_casting::{hit::Hit, ray::Ray};

use super::{
    lamp::{Lamp, LampSample},
    lamp_light::light,
    lamp_paths::paths,
    lamp_points::points,
    lamp_world::LampWorld,
};

/// What the student writes.
#[derive(Clone, Copy)]
pub(crate) struct Answer {
    /// A point of the lamp, by the place from which it is seen and a point of the square.
    pub(crate) sample_lamp: fn(&Lamp, Vec3, Vec2) -> LampSample,
    /// The light of the lamp, by world, material and hit.
    pub(crate) lamp_light: fn(&LampWorld, &Material, &Hit, &mut Stream) -> Rgb,
    /// All light, by world and ray.
    pub(crate) radiance: fn(&LampWorld, Ray, &mut Stream) -> Rgb,
}

/// Accept a lamp, or name what is wrong with it.
pub(crate) fn check(answer: Answer) -> Verdict {
    let lamp = Lamp::around(Vec3::Y * 2.0, [Vec3::X, Vec3::Z], Rgb::ONE);
    // From below and from above.
    let is_dark = |from: f32| (answer.sample_lamp)(&lamp, Vec3::Y * from, Vec2::new(0.2, 0.3)).density == 0.0;
    if [0.0, 4.0].into_iter().all(is_dark) {
        return Err(Diagnosis::not_started("`sample_lamp` returns the density 0, whatever it is asked."));
    }
    points(answer.sample_lamp)?;
    light(answer.lamp_light)?;
    paths(answer.radiance)
}
