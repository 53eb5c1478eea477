//! Picture of exercise 6.2: a room in the light of a lamp with a size.

use common::{
    Error, Rgb, Stream, Vec3,
    color::srgb,
    picture::{FilmPoint, Integrator, Picture, Render, Settings},
    story::{Story, triple},
};
use path_tracing::material::Material;
use ray_casting::{
    camera::Camera,
    frame::Frame,
    pictures::stage::{self, block},
    ray::Ray,
    sphere::Sphere,
};

use super::Make;
use crate::checks::{lamp::Lamp, lamp_world::LampWorld, quad::Quad};

/// The student's function: all light, by world and ray.
type Radiance = fn(&LampWorld, Ray, &mut Stream) -> Rgb;

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A white stage with a green wall on the left and an orange one on the right, under a dark sky, lit by a tilted rectangular \
               lamp that floats at the left. A gold ball shows the bright lamp and the stage; a block, a white porcelain ball and a \
               red ball throw shadows that grow softer with the distance.";
    super::picture("6.2-area-light", alt, make)
}

/// A world with a lamp, seen by a camera.
struct View {
    world: LampWorld,
    camera: Camera,
    radiance: Radiance,
}

impl Integrator for View {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let radiance = (self.radiance)(&self.world, self.camera.ray(point), random);
        story.tell(|| format!("a path that brings {}", triple(radiance)));
        radiance
    }
}

/// The room, lit by the student's lamp.
pub(crate) fn make(settings: &Settings, radiance: Radiance) -> Result<Box<dyn Render>, Error> {
    let lamp = Lamp::around(
        Vec3::new(-0.85, 2.0, 0.5),
        [Vec3::new(0.34, -0.16, 0.0), Vec3::new(0.0, 0.15, -0.28)],
        Rgb::new(28.0, 23.8, 18.0),
    );
    let white = srgb(236, 233, 228);
    let wall = |center: [f32; 3], halves: [Vec3; 2]| Quad::around(Vec3::from_array(center), halves);
    let matte = |color| Material::matte(color);
    let (x, y, z) = (Vec3::X * 2.2, Vec3::Y * 1.4, Vec3::Z * 3.0);
    let world = LampWorld::new(lamp)
        .under(Rgb::new(0.02, 0.03, 0.06))
        .with("floor", wall([0.0, 0.0, 1.0], [x, z]), matte(srgb(222, 214, 202)))
        .with("far wall", wall([0.0, 1.4, -2.0], [x, y]), matte(white))
        .with("left wall", wall([-2.2, 1.4, 1.0], [y, z]), matte(srgb(120, 178, 128)))
        .with("right wall", wall([2.2, 1.4, 1.0], [y, z]), matte(srgb(232, 148, 82)));
    let tall = block(Frame::at(Vec3::new(-0.75, 0.7, -0.9)).turned(Vec3::Y, 24.0), Vec3::new(0.36, 0.7, 0.36))?;
    let world = world
        .with("block", tall, Material::matte(white))
        .with("gold ball", Sphere::new(Vec3::new(0.95, 0.62, -0.6), 0.62), Material::GOLD)
        .with("porcelain", Sphere::new(Vec3::new(0.12, 0.36, 0.55), 0.36), Material::coated(srgb(206, 216, 232), 1.5))
        .with("red ball", Sphere::new(Vec3::new(-0.95, 0.24, 0.5), 0.24), Material::matte(srgb(206, 60, 48)));
    let camera = stage::camera([0.0, 1.9, 5.6], [0.0, 1.02, 0.0], 31.0, &settings.values)?;
    Ok(Box::new(View { world, camera, radiance }))
}
