//! The exponent of the highlight.

use common::{
    Error, Vec3,
    color::srgb,
    film::Size,
    knob::{Knob, Step},
    picture::{ORBIT, Picture, Render, Settings},
};

use super::stage::{camera, stage};
use crate::{
    local_illumination::{LocalIllumination, Terms},
    material::Phong,
    sphere::Sphere,
};

const FIRST: Knob = Knob::number("first", "exponent of the leftmost ball", [1.0, 100.0], 4.0, "", Step::Whole);
const FACTOR: Knob =
    Knob::number("factor", "by which the exponent grows from ball to ball", [1.0, 10.0], 4.0, "", Step::Add(0.5));

pub(super) const PICTURE: Picture = Picture {
    name: "shininess",
    alt: "Five equal green balls in a row with shininess 4, 16, 64, 256 and 1024. The highlight shrinks from a wide \
          dull gleam on the left to a sharp small point on the right.",
    knobs: &[FIRST, FACTOR, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 320>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let mut scene = stage()?;
    let mut shininess = settings.values.number(&FIRST);
    for x in [-2.2, -1.1, 0.0, 1.1, 2.2] {
        let material = Phong::of(srgb(40, 122, 88), 0.8, shininess);
        scene.add("ball", Sphere::new(Vec3::new(x, 0.5, 0.0), 0.5), material);
        shininess *= settings.values.number(&FACTOR);
    }
    let camera = camera([0.0, 2.2, 8.0], [0.0, 0.46, 0.0], 13.6, &settings.values)?;
    Ok(Box::new(LocalIllumination { scene, camera, terms: Terms::ALL }))
}
