//! What a hit knows: how far, and on which side.

use common::{
    Error, Interval, Rgb, Stream,
    color::srgb,
    film::Size,
    picture::{FilmPoint, Integrator, ORBIT, Picture, Render, Settings},
    story::{Story, number},
};

use super::still_life;
use crate::{
    camera::Camera,
    hit::Side,
    local_illumination::{tell_hit, tell_ray},
    material::Phong,
    scene::Scene,
};

pub(super) const PICTURE: Picture = Picture {
    name: "hits",
    alt: "The still life drawn by what each hit knows: blue where a ray met the outside of a surface, orange where it \
          met the inside, as in the open tube, the bowl and the vase; darker the farther away.",
    knobs: &ORBIT,
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    Ok(Box::new(Hits { scene: still_life::scene()?, camera: still_life::view(settings)? }))
}

/// Shows side and distance of the nearest hits.
struct Hits {
    scene: Scene<Phong>,
    camera: Camera,
}

impl Integrator for Hits {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        /// Distances at which the colour is full and at which it is gone, in scene units.
        const FADE: [f32; 2] = [7.0, 12.0];
        let ray = self.camera.ray(point);
        tell_ray(story, &ray);
        let Some((hit, object)) = self.scene.intersect(&ray, Interval::POSITIVE) else { return Rgb::ZERO };
        tell_hit(story, &hit, object);
        let color = match hit.side {
            Side::Outside => srgb(120, 175, 235),
            Side::Inside => srgb(255, 150, 60),
        };
        let nearness = ((FADE[1] - hit.t) / (FADE[1] - FADE[0])).clamp(0.0, 1.0);
        story.tell(|| format!("colour of its side, times nearness {}", number(nearness)));
        color * nearness
    }
}
