//! Picture of exercise 3.3: a cut diamond and a prism.

use std::f32::consts::TAU;

use common::{
    Error, Interval, Rgb, Vec3,
    color::srgb,
    float,
    knob::{Knob, Step},
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{
    background::Background, hit::Hit, light::PointLight, material::Phong, pictures::stage::camera, ray::Ray,
    scene::Scene, shape::Shape, sphere::Sphere,
};

use super::studio::{self, Ground, Make};
use crate::checks::{
    dispersion::{Answer, Surface, WAVELENGTHS},
    tracer::Tracer,
};

const DISPERSION: Knob = Knob::number(
    "dispersion",
    "B of Cauchy's formula, compared with the real one",
    [0.0, 6.0],
    2.0,
    "times",
    Step::Add(0.25),
);

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A cut diamond, a ball and an upright prism of flint glass on a dark table with white stripes, under many small \
               lamps. The facets of the diamond sparkle in red, green and blue, and in the prism each white stripe is \
               spread into stripes of all colors.";
    let knobs = &[DISPERSION, ORBIT[0], ORBIT[1], ORBIT[2]];
    Picture { knobs, samples: 16, ..studio::picture("3.3-dispersion", alt, make) }
}

/// A dark hall with rings of small round lamps.
struct Hall;

impl Background for Hall {
    fn radiance(&self, direction: Vec3) -> Rgb {
        let d = direction.normalize_or(Vec3::Y);
        let walls = Rgb::new(0.012, 0.014, 0.020) + Rgb::new(0.03, 0.035, 0.05) * d.y.max(0.0);
        // Rings of lamps, by height and by angle around the vertical.
        let around = float::atan2(d.x, d.z) / TAU;
        let ring = |height: f32, count: f32, shift: f32| {
            let nearest = ((around * count + shift).round() - shift) / count * TAU;
            let across = (1.0 - height * height).sqrt();
            let lamp = Vec3::new(across * float::sin(nearest), height, across * float::cos(nearest));
            studio::smooth(0.062, 0.055, (d - lamp).length())
        };
        walls + Rgb::new(14.0, 13.4, 12.6) * (ring(0.28, 13.0, 0.5) + ring(0.62, 11.0, 0.2) + ring(0.9, 5.0, 0.1))
    }
}

/// A convex body: what lies behind all of its planes, each given by its outward normal and its distance from the origin.
struct Cut {
    center: Vec3,
    planes: Vec<(Vec3, f32)>,
    /// Radius of a sphere around all of it.
    radius: f32,
}

impl Shape for Cut {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        // Most rays pass by.
        let from_center = ray.origin - self.center;
        if from_center.reject_from(ray.direction).length_squared() > self.radius * self.radius {
            return None;
        }
        let mut enters = (f32::NEG_INFINITY, Vec3::ZERO);
        let mut leaves = (f32::INFINITY, Vec3::ZERO);
        for (normal, distance) in &self.planes {
            let speed = ray.direction.dot(*normal);
            let t = (distance - from_center.dot(*normal)) / speed;
            if speed < 0.0 && t > enters.0 {
                enters = (t, *normal);
            } else if speed > 0.0 && t < leaves.0 {
                leaves = (t, *normal);
            }
        }
        if enters.0 >= leaves.0 {
            return None;
        }
        let (t, normal) = [enters, leaves].into_iter().find(|(t, _)| range.contains(*t))?;
        Some(Hit::new(ray, t, normal).among(self.center))
    }
}

impl Cut {
    /// Planes around the vertical: how many, the first one's angle in degrees, their slope in degrees against the
    /// horizontal, and their distance from the center.
    fn ring(mut self, count: u8, first: f32, slope: f32, distance: f32) -> Self {
        let (sin, cos) = (float::sin(slope.to_radians()), float::cos(slope.to_radians()));
        for i in 0..count {
            let around = first.to_radians() + TAU * f32::from(i) / f32::from(count);
            self.planes.push((Vec3::new(sin * float::sin(around), cos, sin * float::cos(around)), distance));
        }
        self
    }

    /// A round brilliant of radius 1, its girdle around the center.
    fn brilliant(center: Vec3) -> Self {
        let table = Self { center, planes: vec![(Vec3::Y, 0.36)], radius: 1.03 };
        // The slopes are those of a jeweler's ideal cut; the distances let the facets meet.
        table
            .ring(16, 11.25, 90.0, 1.0)
            .ring(8, 0.0, 34.5, 0.60)
            .ring(8, 22.5, 22.0, 0.472)
            .ring(16, 11.25, 42.0, 0.692)
            .ring(8, 0.0, 180.0 - 40.8, 0.655)
            .ring(16, 11.25, 180.0 - 42.4, 0.681)
    }

    /// A prism that stands upright on the table, its sharpest edge turned to the right. `apex` is the angle there and
    /// `turned` an angle around the vertical, both in degrees; `across` is the distance of the sides from the middle.
    fn prism(center: Vec3, half_height: f32, across: f32, apex: f32, turned: f32) -> Self {
        let side = |degrees: f32| {
            let around = (degrees + turned).to_radians();
            (Vec3::new(float::sin(around), 0.0, float::cos(around)), across)
        };
        let planes = vec![
            (Vec3::Y, half_height),
            (-Vec3::Y, half_height),
            side(apex / 2.0),
            side(180.0 - apex / 2.0),
            side(-90.0),
        ];
        // The sharpest edge is farthest from the axis.
        let edge = across / float::sin((apex / 2.0).to_radians());
        Self { center, planes, radius: Vec3::new(half_height, edge, 0.0).length() }
    }
}

/// Clear things on a table, by what the student has written.
pub(crate) fn make(settings: &Settings, answer: Answer) -> Result<Box<dyn Render>, Error> {
    let times = settings.values.number(&DISPERSION);
    // The index in the middle of the spectrum stays as it is.
    let clear = |a: f32, b: f32| {
        let a = a + b * (1.0 - times) / 0.3025;
        Surface::Clear(Rgb::from_array(WAVELENGTHS.map(|nanometers| (answer.cauchy)(a, b * times, nanometers))))
    };
    let (diamond, flint) = (clear(2.378, 0.0121), clear(1.728, 0.013_42));
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.05, 0.055, 0.07);
    scene.surround(Hall);
    scene.light(PointLight { position: Vec3::new(-3.0, 6.0, 3.0), intensity: Rgb::new(70.0, 68.0, 64.0) });
    let rough = |red, green, blue| Surface::Rough(Phong::of(srgb(red, green, blue), 0.0, 1.0));
    fn is_stripe(x: f32, z: f32) -> bool {
        (x - x.round()).abs() < 0.07 && x.abs() < 4.5 && (-8.0..3.5).contains(&z)
    }
    scene.add("stripes", Ground { half: 30.0, shows: is_stripe }, rough(244, 240, 232));
    scene.add("table", Ground { half: 30.0, shows: |x, z| !is_stripe(x, z) }, rough(40, 44, 56));
    scene.add("diamond", Cut::brilliant(Vec3::new(-0.9, 0.89, 0.2)), diamond);
    scene.add("prism", Cut::prism(Vec3::new(1.75, 0.81, 0.3), 0.8, 0.32, 38.0, 8.0), flint);
    scene.add("ball", Sphere::new(Vec3::new(0.75, 0.5, -1.9), 0.5), flint);
    Ok(Box::new(Tracer {
        scene,
        camera: camera([0.5, 2.9, 5.6], [0.4, 0.42, 0.0], 30.0, &settings.values)?,
        optics: answer,
        max_depth: 9,
        // One channel alone has a third of the mean weight.
        min_weight: 1.0 / 96.0,
    }))
}
