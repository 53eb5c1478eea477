//! One scene at the depths 0 to 7.

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    film::Size,
    picture::{ORBIT, Panels, Picture, Render, Settings},
};
use ray_casting::{light::PointLight, material::Phong, pictures::stage, scene::Scene, sphere::Sphere};

use super::disc::Disc;
use super::studio::{evening, seen, wall};
use crate::{material::Material, whitted::Limits};

pub(super) const PICTURE: Picture = Picture {
    name: "depths",
    alt: "Two tall mirrors meet at an angle of 30°, with a glass ball, a red and a blue ball between them; eight \
          times, with recursion depth 0 to 7. At depth 0 the mirrors and the glass ball show nothing but sea and sky. \
          With each step one more image of the wedge appears on either side, until at depth 6 they close to a ring of \
          twelve. Each image of the glass ball shows sea and sky at first, and looks like glass only two steps later.",
    knobs: &ORBIT,
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let view = |max_depth| -> Result<Box<dyn Render>, Error> {
        let camera = stage::camera([0.0, 2.3, 4.3], [0.0, 0.0, 0.75], 66.0, &settings.values)?;
        Ok(Box::new(seen(scene()?, camera, Limits { max_depth, ..Limits::DEFAULT })))
    };
    Ok(Box::new(Panels::new(4, (0..8).map(view).collect::<Result<_, _>>()?)))
}

/// Two mirrors at an angle of a twelfth of a turn, and a few things between them.
fn scene() -> Result<Scene<Material>, Error> {
    let porcelain = |color| Material::coated(Phong::of(color, 0.0, 1.0), 1.5);
    // Where the mirrors end: 15° from the middle on either side.
    let [left, right] = [-1.0, 1.0].map(|side| Vec3::new(side * 0.2588, 0.0, 0.9659) * 4.6);
    let mut scene = evening();
    scene.light(PointLight { position: Vec3::new(0.0, 3.4, 3.0), intensity: Rgb::new(27.0, 24.0, 20.0) });
    let floor = Disc { center: Vec3::ZERO, inner: 0.0, outer: 4.6 };
    scene
        .add("floor", floor, Material::rough(Phong::of(srgb(140, 130, 124), 0.0, 1.0)))
        .add("left mirror", wall(left, Vec3::ZERO, 4.0)?, Material::SILVER)
        .add("right mirror", wall(Vec3::ZERO, right, 4.0)?, Material::SILVER)
        .add("glass", Sphere::new(Vec3::new(0.1, 0.38, 2.1), 0.38), Material::glass(1.5))
        .add("red porcelain", Sphere::new(Vec3::new(-0.18, 0.17, 1.5), 0.17), porcelain(srgb(176, 34, 36)))
        .add("blue porcelain", Sphere::new(Vec3::new(-0.42, 0.2, 2.7), 0.2), porcelain(srgb(30, 70, 170)));
    Ok(scene)
}
