//! Picture of exercise 1.2: coins, drums and pencils.

use common::{
    Error, Vec3,
    color::srgb,
    picture::{Picture, Render, Settings},
};
use ray_casting::{frame::Frame, material::Phong, shape::Shape};

use super::stage::{self, Make, Placed, camera, stage, view};

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "Cylinders on a dark stage: a pot with a lid, a low drum in which three pencils stick, three slightly crooked stacks \
               of gold coins, a coin on its edge, and two pencils that lie in front. All of them are closed at both ends.";
    stage::picture("1.2-cylinder", alt, make)
}

/// The desk, with cylinders that `cylinder` makes of base, radius and height.
pub(crate) fn make<S: Shape + 'static>(
    settings: &Settings,
    cylinder: impl Fn(Vec3, f32, f32) -> S,
) -> Result<Box<dyn Render>, Error> {
    let mut scene = stage()?;
    let teal = Phong::of(srgb(52, 140, 140), 0.5, 60.0);
    let cream = Phong::of(srgb(226, 212, 184), 0.3, 40.0);
    let gold = Phong::of(srgb(214, 164, 62), 0.8, 70.0);
    scene
        .add("drum", cylinder(Vec3::new(-1.75, 0.0, -0.5), 0.72, 1.3), teal)
        .add("lid", cylinder(Vec3::new(-1.75, 1.3, -0.5), 0.76, 0.16), cream)
        .add("knob", cylinder(Vec3::new(-1.75, 1.46, -0.5), 0.16, 0.18), teal)
        .add("low drum", cylinder(Vec3::new(1.9, 0.0, -0.75), 0.8, 0.62), Phong::of(srgb(150, 74, 118), 0.5, 80.0));

    // Stacks of coins, each coin a little beside the one below.
    for (x, z, coins) in [(0.0, 0.1, 9_u8), (0.72, 0.55, 5), (-0.42, 0.95, 3)] {
        for i in 0..coins {
            let step = f32::from(i);
            let aside = Vec3::new(((step * 7.0) % 3.0 - 1.0) * 0.025, step * 0.105, ((step * 5.0) % 3.0 - 1.0) * 0.02);
            scene.add("coin", cylinder(Vec3::new(x, 0.0, z) + aside, 0.32, 0.095), gold);
        }
    }
    let on_edge = Frame::at(Vec3::new(1.5, 0.32, 0.95)).turned(Vec3::X, 90.0).turned(Vec3::Y, 35.0);
    scene.add("coin on its edge", Placed { shape: cylinder(-Vec3::Y * 0.0475, 0.32, 0.095), frame: on_edge }, gold);

    // Pencils: those in the low drum lean, those in front lie.
    let pencil = || cylinder(Vec3::ZERO, 0.07, 1.9);
    let leaning = |x: f32, z: f32, tilt: f32, around: f32| {
        Frame::at(Vec3::new(x, 0.55, z)).turned(Vec3::Z, -tilt).turned(Vec3::Y, around)
    };
    let lying =
        |x: f32, z: f32, around: f32| Frame::at(Vec3::new(x, 0.07, z)).turned(Vec3::Z, 90.0).turned(Vec3::Y, around);
    for (frame, color) in [
        (leaning(1.75, -0.8, 14.0, 20.0), srgb(190, 40, 48)),
        (leaning(2.05, -0.6, 22.0, -30.0), srgb(232, 186, 62)),
        (leaning(1.9, -1.0, 9.0, 200.0), srgb(60, 104, 200)),
        (lying(-0.55, 1.5, 12.0), srgb(206, 108, 74)),
        (lying(-0.95, 1.15, -16.0), srgb(60, 104, 200)),
    ] {
        scene.add("pencil", Placed { shape: pencil(), frame }, Phong::of(color, 0.4, 50.0));
    }
    Ok(view(scene, camera([0.5, 3.2, 7.4], [0.02, 0.78, 0.0], 29.0, &settings.values)?))
}
