//! Pictures that show what a hit knows.

use common::{
    Error, Interval, Rgb, Stream,
    picture::{FilmPoint, Integrator, Render, Settings},
    story::{Story, triple},
};

use super::still_life;
use crate::{
    camera::Camera,
    hit::Hit,
    local_illumination::{tell_hit, tell_ray},
    material::Phong,
    scene::Scene,
};

/// The still life, each point in a color that follows from its hit alone; black where nothing is hit.
pub(super) fn still_life_by(color: fn(&Hit) -> Rgb, settings: &Settings) -> Result<Box<dyn Render>, Error> {
    Ok(Box::new(ByHit { scene: still_life::scene()?, camera: still_life::view(settings)?, color }))
}

struct ByHit {
    scene: Scene<Phong>,
    camera: Camera,
    color: fn(&Hit) -> Rgb,
}

// ANCHOR: radiance
impl Integrator for ByHit {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = self.camera.ray(point);
        tell_ray(story, &ray);
        let Some((hit, object)) = self.scene.intersect(&ray, Interval::POSITIVE) else { return Rgb::ZERO };
        tell_hit(story, &hit, object);
        let color = (self.color)(&hit);
        story.tell(|| format!("shown as {}", triple(color)));
        color
    }
}
// ANCHOR_END: radiance
