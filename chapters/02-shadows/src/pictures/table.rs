//! A low table and things from large to tiny, for all pictures about the offset.

use common::{Error, Rgb, Vec3, color::srgb, picture::Settings};
use ray_casting::{
    frame::Frame,
    light::PointLight,
    material::Phong,
    pictures::stage::{block, camera, square},
    quadric::Quadric,
    scene::Scene,
    sphere::Sphere,
};

use crate::{direct_light::DirectLight, offset::Offset};

// ANCHOR: scaled
/// The table with everything `scale` times as large: the things, their places, the camera.
pub(super) fn table(scale: f32, offset: Offset, settings: &Settings) -> Result<DirectLight, Error> {
    let at = |x: f32, y: f32, z: f32| Vec3::new(x, y, z) * scale;
    let mut scene = Scene::new();
    // The light of a lamp falls with the square of the distance, so its power has to grow with the square.
    let power = scale * scale;
    scene.light(PointLight { position: at(-3.2, 3.4, 2.9), intensity: Rgb::new(84.0, 72.0, 56.0) * power });
    scene.light(PointLight { position: at(3.0, 3.2, 5.0), intensity: Rgb::new(3.4, 4.6, 7.0) * power });
    // ANCHOR_END: scaled
    scene.ambient = Rgb::new(0.10, 0.12, 0.16);

    let paper = Phong::of(srgb(190, 184, 174), 0.0, 1.0);
    let wood = Phong::of(srgb(170, 122, 80), 0.15, 20.0);
    let jade = Phong::of(srgb(60, 140, 112), 0.6, 80.0);
    let coral = Phong::of(srgb(218, 92, 74), 0.5, 60.0);
    scene.surround(paper.ambient * scene.ambient);
    scene.add("floor", square(0.0, 60.0 * scale)?, paper);
    scene.add("table top", block(Frame::at(at(0.0, 0.42, -0.2)), at(1.15, 0.035, 0.62))?, wood);
    for (x, z) in [(-1.02, -0.69), (1.02, -0.69), (-1.02, 0.29), (1.02, 0.29)] {
        let leg = Quadric::cylinder(0.055 * scale, 0.39 * scale);
        scene.add("leg", leg.placed(Frame::at(at(x, 0.0, z))), wood);
    }
    let cone = Quadric::cone(0.34 * scale, 0.85 * scale);
    scene.add("cone", cone.placed(Frame::at(at(0.62, 0.455, -0.3))), jade);
    scene.add("ball on the table", Sphere::new(at(-0.42, 0.815, -0.22), 0.36 * scale), coral);
    // From ball to ball the radius shrinks.
    for (x, z, radius) in
        [(-0.95, 1.02, 0.26), (-0.31, 1.12, 0.17), (0.13, 1.17, 0.11), (0.43, 1.2, 0.07), (0.63, 1.22, 0.045)]
    {
        scene.add("ball", Sphere::new(at(x, radius, z), radius * scale), coral);
    }
    let (eye, lookat) = (at(0.7, 2.6, 6.2), at(0.03, 0.47, 0.2));
    let camera = camera(eye.to_array(), lookat.to_array(), 20.5, &settings.values)?;
    Ok(DirectLight { scene, camera, offset })
}
