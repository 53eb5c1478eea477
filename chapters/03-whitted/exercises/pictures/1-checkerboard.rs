//! Picture of exercise 3.1: things carved out of blocks.

use common::{
    Error, Interval, Rgb, Vec3,
    color::srgb,
    knob::{Knob, Step},
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{
    frame::Frame,
    hit::Hit,
    light::PointLight,
    material::Phong,
    pictures::stage::{block, camera},
    ray::Ray,
    scene::Scene,
    shape::Shape,
    sphere::Sphere,
};
use whitted::material::Material;

use super::studio::{self, Make, Studio, view};

const SIZE: Knob = Knob::number("size", "width of a cube", [0.05, 2.0], 1.0, "units", Step::Times(1.1));

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A thick chessboard of dark green and ivory stone, and on it balls carved out of blocks of cubes: one of gold \
               and silver, one of dark and light wood, one of blue and white porcelain. A mirror ball shows them all once \
               more.";
    let knobs = &[SIZE, ORBIT[0], ORBIT[1], ORBIT[2]];
    Picture { knobs, ..studio::picture("3.1-checkerboard", alt, make) }
}

/// The part of a shape that is dark, or the part that is light.
struct Part<S> {
    shape: S,
    size: f32,
    is_dark_at: fn(&Hit, f32) -> bool,
    dark: bool,
}

/// More surfaces than a ray has with any of these shapes.
const MANY: usize = 8;

impl<S: Shape> Shape for Part<S> {
    fn intersect(&self, ray: &Ray, mut range: Interval) -> Option<Hit> {
        for _ in 0..MANY {
            let hit = self.shape.intersect(ray, range)?;
            if (self.is_dark_at)(&hit, self.size) == self.dark {
                return Some(hit);
            }
            range.min = hit.t;
        }
        None
    }
}

/// The things, with the student's texture.
pub(crate) fn make(settings: &Settings, is_dark_at: fn(&Hit, f32) -> bool) -> Result<Box<dyn Render>, Error> {
    let scale = settings.values.number(&SIZE);
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.16, 0.17, 0.20);
    scene.surround(Studio {
        low: Rgb::new(0.030, 0.034, 0.048),
        high: Rgb::new(0.92, 0.85, 0.74),
        lamps: Rgb::new(2.6, 2.4, 2.1),
    });
    scene.light(PointLight { position: Vec3::new(-4.2, 6.0, 3.6), intensity: Rgb::new(128.0, 118.0, 100.0) });
    scene.light(PointLight { position: Vec3::new(5.0, 4.4, 1.5), intensity: Rgb::new(26.0, 30.0, 38.0) });
    let coated = |red, green, blue| Material::coated(Phong::of(srgb(red, green, blue), 0.0, 1.0), 1.5);
    let rough = |red, green, blue| Material::rough(Phong::of(srgb(red, green, blue), 0.25, 40.0));
    for (dark, stone) in [(true, coated(24, 62, 50)), (false, coated(236, 226, 200))] {
        let shape = block(Frame::at(Vec3::Y * -0.5), Vec3::new(4.0, 0.5, 4.0))?;
        scene.add("board", Part { shape, size: scale, is_dark_at, dark }, stone);
    }
    for (center, radius, size, dark, light) in [
        ([-1.6, 1.25, -0.1], 1.25, 0.5, Material::GOLD, Material::SILVER),
        ([0.6, 0.75, 1.7], 0.75, 0.3, rough(92, 46, 26), rough(214, 160, 98)),
        ([2.5, 0.6, 0.5], 0.6, 0.2, coated(24, 56, 150), coated(240, 240, 236)),
    ] {
        for (dark, material) in [(true, dark), (false, light)] {
            let shape = Sphere::new(Vec3::from_array(center), radius);
            scene.add("ball", Part { shape, size: size * scale, is_dark_at, dark }, material);
        }
    }
    scene.add("mirror ball", Sphere::new(Vec3::new(1.15, 1.1, -1.4), 1.1), Material::SILVER);
    Ok(view(scene, camera([3.6, 4.5, 10.2], [0.0, 0.05, 0.0], 34.0, &settings.values)?))
}
