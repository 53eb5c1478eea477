//! Picture of exercise 1.4: a stage under three colored lamps.

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    knob::{Knob, Step},
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{frame::Frame, light::Light, material::Phong, quadric::Quadric, scene::Scene, sphere::Sphere};

use super::stage::{self, Make, camera, square, view};

const INNER: Knob =
    Knob::number("inner", "angle up to which all the light arrives", [0.0, 80.0], 9.0, "°", Step::Add(1.0));
const OUTER: Knob =
    Knob::number("outer", "angle beyond which no light arrives", [0.0, 80.0], 16.0, "°", Step::Add(1.0));

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A dark stage under a red, a green and a blue spot light. Their round pools of light overlap: yellow, cyan and \
               magenta where two meet, white in the middle. White balls and cones take the color of the light they stand in.";
    let knobs = &[INNER, OUTER, ORBIT[0], ORBIT[1], ORBIT[2]];
    Picture { knobs, ..stage::picture("1.4-spot-light", alt, make) }
}

/// The stage, with lights that `spot` makes of position, axis, intensity, inner and outer angle.
pub(crate) fn make<L: Light + 'static>(
    settings: &Settings,
    spot: impl Fn(Vec3, Vec3, Rgb, f32, f32) -> L,
) -> Result<Box<dyn Render>, Error> {
    let [inner, outer] = [INNER, OUTER].map(|knob| settings.values.number(&knob));
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.020, 0.022, 0.030);
    scene.surround(Rgb::new(0.004, 0.0045, 0.006));
    let white = Phong::of(srgb(228, 222, 210), 0.5, 60.0);
    scene.add("floor", square(0.0, 400.0)?, Phong::of(srgb(190, 190, 190), 0.0, 1.0));
    scene.add("ball", Sphere::new(Vec3::new(0.0, 0.4, -0.35), 0.4), white);
    for (x, z, height) in [(-1.75, -0.3, 0.9), (1.75, -0.3, 0.9), (0.0, -1.75, 1.2)] {
        scene.add("cone", Quadric::cone(0.3, height).placed(Frame::at(Vec3::new(x, 0.0, z))), white);
    }
    for (x, z) in [(-1.0, 1.0), (1.0, 1.0)] {
        scene.add("small ball", Sphere::new(Vec3::new(x, 0.24, z), 0.24), white);
    }
    const BRIGHTNESS: f32 = 165.0;
    for (x, z, color) in [(-0.85, 0.5, Rgb::X), (0.85, 0.5, Rgb::Y), (0.0, -0.95, Rgb::Z)] {
        let (from, to) = (Vec3::new(2.6 * x, 5.2, 2.6 * z + 0.6), Vec3::new(x, 0.0, z));
        // A little of the other colors, so that no lamp is pure.
        let color = BRIGHTNESS * color.lerp(Rgb::ONE, 0.04);
        scene.light(spot(from, to - from, color, inner.min(outer), outer));
    }
    Ok(view(scene, camera([0.0, 5.6, 6.6], [0.0, 0.12, -0.1], 27.0, &settings.values)?))
}
