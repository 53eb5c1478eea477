//! The cover: the still life of chapter 1, now with shadows.

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    film::Size,
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{
    light::{DirectionalLight, PointLight},
    material::Phong,
    pictures::still_life,
    scene::Scene,
};

use crate::{direct_light::DirectLight, offset::Offset};

pub use ray_casting::pictures::still_life::view;

// ANCHOR: picture
pub(super) const PICTURE: Picture = Picture {
    name: "still-life",
    alt: "The still life of chapter 1 by the light of a low warm lamp on the left: the vase, the tube, the cone, the bowl \
          with the red ball, the goblet, the egg and the crystals throw long shadows to the right, over the floor and \
          over each other. A faint cool light fills the shadows.",
    knobs: &ORBIT,
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let (scene, camera) = (scene()?, view(settings)?);
    Ok(Box::new(DirectLight { scene, camera, offset: Offset::Following }))
}
// ANCHOR_END: picture

/// The still life of chapter 1 in another light: a low warm lamp, and a faint cool moon from the other side.
///
/// # Errors
/// As for the scene of chapter 1.
pub fn scene() -> Result<Scene<Phong>, Error> {
    let mut scene = still_life::scene()?;
    scene.lights.clear();
    scene.ambient = Rgb::new(0.06, 0.078, 0.12);
    scene.light(PointLight { position: Vec3::new(-4.9, 3.7, 4.4), intensity: Rgb::new(205.0, 155.0, 104.0) });
    scene.light(DirectionalLight::new(Vec3::new(0.8, 0.9, 0.1), Rgb::new(0.3, 0.44, 0.78)));
    let floor = Phong::of(srgb(128, 116, 106), 0.0, 1.0);
    if let Some(object) = scene.objects.first_mut() {
        object.material = floor;
    }
    scene.surround(floor.ambient * scene.ambient);
    Ok(scene)
}
