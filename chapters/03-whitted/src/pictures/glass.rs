//! Glass, thin glass, and air in water.

use common::{
    Error, Vec3,
    film::Size,
    picture::{ORBIT, Panels, Picture, Render, Settings},
};
use ray_casting::{frame::Frame, pictures::stage, scene::Scene, sphere::Sphere};

use super::studio::{DEPTH, limits, paper, pencils, seen};
use crate::{material::Material, whitted::Whitted};

pub(super) const PICTURE: Picture = Picture {
    name: "glass",
    alt: "A row of nine colored pencils, three times. Left, through a solid glass ball: the pencils are upside down \
          and in reverse order. Middle, through a hollow glass ball: they are upright and somewhat smaller. Right, \
          through a block of water with four air bubbles: straight in the water, tiny and upright in the largest \
          bubble, whose rim shines like a mirror because of total reflection.",
    knobs: &[DEPTH, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 340>(),
    samples: 8,
    takes_mesh: false,
    make,
};

/// Refractive indices relative to air.
const GLASS: f32 = 1.5;
const WATER: f32 = 1.333;

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let panel = |things| -> Result<Box<dyn Render>, Error> { Ok(Box::new(panel(settings, things)?)) };
    Ok(Box::new(Panels::new(3, vec![panel(solid)?, panel(hollow)?, panel(bubbles)?])))
}

/// Puts the things of one panel into its scene.
pub type Things = fn(&mut Scene<Material>) -> Result<(), Error>;

/// A panel: some things before the pencils.
///
/// # Errors
/// [`Error::Picture`] if a thing or the camera cannot be made.
pub fn panel(settings: &Settings, things: Things) -> Result<Whitted, Error> {
    let mut scene = paper();
    pencils(&mut scene, -3.0, 1.5);
    things(&mut scene)?;
    let camera = stage::camera([0.0, 1.35, 7.0], [0.0, 0.9, 0.0], 21.0, &settings.values)?;
    Ok(seen(scene, camera, limits(settings, &DEPTH)))
}

// ANCHOR: things
/// A ball of glass.
///
/// # Errors
/// None; the other panels have some.
pub fn solid(scene: &mut Scene<Material>) -> Result<(), Error> {
    scene.add("glass", Sphere::new(Vec3::Y * 0.9, 0.9), Material::glass(GLASS));
    Ok(())
}

/// A ball of glass with a ball of air in it: the inner surface leads from glass into air.
fn hollow(scene: &mut Scene<Material>) -> Result<(), Error> {
    scene.add("glass", Sphere::new(Vec3::Y * 0.9, 0.9), Material::glass(GLASS)).add(
        "air in the glass",
        Sphere::new(Vec3::Y * 0.9, 0.8),
        Material::glass(1.0 / GLASS),
    );
    Ok(())
}

/// A block of water with bubbles of air in it.
fn bubbles(scene: &mut Scene<Material>) -> Result<(), Error> {
    let (center, half) = (Vec3::new(0.0, 0.885, 0.0), Vec3::new(0.86, 0.865, 0.5));
    scene.add("water", stage::block(Frame::at(center), half)?, Material::glass(WATER));
    for (x, y, z, radius) in
        [(0.0, 0.85, 0.0, 0.5), (-0.58, 1.35, 0.1, 0.14), (0.6, 0.45, 0.2, 0.11), (0.5, 1.45, -0.1, 0.08)]
    {
        scene.add("air in the water", Sphere::new(Vec3::new(x, y, z), radius), Material::glass(1.0 / WATER));
    }
    Ok(())
}
// ANCHOR_END: things
