//! Picture of exercise 6.3: a row of balls by lamplight, through a lens.

use std::sync::Arc;

use common::{
    Error, Rgb, Stream, Vec2, Vec3,
    color::srgb,
    film::Size,
    knob::{Knob, Step},
    picture::{FilmPoint, Integrator, ORBIT, Picture, Render, Settings},
    story::{Story, triple},
};
use path_tracing::{material::Material, method::Method, path_tracer::PathTracer, world::World};
use ray_casting::{
    background::Background, camera::Camera, light::PointLight, pictures::stage, ray::Ray, scene::Scene, sphere::Sphere,
};
use sampling::unit_square::sample_unit_square;
use whitted::probe::Listener;

/// The student's function: by the pinhole's ray, right, up and forward, aperture, focus, and a point of the square.
type LensRay = fn(Ray, [Vec3; 3], f32, f32, Vec2) -> Ray;
/// Makes a picture of what a user has chosen.
type Make = fn(&Settings) -> Result<Box<dyn Render>, Error>;

const APERTURE: Knob = Knob::number("aperture", "diameter of the lens", [0.0, 2.0], 0.3, "units", Step::Add(0.05));
const FOCUS: Knob =
    Knob::number("focus", "distance of the plane of focus, along the view", [1.0, 30.0], 6.0, "units", Step::Add(0.25));

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    Picture {
        name: "6.3-depth-of-field",
        alt: "A row of balls, of porcelain, clay, gold and other metals, runs from the lower left into the distance at the \
              right. The third one, a gold mirror, is sharp. The others are the more blurred, the farther they are from it. \
              In the dusk behind, distant lamps are soft round discs in orange, white, and blue.",
        knobs: &[APERTURE, FOCUS, ORBIT[0], ORBIT[1], ORBIT[2]],
        size: Size::of::<960, 540>(),
        samples: 64,
        takes_mesh: false,
        make,
    }
}

/// A path tracer that looks through a lens.
struct ThroughLens {
    tracer: PathTracer,
    /// Right, up and forward.
    axes: [Vec3; 3],
    aperture: f32,
    focus: f32,
    lens_ray: LensRay,
}

impl Integrator for ThroughLens {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let pinhole = self.tracer.camera.ray(point);
        let ray = (self.lens_ray)(pinhole, self.axes, self.aperture, self.focus, sample_unit_square(random));
        story.tell(|| format!("the ray starts on the lens, {} from the eye", triple(ray.origin - pinhole.origin)));
        self.tracer.trace(ray, random, &mut Listener(story))
    }
}

/// The picture, with the student's lens.
pub(crate) fn make(settings: &Settings, lens_ray: LensRay) -> Result<Box<dyn Render>, Error> {
    let camera = stage::camera([0.0, 1.5, 6.6], [0.4, 0.78, 0.0], 26.0, &settings.values)?;
    let tracer = PathTracer { world: Arc::new(World::new(scene()?)), camera, method: Method::BEST };
    let [aperture, focus] = [&APERTURE, &FOCUS].map(|knob| settings.values.number(knob));
    Ok(Box::new(ThroughLens { tracer, axes: axes(&camera), aperture, focus, lens_ray }))
}

/// Right, up and forward of a camera, by the rays of a square film.
fn axes(camera: &Camera) -> [Vec3; 3] {
    let toward = |x: f32, y: f32| camera.ray(FilmPoint { position: Vec2::new(x, y), size: Vec2::ONE }).direction;
    let right = (toward(1.0, 0.5) - toward(0.0, 0.5)).normalize();
    [right, (toward(0.5, 0.0) - toward(0.5, 1.0)).normalize(), toward(0.5, 0.5)]
}

/// A row of balls on a floor, and lamps in the distance.
fn scene() -> Result<Scene<Material>, Error> {
    let matte = |red, green, blue| Material::matte(srgb(red, green, blue));
    let porcelain = |red, green, blue| Material::coated(srgb(red, green, blue), 1.5);
    let mut scene = Scene::new();
    scene
        .surround(Dusk)
        .light(PointLight { position: Vec3::new(-2.2, 5.0, 4.6), intensity: Rgb::new(62.0, 50.0, 37.0) });
    scene.add("floor", stage::square(0.0, 60.0)?, matte(120, 104, 92));
    let row = [
        porcelain(196, 62, 46),
        porcelain(228, 226, 220),
        Material::GOLD,
        matte(64, 118, 176),
        Material::COPPER,
        porcelain(92, 150, 110),
        Material::SILVER,
        porcelain(214, 160, 60),
    ];
    for (i, material) in (0_u8..).zip(row) {
        let step = f32::from(i) - 2.0;
        scene.add("ball", Sphere::new(Vec3::new(step * 0.62, 0.5, 0.75 - step * 1.35), 0.5), material);
    }
    let lamps = [Rgb::new(4.6, 2.2, 0.6), Rgb::new(3.4, 3.0, 2.2), Rgb::new(0.9, 1.9, 3.9)];
    for (i, color) in (0_u8..24).zip(lamps.into_iter().cycle()) {
        // Spread by steps of the golden ratio, so that none stands in a row with the next.
        let share = (f32::from(i) * 0.618_034).fract();
        let place = Vec3::new(-7.6 + 18.6 * f32::from(i) / 23.0, 0.5 + 3.1 * share, -19.0 - 5.0 * (1.0 - share));
        scene.add("lamp", Sphere::new(place, 0.2), Material::glowing(color));
    }
    Ok(scene)
}

/// A sky after sunset: a warm stripe above the horizon, and dark blue above.
struct Dusk;

impl Background for Dusk {
    fn radiance(&self, direction: Vec3) -> Rgb {
        let height = direction.normalize_or(Vec3::Y).y.max(0.0);
        let low = (1.0 - height) * (1.0 - height);
        Rgb::new(0.06, 0.075, 0.16).lerp(Rgb::new(0.34, 0.21, 0.17), low * low * low)
    }
}
