//! Picture of exercise 3.2: colored glass, from thin to thick.

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    knob::{Knob, Step},
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{
    frame::Frame,
    light::DirectionalLight,
    material::Phong,
    pictures::stage::{block, camera},
    scene::Scene,
    shape::Shape,
    sphere::Sphere,
};
use whitted::material::Material;

use super::studio::{self, Make, Studio};
use crate::checks::{
    absorption::{Answer, Glass},
    tracer::Tracer,
};

const DENSITY: Knob =
    Knob::number("density", "how strongly the glass is colored", [0.0, 10.0], 1.0, "times", Step::Add(0.1));

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "Rows of glass balls on a white table, ruby, amber, emerald and cobalt, each row from small to great. The \
               smallest are pale, the greatest deep. Light goes straight through them to the table, so that their shadows are \
               colored, too, and deeper under greater balls.";
    let knobs = &[DENSITY, ORBIT[0], ORBIT[1], ORBIT[2]];
    Picture { knobs, ..studio::picture("3.2-absorption", alt, make) }
}

/// The glass, by what the student has written.
pub(crate) fn make(settings: &Settings, answer: Answer) -> Result<Box<dyn Render>, Error> {
    let density = settings.values.number(&DENSITY);
    let glass = |red, green, blue| Glass {
        surface: Material::glass(1.5),
        absorption: (answer.coefficient)(srgb(red, green, blue)) * density,
    };
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.13, 0.14, 0.16);
    scene.surround(Studio {
        low: Rgb::new(0.42, 0.44, 0.48),
        high: Rgb::new(0.80, 0.86, 0.95),
        lamps: Rgb::new(2.5, 2.4, 2.2),
    });
    scene.light(DirectionalLight::new(Vec3::new(-0.55, 0.9, -0.62), Rgb::new(2.7, 2.6, 2.42)));
    let white = Material::rough(Phong::of(srgb(236, 234, 230), 0.0, 1.0));
    let table = Glass { surface: white, absorption: Rgb::ZERO };
    scene.add("table", block(Frame::at(Vec3::Y * -0.5), Vec3::new(60.0, 0.5, 60.0))?, table);
    let mut add = |shape: Box<dyn Shape>, glass| {
        scene.objects.push(ray_casting::scene::Object { name: "glass", shape, material: glass });
    };
    let rows = [glass(238, 60, 84), glass(250, 190, 70), glass(80, 220, 140), glass(80, 140, 246)];
    for (row, glass) in (0_u8..).zip(rows) {
        let mut x = -3.3;
        for radius in [0.16, 0.26, 0.4, 0.58, 0.8] {
            x += radius;
            let z = 1.9 - 1.35 * f32::from(row);
            add(Box::new(Sphere::new(Vec3::new(x, radius, z), radius)), glass);
            x += radius + 0.35;
        }
    }
    Ok(Box::new(Tracer {
        scene,
        camera: camera([-1.2, 5.2, 8.2], [0.0, 0.3, -0.3], 34.0, &settings.values)?,
        optics: answer,
        max_depth: 10,
        min_weight: 1.0 / 512.0,
    }))
}
