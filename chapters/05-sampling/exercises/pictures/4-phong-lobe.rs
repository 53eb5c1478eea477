//! Picture of exercise 5.4: golden balls from rough to smooth.

use common::{
    Basis, Error, Interval, Rgb, Stream, Vec2, Vec3,
    color::srgb,
    float,
    picture::{FilmPoint, Integrator, ORBIT, Picture, Render, Settings},
    story::{Story, triple},
};
use ray_casting::{
    camera::Camera,
    hit::Hit,
    local_illumination::{tell_hit, tell_ray},
    material::Phong,
    pictures::stage,
    ray::Ray,
    scene::Scene,
    sphere::Sphere,
};
use sampling::{
    cosine_hemisphere::sample_cosine_hemisphere, direction_sample::DirectionSample, unit_square::sample_unit_square,
};
use shadows::offset::Offset;

use super::{Make, evening::Evening};

/// The student's function: by normal, direction to the viewer, exponent and point of the square.
type Glossy = fn(Vec3, Vec3, f32, Vec2) -> Option<DirectionSample>;

/// What the balls send back of the light that they get.
const GOLD: Rgb = Rgb::new(0.96, 0.72, 0.36);

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "Five golden balls in a row on a pale floor, small red, blue and white balls before them, under an orange and blue evening \
               sky. The ball at the left is dull, and shows only where the sky is bright; from ball to ball the reflections get \
               sharper, and the one at the right is nearly a mirror.";
    Picture { knobs: &ORBIT, samples: 32, ..super::picture("5.4-phong-lobe", alt, make) }
}

/// Matte things, and glossy ones: their shininess is above 0.
struct Lobes {
    scene: Scene<Phong>,
    camera: Camera,
    glossy: Glossy,
}

impl Lobes {
    /// One sample of what a matte surface sends on of the light of the sky.
    fn gather(&self, hit: &Hit, random: &mut Stream) -> Rgb {
        let local = sample_cosine_hemisphere(sample_unit_square(random));
        let direction = Basis::around(hit.shading_normal).to_world(local);
        let ray = Ray::new(Offset::Following.origin(hit, hit.geometric_normal), direction);
        let hidden = self.scene.occluded(&ray, Interval::POSITIVE);
        if hidden { Rgb::ZERO } else { self.scene.background.radiance(direction) }
    }
}

impl Integrator for Lobes {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let (mut ray, mut share) = (self.camera.ray(point), Rgb::ONE);
        for _ in 0..6 {
            tell_ray(story, &ray);
            let Some((hit, object)) = self.scene.intersect(&ray, Interval::POSITIVE) else {
                return share * self.scene.background.radiance(ray.direction);
            };
            tell_hit(story, &hit, object);
            let Phong { diffuse, specular, shininess, .. } = object.material;
            if specular == Rgb::ZERO {
                return share * diffuse * std::f32::consts::PI * self.gather(&hit, random);
            }
            let normal = hit.shading_normal;
            let to_viewer = -ray.direction.normalize();
            let Some(sample) = (self.glossy)(normal, to_viewer, shininess, sample_unit_square(random)) else {
                story.tell(|| "the direction points into the surface: nothing comes from there".into());
                return Rgb::ZERO;
            };
            // What is reflected from a direction has the form of the lobe itself, so a right density cancels it.
            let mirrored = 2.0 * normal.dot(to_viewer) * normal - to_viewer;
            let cosine = sample.direction.dot(mirrored).max(0.0);
            let lobe = (shininess + 1.0) / std::f32::consts::TAU * float::pow(cosine, shininess);
            share *= specular * lobe * sample.density.weight();
            story.tell(|| format!("goes on in direction {}", triple(sample.direction)));
            ray = Ray::new(Offset::Following.origin(&hit, hit.geometric_normal), sample.direction);
        }
        Rgb::ZERO
    }
}

/// The balls, with the student's lobes.
pub(crate) fn make(settings: &Settings, glossy: Glossy) -> Result<Box<dyn Render>, Error> {
    let matte = |red, green, blue| Phong::of(srgb(red, green, blue), 0.0, 1.0);
    let ball = |x: f32, z: f32, radius: f32| Sphere::new(Vec3::new(x, radius, z), radius);
    let mut scene = Scene::new();
    scene.surround(Evening);
    scene.add("floor", stage::square(0.0, 60.0)?, matte(206, 200, 194));
    for (i, exponent) in (0_u8..).zip([2.0, 12.0, 80.0, 600.0, 20_000.0]) {
        let gold = Phong { specular: GOLD, diffuse: Rgb::ZERO, ambient: Rgb::ZERO, shininess: exponent };
        scene.add("golden ball", ball((f32::from(i) - 2.0) * 1.5, -0.4, 0.7), gold);
    }
    for (x, z, color) in [
        (-2.4, 0.75, matte(206, 60, 48)),
        (-1.0, 0.85, matte(70, 120, 190)),
        (0.4, 0.8, matte(236, 232, 226)),
        (1.7, 0.85, matte(206, 60, 48)),
        (2.9, 0.7, matte(70, 120, 190)),
    ] {
        scene.add("small ball", ball(x, z, 0.22), color);
    }
    let camera = stage::camera([0.0, 2.2, 8.4], [0.0, 0.62, 0.0], 29.0, &settings.values)?;
    Ok(Box::new(Lobes { scene, camera, glossy }))
}
