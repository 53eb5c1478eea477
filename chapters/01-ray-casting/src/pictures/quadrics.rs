//! The six quadrics.

use common::{
    Error, Vec3,
    color::srgb,
    film::Size,
    picture::{ORBIT, Picture, Render, Settings},
};

use super::stage::{camera, stage};
use crate::{
    frame::Frame,
    local_illumination::{LocalIllumination, Terms},
    material::Phong,
    quadric::Quadric,
};

pub(super) const PICTURE: Picture = Picture {
    name: "quadrics",
    alt: "Six surfaces in a row: an egg-shaped ellipsoid, an open cylinder, a cone, a paraboloid that is a bowl, a \
          hyperboloid of one sheet that is a waisted tower, and a hyperboloid of two sheets, a bowl upon a dome.",
    knobs: &ORBIT,
    size: Size::of::<960, 400>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let gallery = [
        ("ellipsoid", Quadric::ellipsoid(Vec3::new(0.45, 0.7, 0.45)), 0.7, srgb(232, 186, 62)),
        ("cylinder", Quadric::cylinder(0.42, 1.4), 0.0, srgb(226, 212, 184)),
        ("cone", Quadric::cone(0.5, 1.4), 0.0, srgb(52, 140, 140)),
        ("paraboloid", Quadric::paraboloid(0.5, 1.4), 0.0, srgb(150, 74, 118)),
        ("hyperboloid of one sheet", Quadric::hyperboloid_of_one_sheet(0.25, 0.42, 0.7), 0.7, srgb(206, 108, 74)),
        ("hyperboloid of two sheets", Quadric::hyperboloid_of_two_sheets(0.14, 0.18, 0.7), 0.7, srgb(186, 140, 66)),
    ];
    let mut scene = stage()?;
    for ((name, quadric, height, color), x) in gallery.into_iter().zip([-2.8, -1.68, -0.56, 0.56, 1.68, 2.8]) {
        scene.add(name, quadric.placed(Frame::at(Vec3::new(x, height, 0.0))), Phong::of(color, 0.5, 50.0));
    }
    let camera = camera([0.0, 3.1, 8.0], [0.0, 0.68, 0.0], 20.5, &settings.values)?;
    Ok(Box::new(LocalIllumination { scene, camera, terms: Terms::ALL }))
}
