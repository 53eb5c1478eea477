//! One sphere: the first shape.

use common::{
    Error, Vec3,
    color::srgb,
    film::Size,
    picture::{ORBIT, Picture, Render, Settings},
};

use super::stage::{camera, stage};
use crate::{
    local_illumination::{LocalIllumination, Terms},
    material::Phong,
    sphere::Sphere,
};

pub(super) const PICTURE: Picture = Picture {
    name: "sphere",
    alt: "One red ball on a dark stage, bright where it faces the warm lamp at the upper right, with a cool rim of \
          sunlight at the left and a small highlight from each light.",
    knobs: &ORBIT,
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let mut scene = stage()?;
    let red = Phong::of(srgb(190, 40, 48), 0.6, 60.0);
    scene.add("ball", Sphere::new(Vec3::Y, 1.0), red);
    let camera = camera([0.0, 1.9, 6.5], [0.0, 0.9, 0.0], 30.0, &settings.values)?;
    Ok(Box::new(LocalIllumination { scene, camera, terms: Terms::ALL }))
}
