//! Picture of exercise 2.3: columns beside a shining panel.

use common::{
    Error, Interval, Rgb, Stream, Vec2, Vec3,
    color::srgb,
    knob::{Knob, Step},
    obj::ObjMesh,
    picture::{FilmPoint, Integrator, ORBIT, Picture, Render, Settings},
    story::{Story, number, triple},
};
use ray_casting::{
    camera::Camera,
    frame::Frame,
    hit::Hit,
    local_illumination::{tell_hit, tell_ray},
    material::Phong,
    mesh::{Mesh, Shading},
    pictures::stage::{camera, square},
    quadric::Quadric,
    ray::Ray,
    scene::Scene,
    shape::Shape as _,
    sphere::Sphere,
};

use super::Make;

const PARTS: Knob = Knob::number("n", "parts of the panel along each edge", [1.0, 16.0], 3.0, "", Step::Whole);
const SIZE: Knob = Knob::number("size", "size of the panel", [0.01, 2.0], 1.0, "times", Step::Times(1.25));

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "Slender columns, two balls and a cone stand on a pale floor in the dark, lit by a bright panel that hangs on the left. \
               Their shadows are sharp at the foot of each thing and softer the farther they reach, until they melt away.";
    let knobs = &[PARTS, SIZE, ORBIT[0], ORBIT[1], ORBIT[2]];
    Picture { knobs, ..super::picture("2.3-soft-shadows", alt, make) }
}

/// A scene lit by one panel.
struct Lit<F> {
    scene: Scene<Phong>,
    camera: Camera,
    panel: [Vec3; 3],
    radiance: Rgb,
    /// The same panel as something to look at.
    shown: Mesh,
    n: u16,
    light: F,
}

impl<F: Light> Lit<F> {
    /// What is reflected toward the viewer.
    fn shade(&self, hit: &Hit, material: &Phong, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let jitter: Vec<_> = (0..self.n * self.n).map(|_| Vec2::new(random.uniform(), random.uniform())).collect();
        let (visible, irradiance) = (self.light)(self.panel, self.radiance, &self.scene, hit, self.n, &jitter);
        story.tell(|| format!("sees {} of the panel, irradiance {}", number(visible), triple(irradiance)));
        material.ambient * self.scene.ambient + material.diffuse * irradiance
    }
}

impl<F: Light> Integrator for Lit<F> {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = self.camera.ray(point);
        tell_ray(story, &ray);
        let seen = self.scene.intersect(&ray, Interval::POSITIVE);
        let before = seen.as_ref().map_or(Interval::POSITIVE, |(hit, _)| Interval::POSITIVE.up_to(hit.t));
        if self.shows_front(&ray, before) {
            story.tell(|| "hits the panel".into());
            return self.radiance;
        }
        let Some((hit, object)) = seen else { return self.scene.background.radiance(ray.direction) };
        tell_hit(story, &hit, object);
        self.shade(&hit, &object.material, random, story)
    }
}

impl<F> Lit<F> {
    /// Whether the ray meets the shining side of the panel.
    fn shows_front(&self, ray: &Ray, range: Interval) -> bool {
        let [_, first, second] = self.panel;
        first.cross(second).dot(ray.direction) < 0.0 && self.shown.occluded(ray, range)
    }
}

/// What a student's panel is: a function of corner and edges, radiance, scene, hit, n and jitter.
pub(crate) trait Light:
    Fn([Vec3; 3], Rgb, &Scene<Phong>, &Hit, u16, &[Vec2]) -> (f32, Rgb) + Send + Sync + 'static
{
}

impl<F> Light for F where F: Fn([Vec3; 3], Rgb, &Scene<Phong>, &Hit, u16, &[Vec2]) -> (f32, Rgb) + Send + Sync + 'static {}

/// The scene, lit by `light`.
pub(crate) fn make<F: Light>(settings: &Settings, light: F) -> Result<Box<dyn Render>, Error> {
    let size = settings.values.number(&SIZE);
    let middle = Vec3::new(-3.0, 2.1, -2.1);
    let [first, second] = [Vec3::new(0.75, 0.0, -1.3) * size, Vec3::new(0.35, 1.1, 0.2) * size];
    let panel = [middle - (first + second) / 2.0, first, second];
    let [a, b, c] = [panel[0] + first, panel[0] + first + second, panel[0] + second];
    let obj =
        ObjMesh { positions: vec![panel[0], a, b, c], triangles: vec![[0, 1, 2], [0, 2, 3]], ..ObjMesh::default() };
    // A smaller panel shines brighter, so that the same power arrives.
    let radiance = Rgb::new(62.0, 49.0, 36.0) / (size * size);
    let n = u16::try_from(settings.values.index(&PARTS)).unwrap_or(1);
    Ok(Box::new(Lit {
        scene: scene()?,
        camera: camera([0.9, 2.8, 6.8], [-0.3, 0.92, -0.3], 36.0, &settings.values)?,
        panel,
        radiance,
        shown: Mesh::new(&obj, Shading::Flat)?,
        n,
        light,
    }))
}

/// Columns in an arc, and some round things.
fn scene() -> Result<Scene<Phong>, Error> {
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.07, 0.09, 0.14);
    let matt = |red, green, blue| Phong::of(srgb(red, green, blue), 0.0, 1.0);
    let floor = matt(206, 200, 190);
    // Far from the panel the floor shows the ambient light alone. The background is the same.
    scene.surround(floor.ambient * scene.ambient);
    scene.add("floor", square(0.0, 400.0)?, floor);
    for (x, z) in [(-1.9, 0.35), (-1.4, -0.45), (-0.6, -0.95), (0.4, -1.1), (1.3, -0.9), (2.0, -0.3)] {
        let place = Vec3::new(x, 0.0, z);
        scene.add("column", Quadric::cylinder(0.06, 1.25).placed(Frame::at(place)), matt(222, 214, 200));
        scene.add("ball", Sphere::new(place + Vec3::Y * 1.35, 0.12), matt(222, 214, 200));
    }
    scene.add("ball", Sphere::new(Vec3::new(0.0, 0.38, 0.1), 0.38), matt(190, 52, 48));
    scene.add("cone", Quadric::cone(0.3, 0.85).placed(Frame::at(Vec3::new(-1.0, 0.0, 0.55))), matt(62, 140, 140));
    scene.add("ball", Sphere::new(Vec3::new(0.95, 0.22, 0.75), 0.22), matt(226, 172, 62));
    Ok(scene)
}
