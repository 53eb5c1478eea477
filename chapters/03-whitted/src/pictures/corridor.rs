//! Two mirrors that face each other.

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    film::Size,
    knob::Knob,
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{
    frame::Frame, light::PointLight, material::Phong, pictures::stage, quadric::Quadric, scene::Scene, sphere::Sphere,
};

use super::studio::{depth, limits, seen, terrace, wall};
use crate::material::Material;

const DEPTH: Knob = depth(100.0);
const METAL: Knob = Knob::choice("metal", "of both mirrors", &["gold", "silver", "copper"], 0);

pub(super) const PICTURE: Picture = Picture {
    name: "corridor",
    alt: "Two large gold mirrors in wooden frames face each other. Between them stand two pale columns and a blue \
          ball, on a terrace at sea in the evening. The mirror in front shows a straight corridor of frames, columns \
          and balls that goes on without end, with each step more yellow, then orange, red and at last black.",
    knobs: &[DEPTH, METAL, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let metal = [Material::GOLD, Material::SILVER, Material::COPPER][settings.values.index(&METAL).min(2)];
    let camera = stage::camera([0.5, 1.25, 1.4], [0.1, 1.15, 0.0], 62.0, &settings.values)?;
    Ok(Box::new(seen(scene(metal)?, camera, limits(settings, &DEPTH))))
}

/// Two columns and a ball between two mirrors.
fn scene(metal: Material) -> Result<Scene<Material>, Error> {
    let porcelain = |color| Material::coated(Phong::of(color, 0.0, 1.0), 1.5);
    let wood = Material::rough(Phong::of(srgb(120, 66, 40), 0.2, 20.0));
    let mut scene = terrace();
    scene.light(PointLight { position: Vec3::new(0.0, 2.6, 0.0), intensity: Rgb::new(9.5, 8.7, 7.5) });
    for side in [-1.0, 1.0] {
        let [left, right] = [-1.0, 1.0].map(|end| Vec3::new(1.9 * side * end, 0.0, -1.5 * side));
        scene.add("mirror", wall(left, right, 2.5)?, metal);
        let out = Vec3::new(0.14 * side, 0.0, 0.0);
        let back = Vec3::new(0.0, -0.12, -0.02 * side);
        scene.add("frame", wall(left - out + back, right + out + back, 2.75)?, wood);
        let column = Quadric::cylinder(0.16, 2.2).placed(Frame::at(Vec3::new(1.45 * side, 0.0, 0.0)));
        scene.add("column (cylinder)", column, Material::rough(Phong::of(srgb(186, 172, 152), 0.0, 1.0)));
    }
    scene.add("ball", Sphere::new(Vec3::new(-0.65, 0.4, -0.3), 0.4), porcelain(srgb(24, 92, 120)));
    Ok(scene)
}
