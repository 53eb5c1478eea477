//! Three colored lights on white things.

use common::{
    Error, Rgb, Vec3,
    film::Size,
    knob::Knob,
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{
    frame::Frame,
    light::PointLight,
    material::Phong,
    pictures::stage::{camera, square},
    quadric::Quadric,
    scene::Scene,
    sphere::Sphere,
};

use crate::{direct_light::DirectLight, offset::Offset};

/// The lights that can be switched, each with where it hangs and its color.
const LIGHTS: [(Knob, Vec3, Rgb); 3] = [
    (Knob::switch("red", "whether the red light is on", true), Vec3::new(-1.47, 6.5, 0.85), Rgb::X),
    (Knob::switch("green", "whether the green light is on", true), Vec3::new(0.0, 6.5, -1.7), Rgb::Y),
    (Knob::switch("blue", "whether the blue light is on", true), Vec3::new(1.47, 6.5, 0.85), Rgb::Z),
];

pub(super) const PICTURE: Picture = Picture {
    name: "colored-lights",
    alt: "A white vase, ball and cone over a white floor, under a red, a green and a blue light. Where all three shine, all is white. A \
          hovering ball throws three shadows that overlap: cyan where only red is missing, magenta without green, \
          yellow without blue; pure red, green and blue where two are missing; nearly black where all three are.",
    knobs: &[LIGHTS[0].0, LIGHTS[1].0, LIGHTS[2].0, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    /// Radiant intensity of each light in its own channel.
    const INTENSITY: f32 = 148.0;
    let mut scene = Scene::new();
    scene.ambient = Rgb::splat(0.04);
    for (_, position, color) in LIGHTS.iter().filter(|(knob, ..)| settings.values.is_on(knob)) {
        scene.light(PointLight { position: *position, intensity: *color * INTENSITY });
    }
    let white = Phong::of(Rgb::splat(0.8), 0.0, 1.0);
    let gloss = Phong::of(Rgb::splat(0.8), 0.35, 60.0);
    scene.surround(white.ambient * scene.ambient);
    scene.add("floor", square(0.0, 60.0)?, white);
    scene.add("ball", Sphere::new(Vec3::new(0.0, 1.5, 0.0), 0.55), gloss);
    let vase = Quadric::hyperboloid_of_one_sheet(0.2, 0.5, 0.7).placed(Frame::at(Vec3::new(-1.9, 0.7, -0.5)));
    let cone = Quadric::cone(0.42, 1.5).placed(Frame::at(Vec3::new(1.9, 0.0, -0.5)));
    scene.add("vase", vase, gloss).add("cone", cone, gloss);
    let camera = camera([0.0, 4.4, 7.6], [0.0, 0.75, 0.0], 24.0, &settings.values)?;
    Ok(Box::new(DirectLight { scene, camera, offset: Offset::Following }))
}
