//! Picture of exercise 2.5: a coarse ring, as it is and mended.

use std::f32::consts::TAU;

use common::{
    Error, Interval, Rgb, Stream, Vec3,
    color::srgb,
    film::Size,
    float,
    picture::{FilmPoint, Integrator, ORBIT, Panels, Picture, Render, Settings},
    story::{Story, triple},
};
use ray_casting::{
    camera::Camera,
    hit::Hit,
    light::{DirectionalLight, Light as _},
    local_illumination::tell_ray,
    material::Phong,
    pictures::stage::camera,
    ray::Ray,
    triangle::Triangle,
    triangle_barycentric::Shear,
};
use shadows::offset::Offset;

use super::Make;

/// What a student writes: a function of point, corners, normals and weights.
type Lift = fn(Vec3, [Vec3; 3], [Vec3; 3], [f32; 3]) -> Vec3;

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A pale ring of flat triangles, shaded smooth, twice under a low sun. Left, light fades into shadow along a jagged \
               line, in which single triangles show. Right, the line is soft and round.";
    let size = Size::of::<960, 420>();
    Picture { size, samples: 8, knobs: &ORBIT, ..super::picture("2.5-lifted-point", alt, make) }
}

/// A triangle with the normals of the round surface in its corners.
struct Facet {
    triangle: Triangle,
    normals: [Vec3; 3],
}

/// A ring of facets in the sun.
struct Ring {
    facets: Vec<Facet>,
    camera: Camera,
    sun: DirectionalLight,
    lift: Lift,
}

/// Radii of the ring and of its tube, in scene units.
const RADII: [f32; 2] = [1.0, 0.46];
/// Parts around the ring and around its tube.
const PARTS: [u8; 2] = [14, 8];

/// All facets of the ring.
fn facets() -> Vec<Facet> {
    // Place and normal by the shares of both turns.
    let corner = |around: u8, across: u8| {
        let [u, v] = [(around, PARTS[0]), (across, PARTS[1])].map(|(i, n)| f32::from(i) / f32::from(n) * TAU);
        let outward = Vec3::new(float::cos(u), 0.0, float::sin(u));
        let normal = outward * float::cos(v) + Vec3::Y * float::sin(v);
        (outward * RADII[0] + normal * RADII[1], normal)
    };
    let quads = (0..PARTS[0]).flat_map(|i| (0..PARTS[1]).map(move |j| (i, j)));
    let halves = quads.flat_map(|(i, j)| {
        let [a, b, c, d] = [corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)];
        [[a, b, c], [a, c, d]]
    });
    let facet =
        |[a, b, c]: [(Vec3, Vec3); 3]| Facet { triangle: Triangle::new(a.0, b.0, c.0), normals: [a.1, b.1, c.1] };
    halves.map(facet).collect()
}

impl Ring {
    /// The nearest hit, the facet, and the weights there.
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<(Hit, &Facet, [f32; 3])> {
        // What passes the ball around the ring passes the ring.
        let middle = -ray.origin.dot(ray.direction);
        if ray.at(middle).length() > RADII[0] + RADII[1] {
            return None;
        }
        let along = Shear::along(ray);
        let (mut nearest, mut range) = (None, range);
        for facet in &self.facets {
            if let Some(hit) = facet.triangle.hit_by_barycentric(&along, range) {
                range = range.up_to(hit.t);
                nearest = Some((hit, facet));
            }
        }
        let (hit, facet) = nearest?;
        let Facet { triangle, normals } = facet;
        let [a, b, c] = normals;
        let smooth = *a * hit.weights[0] + *b * hit.weights[1] + *c * hit.weights[2];
        let whole = Hit::new(ray, hit.t, triangle.normal()).among(triangle.farthest()).shaded_with(smooth);
        Some((whole, facet, hit.weights))
    }
}

impl Integrator for Ring {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = self.camera.ray(point);
        tell_ray(story, &ray);
        let ambient = Rgb::new(0.07, 0.085, 0.13);
        let Some((hit, facet, weights)) = self.intersect(&ray, Interval::POSITIVE) else {
            return Rgb::new(0.045, 0.052, 0.072);
        };
        let look = Phong::of(srgb(226, 212, 190), 0.0, 1.0);
        let sunlight = self.sun.illuminate(hit.position);
        let place = (self.lift)(hit.position, facet.triangle.corners, facet.normals, weights);
        story.tell(|| format!("at {}, shadow ray from {}", triple(hit.position), triple(place)));
        let start = Offset::Following.origin(&Hit { position: place, ..hit }, hit.geometric_normal);
        let is_hidden = self.intersect(&Ray::new(start, sunlight.direction), Interval::POSITIVE).is_some();
        let lit = if is_hidden { Rgb::ZERO } else { sunlight.strength };
        look.ambient * ambient + lit * look.diffuse_term(sunlight.direction, hit.shading_normal)
    }
}

/// The ring without and with what `lift` does.
pub(crate) fn make(settings: &Settings, lift: Lift) -> Result<Box<dyn Render>, Error> {
    let view = |lift: Lift| -> Result<Box<dyn Render>, Error> {
        let camera = camera([0.5, 3.1, 4.2], [0.0, -0.05, 0.0], 36.0, &settings.values)?;
        let sun = DirectionalLight::new(Vec3::new(-0.75, 0.42, 0.5), Rgb::new(3.6, 3.1, 2.4));
        Ok(Box::new(Ring { facets: facets(), camera, sun, lift }))
    };
    Ok(Box::new(Panels::new(2, vec![view(|point, _, _, _| point)?, view(lift)?])))
}
