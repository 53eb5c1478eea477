//! The cover: all shapes of the chapter on one stage.

use common::{
    Error, Vec3,
    color::srgb,
    film::Size,
    picture::{ORBIT, Picture, Render, Settings},
};

use super::stage::{camera, crystals, stage};
use crate::{
    camera::Camera,
    frame::Frame,
    local_illumination::{LocalIllumination, Terms},
    material::Phong,
    quadric::Quadric,
    scene::Scene,
    sphere::Sphere,
};

// ANCHOR: picture
pub(super) const PICTURE: Picture = Picture {
    name: "still-life",
    alt: "A still life on a dark stage: a tall waisted vase, an open tube, a cone, a bowl with a red ball in it, a \
          goblet of two bowls, a yellow egg and a cluster of blue crystals, lit cool from the left and warm from the right. \
          Nothing casts a shadow.",
    knobs: &ORBIT,
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let (scene, camera) = (scene()?, view(settings)?);
    Ok(Box::new(LocalIllumination { scene, camera, terms: Terms::ALL }))
}
// ANCHOR_END: picture

/// The camera of the still life.
pub fn view(settings: &Settings) -> Result<Camera, Error> {
    camera([0.1, 3.4, 8.6], [-0.02, 0.86, 0.0], 22.5, &settings.values)
}

// ANCHOR: scene
/// All shapes of the chapter, each of its own color.
pub fn scene() -> Result<Scene<Phong>, Error> {
    let clay = Phong::of(srgb(206, 108, 74), 0.25, 24.0);
    let teal = Phong::of(srgb(52, 140, 140), 0.6, 60.0);
    let cream = Phong::of(srgb(226, 212, 184), 0.35, 40.0);
    let plum = Phong::of(srgb(150, 74, 118), 0.5, 80.0);
    let lemon = Phong::of(srgb(232, 186, 62), 0.5, 90.0);
    let cherry = Phong::of(srgb(190, 40, 48), 0.9, 160.0);
    let brass = Phong::of(srgb(186, 140, 66), 0.9, 120.0);
    let sapphire = Phong::of(srgb(60, 104, 200), 0.9, 50.0);

    let mut scene = stage()?;
    let vase = Quadric::hyperboloid_of_one_sheet(0.3, 0.62, 1.05).placed(Frame::at(Vec3::new(-0.85, 1.05, -0.7)));
    let tube = Quadric::cylinder(0.36, 1.35).placed(Frame::at(Vec3::new(0.62, 0.0, -1.25)));
    let cone = Quadric::cone(0.52, 1.7).placed(Frame::at(Vec3::new(1.7, 0.0, -0.7)));
    let bowl = Quadric::paraboloid(0.72, 0.6).placed(Frame::at(Vec3::new(0.35, 0.0, 0.35)));
    let goblet = Quadric::hyperboloid_of_two_sheets(0.12, 0.16, 0.55).placed(Frame::at(Vec3::new(-2.1, 0.55, 0.1)));
    let egg = Quadric::ellipsoid(Vec3::new(0.42, 0.3, 0.3))
        .placed(Frame::at(Vec3::new(-0.85, 0.3, 0.95)).turned(Vec3::Y, 28.0));
    let stone = crystals(Vec3::new(1.42, 0.0, 0.75), 0.8)?;
    scene
        .add("vase (hyperboloid of one sheet)", vase, clay)
        .add("tube (cylinder)", tube, cream)
        .add("cone", cone, teal)
        .add("bowl (paraboloid)", bowl, plum)
        .add("ball (sphere)", Sphere::new(Vec3::new(0.38, 0.66, 0.35), 0.34), cherry)
        .add("goblet (hyperboloid of two sheets)", goblet, brass)
        .add("egg (ellipsoid)", egg, lemon)
        .add("crystals (mesh)", stone, sapphire);
    Ok(scene)
}
// ANCHOR_END: scene
