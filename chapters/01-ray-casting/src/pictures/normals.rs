//! Normals as colours.

use common::{
    Error, Interval, Rgb, Stream,
    film::Size,
    picture::{FilmPoint, Integrator, ORBIT, Picture, Render, Settings},
    story::{Story, triple},
};

use super::still_life;
use crate::{
    camera::Camera,
    local_illumination::{tell_hit, tell_ray},
    material::Phong,
    scene::Scene,
};

pub(super) const PICTURE: Picture = Picture {
    name: "normals",
    alt: "The still life with each point coloured by the direction of its normal: red grows to the right, green \
          upward, blue toward the viewer. The floor is one even green, round shapes blend through all colours, each \
          facet of the crystals has one colour.",
    knobs: &ORBIT,
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    Ok(Box::new(Normals { scene: still_life::scene()?, camera: still_life::view(settings)? }))
}

/// Shows the shading normals of a scene.
struct Normals {
    scene: Scene<Phong>,
    camera: Camera,
}

// ANCHOR: normals
impl Integrator for Normals {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = self.camera.ray(point);
        tell_ray(story, &ray);
        let Some((hit, object)) = self.scene.intersect(&ray, Interval::POSITIVE) else { return Rgb::ZERO };
        tell_hit(story, &hit, object);
        // Coordinates run from −1 to 1, colours from 0 to 1.
        let color = (hit.shading_normal + 1.0) / 2.0;
        story.tell(|| format!("(normal + 1) / 2 = {}", triple(color)));
        color * color
    }
}
// ANCHOR_END: normals
