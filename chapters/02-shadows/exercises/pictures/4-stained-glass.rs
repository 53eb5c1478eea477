//! Picture of exercise 2.4: the sun through a stained glass window.

use std::f32::consts::TAU;

use common::{
    Error, Interval, Rgb, Stream, Vec2, Vec3,
    color::srgb,
    float,
    picture::{FilmPoint, Integrator, Picture, Render, Settings},
    story::{Story, triple},
};
use ray_casting::{
    camera::Camera,
    hit::Hit,
    light::{DirectionalLight, Illumination},
    local_illumination::{Terms, reflected, tell_hit, tell_ray},
    material::Phong,
    pictures::stage::camera,
    ray::Ray,
    scene::Scene,
    shape::Shape,
    sphere::Sphere,
};

use super::Make;

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A dark room with a round stained glass window. The sun shines through it from outside, and its whole pattern of \
               ruby, cobalt, amber, green and violet lies on the floor in long ovals. White balls catch the colors, and hollow \
               balls of red, yellow and blue glass cast shadows of their own color.";
    super::picture("2.4-stained-glass", alt, make)
}

/// The glass of the window, as transmittances.
const GLASS: [Rgb; 6] = [
    Rgb::new(0.90, 0.07, 0.06),
    Rgb::new(0.05, 0.17, 0.85),
    Rgb::new(0.98, 0.60, 0.08),
    Rgb::new(0.10, 0.62, 0.20),
    Rgb::new(0.46, 0.10, 0.66),
    Rgb::new(0.96, 0.90, 0.70),
];

/// What a wall consists of in one place.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    /// Stone, or the lead between the panes.
    Opaque,
    /// One of [`GLASS`].
    Pane(usize),
}

const RADIUS: f32 = 1.3;
const CENTER: Vec2 = Vec2::new(0.0, 1.95);
/// Half the width of the lead.
const LEAD: f32 = 0.018;

/// The pattern of the window: three rings around a disc, with small discs in the outer one.
fn pattern(place: Vec2) -> Part {
    let (from_center, angle) = ((place - CENTER).length(), float::atan2(place.y - CENTER.y, place.x - CENTER.x));
    // How far into the nth of `count` sectors, and how far from its nearer edge, in scene units.
    let sector = |count: f32| {
        let along = (angle / TAU + 1.0).fract() * count;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few sectors")]
        let index = along as usize;
        (index, (0.5 - (along.fract() - 0.5).abs()) * TAU * from_center / count)
    };
    let is_lead = |distance: f32| distance.abs() < LEAD;
    if from_center > RADIUS || [0.24, 0.70].iter().any(|ring| is_lead(from_center - ring)) {
        return Part::Opaque;
    }
    if from_center < 0.24 {
        return Part::Pane(5);
    }
    if from_center < 0.70 {
        let (index, edge) = sector(8.0);
        return if is_lead(edge) { Part::Opaque } else { Part::Pane([0, 2][index % 2]) };
    }
    // A small disc in the middle of each of the outer sectors.
    const SECTORS: f32 = 12.0;
    let (index, edge) = sector(SECTORS);
    #[expect(clippy::cast_precision_loss, reason = "a few sectors")]
    let middle = (index as f32 + 0.5) * TAU / SECTORS;
    let disc = CENTER + Vec2::new(float::cos(middle), float::sin(middle)) * 1.0;
    let from_disc = place.distance(disc);
    if is_lead(from_disc - 0.2) {
        return Part::Opaque;
    }
    match from_disc < 0.2 {
        true => Part::Pane([0, 2, 4][index % 3]),
        false if is_lead(edge) => Part::Opaque,
        false => Part::Pane([1, 3][usize::from(from_center > 1.0)]),
    }
}

/// All of the wall that consists of one part.
#[derive(Clone, Copy)]
struct Wall(Part);

const WALL_Z: f32 = -2.2;

impl Shape for Wall {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let t = (WALL_Z - ray.origin.z) / ray.direction.z;
        let is_here = range.contains(t) && pattern(ray.at(t).truncate()) == self.0;
        is_here.then(|| Hit::new(ray, t, Vec3::Z).among(Vec3::Z * WALL_Z))
    }
}

/// The floor of the room. Beyond the wall there is only the sky.
#[derive(Clone, Copy)]
struct Floor;

impl Shape for Floor {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let t = -ray.origin.y / ray.direction.y;
        let is_here = range.contains(t) && ray.at(t).z > WALL_Z;
        is_here.then(|| Hit::new(ray, t, Vec3::Y))
    }
}

/// A scene of which each thing has a transmittance.
struct Room<F> {
    /// To look at.
    seen: Scene<(Phong, Rgb)>,
    /// The same things, to look through.
    glass: Scene<Rgb>,
    camera: Camera,
    light_through: F,
}

impl<F> Room<F> {
    fn add(&mut self, name: &'static str, shape: impl Shape + Copy + 'static, look: Phong, transmittance: Rgb) {
        self.seen.add(name, shape, (look, transmittance));
        self.glass.add(name, shape, transmittance);
    }
}

impl<F: Fn(&Scene<Rgb>, &Hit, &Illumination) -> Rgb + Send + Sync> Room<F> {
    /// What a surface sends to the viewer; glass only has highlights.
    fn shade(&self, hit: &Hit, look: &Phong, to_viewer: Vec3, story: &mut impl Story) -> Rgb {
        let mut radiance = look.ambient * self.seen.ambient;
        for light in &self.seen.lights {
            let light = light.illuminate(hit.position);
            if light.direction.dot(hit.geometric_normal) > 0.0 {
                let through = (self.light_through)(&self.glass, hit, &light);
                story.tell(|| format!("light comes through: {}", triple(through)));
                radiance += through * reflected(&light, hit, look, to_viewer, Terms::ALL);
            }
        }
        radiance
    }
}

impl<F: Fn(&Scene<Rgb>, &Hit, &Illumination) -> Rgb + Send + Sync> Integrator for Room<F> {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = self.camera.ray(point);
        tell_ray(story, &ray);
        // The viewer looks through glass too.
        let (mut radiance, mut weight, mut range) = (Rgb::ZERO, Rgb::ONE, Interval::POSITIVE);
        while let Some((hit, object)) = self.seen.intersect(&ray, range) {
            tell_hit(story, &hit, object);
            let (look, transmittance) = &object.material;
            radiance += weight * self.shade(&hit, look, -ray.direction, story);
            if *transmittance == Rgb::ZERO {
                return radiance;
            }
            weight *= transmittance;
            range.min = hit.t;
        }
        radiance + weight * self.seen.background.radiance(ray.direction)
    }
}

/// The room, with the light that `light_through` lets through.
pub(crate) fn make<F: Fn(&Scene<Rgb>, &Hit, &Illumination) -> Rgb + Send + Sync + 'static>(
    settings: &Settings,
    light_through: F,
) -> Result<Box<dyn Render>, Error> {
    let camera = camera([0.75, 2.7, 6.9], [-0.45, 1.22, -0.8], 34.0, &settings.values)?;
    let mut room = Room { seen: Scene::new(), glass: Scene::new(), camera, light_through };
    room.seen.ambient = Rgb::new(0.085, 0.09, 0.12);
    room.seen.surround(Rgb::new(0.75, 0.85, 1.0));
    room.seen.light(DirectionalLight::new(Vec3::new(0.22, 0.62, -0.78), Rgb::new(9.5, 8.9, 7.8)));
    let matt = |red, green, blue| Phong::of(srgb(red, green, blue), 0.0, 1.0);
    let white = matt(236, 232, 224);
    let glass = Phong::of(Rgb::ZERO, 0.9, 250.0);
    let window = Phong::of(Rgb::ZERO, 0.0, 1.0);
    room.add("floor", Floor, matt(206, 200, 192), Rgb::ZERO);
    room.add("wall", Wall(Part::Opaque), matt(150, 144, 136), Rgb::ZERO);
    for (i, color) in GLASS.into_iter().enumerate() {
        room.add("pane", Wall(Part::Pane(i)), window, color);
    }
    for (x, z, radius) in [(-1.55, -0.35, 0.36), (0.1, 0.85, 0.26), (-0.3, -0.85, 0.22)] {
        room.add("ball", Sphere::new(Vec3::new(x, radius, z), radius), white, Rgb::ZERO);
    }
    for (x, z, radius, color) in [
        (-1.2, 0.85, 0.32, Rgb::new(0.97, 0.55, 0.52)),
        (-0.25, -0.1, 0.30, Rgb::new(0.97, 0.90, 0.50)),
        (-0.55, 1.3, 0.22, Rgb::new(0.50, 0.72, 0.97)),
    ] {
        room.add("hollow ball", Sphere::new(Vec3::new(x, radius, z), radius), glass, color);
    }
    Ok(Box::new(room))
}
