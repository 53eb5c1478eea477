//! Picture of exercise 1.1: the corner of a room.

use common::{
    Error, Vec3,
    color::srgb,
    picture::{Picture, Render, Settings},
};
use ray_casting::{material::Phong, shape::Shape, sphere::Sphere};

use super::stage::{self, Make, camera, lit, view};

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "The corner of a room made of three planes, the floor gray, the left wall blue, the right wall clay red. Balls \
               lie about, and some are sunk into the planes, so that round outlines show where they pass through.";
    stage::picture("1.1-plane", alt, make)
}

/// The room, with planes that `plane` makes of a point and a normal.
pub(crate) fn make<S: Shape + 'static>(
    settings: &Settings,
    plane: impl Fn(Vec3, Vec3) -> S,
) -> Result<Box<dyn Render>, Error> {
    let mut scene = lit();
    let matt = |red, green, blue| Phong::of(srgb(red, green, blue), 0.05, 20.0);
    scene
        .add("floor", plane(Vec3::ZERO, Vec3::Y), matt(150, 150, 158))
        .add("left wall", plane(Vec3::new(-3.0, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.35)), matt(70, 104, 160))
        .add("right wall", plane(Vec3::new(0.0, 0.0, -2.6), Vec3::new(-0.45, 0.0, 1.0)), matt(186, 104, 78));
    let glossy = |red, green, blue| Phong::of(srgb(red, green, blue), 0.7, 90.0);
    for (center, radius, color) in [
        ([-0.9, 0.75, -0.6], 0.75, glossy(226, 212, 184)),
        ([0.75, 0.0, 0.5], 0.62, glossy(232, 186, 62)),
        ([-2.95, 1.6, -0.1], 0.62, glossy(52, 140, 140)),
        ([1.35, 1.35, -2.25], 0.75, glossy(190, 40, 48)),
        ([-1.35, 0.22, 1.0], 0.22, glossy(150, 74, 118)),
        ([2.3, 0.1, -1.45], 0.34, glossy(206, 108, 74)),
    ] {
        scene.add("ball", Sphere::new(Vec3::from_array(center), radius), color);
    }
    Ok(view(scene, camera([1.4, 2.6, 7.2], [-0.15, 0.85, -0.6], 34.0, &settings.values)?))
}
