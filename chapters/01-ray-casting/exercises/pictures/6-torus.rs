//! Picture of exercise 1.6: interlocked rings.

use common::{
    Error, Vec3,
    color::srgb,
    picture::{Picture, Render, Settings},
};
use ray_casting::{frame::Frame, material::Phong, shape::Shape};

use super::stage::{self, Make, Placed, camera, stage, view};

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "Rings on a dark stage: a chain of interlocked links of gold and teal across the middle, a thick plum-colored ring \
               with a thin one leaning on it, and a few small ones lying about.";
    stage::picture("1.6-torus", alt, make)
}

/// The rings, with tori that `torus` makes of center, major and minor radius.
pub(crate) fn make<S: Shape + 'static>(
    settings: &Settings,
    torus: impl Fn(Vec3, f32, f32) -> S,
) -> Result<Box<dyn Render>, Error> {
    let mut scene = stage()?;
    let gold = Phong::of(srgb(214, 164, 62), 0.9, 90.0);
    let teal = Phong::of(srgb(52, 140, 140), 0.7, 70.0);
    let plum = Phong::of(srgb(150, 74, 118), 0.6, 80.0);
    let cherry = Phong::of(srgb(190, 40, 48), 0.9, 160.0);
    let cream = Phong::of(srgb(226, 212, 184), 0.4, 40.0);

    // A chain: every other link lies, the rest stand, and each passes through its neighbors.
    for (i, x) in [-2.75, -1.85, -0.95, -0.05, 0.85].into_iter().enumerate() {
        let link = Frame::at(Vec3::new(x, 0.74, -0.2));
        let (tilt, color) = if i % 2 == 0 { (62.0, gold) } else { (-28.0, teal) };
        scene.add("link", Placed { shape: torus(Vec3::ZERO, 0.62, 0.13), frame: link.turned(Vec3::X, tilt) }, color);
    }
    scene.add("thick ring", torus(Vec3::new(2.62, 0.36, -0.6), 0.6, 0.36), plum);
    let leaning = Frame::at(Vec3::new(2.66, 1.04, -0.5)).turned(Vec3::Z, -24.0).turned(Vec3::X, 14.0);
    scene.add("thin ring", Placed { shape: torus(Vec3::ZERO, 0.75, 0.05), frame: leaning }, cream);
    for (x, z, major, minor, color) in [
        (-1.7, 1.35, 0.3, 0.09, cream),
        (-0.75, 1.6, 0.2, 0.1, cherry),
        (0.7, 1.45, 0.38, 0.07, gold),
        (1.65, 1.2, 0.24, 0.12, teal),
    ] {
        scene.add("small ring", torus(Vec3::new(x, minor, z), major, minor), color);
    }
    Ok(view(scene, camera([0.4, 3.0, 7.6], [0.05, 0.62, 0.1], 29.5, &settings.values)?))
}
