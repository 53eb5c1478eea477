//! Picture of exercise 5.2: a still life in the light of glowing triangles.

use common::{
    Error, Interval, Rgb, Stream, Vec3,
    obj::ObjMesh,
    picture::{FilmPoint, Integrator, ORBIT, Picture, Render, Settings},
    story::{Story, number, triple},
};
use ray_casting::{
    camera::Camera,
    hit::Hit,
    local_illumination::{tell_hit, tell_ray},
    material::Phong,
    mesh::{Mesh, Shading},
    pictures::stage,
    ray::Ray,
    scene::Scene,
    shape::Shape as _,
};
use sampling::unit_square::sample_unit_square;
use shadows::offset::Offset;

use super::{Make, evening};
use crate::checks::triangle_points::Answer;

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "Four matte balls and a cone stand in the dark on a pale floor, in the light of three triangles that hang around \
               them: a red one at the left, a golden one behind, a blue one at the right. Each thing throws three soft shadows, \
               and where one light is hidden the colors of the other two remain.";
    Picture { knobs: &ORBIT, samples: 16, ..super::picture("5.2-triangle-points", alt, make) }
}

/// A triangle that shines to both sides.
struct Lamp {
    corners: [Vec3; 3],
    radiance: Rgb,
    /// The same as something to look at.
    shown: Mesh,
}

/// A scene lit by triangles.
struct Lit {
    scene: Scene<Phong>,
    camera: Camera,
    lamps: Vec<Lamp>,
    answer: Answer,
}

impl Lit {
    /// What arrives from one lamp, for one random point of it: `L cosθ cosθ' / (r² p)`.
    fn irradiance(&self, hit: &Hit, lamp: &Lamp, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let [r1, r2, r3] = lamp.corners;
        let point = (self.answer.sample_triangle)(lamp.corners, sample_unit_square(random));
        let origin = Offset::Following.origin(hit, hit.geometric_normal);
        let pdf = (self.answer.triangle_pdf)(lamp.corners);
        let ray = Ray::new(origin, point - origin);
        let toward = (point - hit.position).normalize_or_zero();
        let cosine = hit.shading_normal.dot(toward).max(0.0);
        let cosine_there = (r2 - r1).cross(r3 - r1).normalize_or_zero().dot(toward).abs();
        if pdf <= 0.0 || cosine <= 0.0 || self.scene.occluded(&ray, Interval { min: 0.0, max: 1.0 }) {
            return Rgb::ZERO;
        }
        let weight = cosine * cosine_there / (hit.position.distance_squared(point) * pdf);
        story.tell(|| format!("the point {} of a lamp, weight {}", triple(point), number(weight)));
        lamp.radiance * weight
    }
}

impl Integrator for Lit {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = self.camera.ray(point);
        tell_ray(story, &ray);
        let seen = self.scene.intersect(&ray, Interval::POSITIVE);
        let before = seen.as_ref().map_or(Interval::POSITIVE, |(hit, _)| Interval::POSITIVE.up_to(hit.t));
        if let Some(lamp) = self.lamps.iter().find(|lamp| lamp.shown.occluded(&ray, before)) {
            story.tell(|| "hits a lamp".into());
            return lamp.radiance / 6.0;
        }
        let Some((hit, object)) = seen else { return self.scene.background.radiance(ray.direction) };
        tell_hit(story, &hit, object);
        let light: Rgb = self.lamps.iter().map(|lamp| self.irradiance(&hit, lamp, random, story)).sum();
        object.material.ambient * self.scene.ambient + object.material.diffuse * light
    }
}

/// The scene, lit by the student's points.
pub(crate) fn make(settings: &Settings, answer: Answer) -> Result<Box<dyn Render>, Error> {
    let mut scene = evening::still_life()?;
    scene.ambient = Rgb::splat(0.006);
    scene.surround(Rgb::new(0.003, 0.003, 0.005));
    let lamp = |corners: [[f32; 3]; 3], radiance| -> Result<Lamp, Error> {
        let corners = corners.map(Vec3::from_array);
        let obj = ObjMesh { positions: corners.into(), triangles: vec![[0, 1, 2]], ..ObjMesh::default() };
        Ok(Lamp { corners, radiance, shown: Mesh::new(&obj, Shading::Flat)? })
    };
    let lamps = vec![
        lamp([[-2.7, 0.7, 0.2], [-2.3, 2.1, 0.3], [-1.9, 1.1, -0.7]], Rgb::new(13.0, 2.2, 1.0))?,
        lamp([[-0.7, 1.9, -1.9], [0.7, 1.9, -1.9], [0.0, 2.7, -1.6]], Rgb::new(12.0, 8.0, 2.6))?,
        lamp([[2.7, 0.7, 0.2], [1.9, 1.1, -0.7], [2.3, 2.1, 0.3]], Rgb::new(1.2, 4.0, 13.0))?,
    ];
    let camera = stage::camera([0.0, 2.6, 6.2], [0.0, 0.75, -0.4], 32.0, &settings.values)?;
    Ok(Box::new(Lit { scene, camera, lamps, answer }))
}
