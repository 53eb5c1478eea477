//! Picture of exercise 1.5: lattice balls.

use common::{
    Error, Interval, Rgb, Vec3,
    color::srgb,
    picture::{Picture, Render, Settings},
};
use ray_casting::{
    hit::Hit,
    material::Phong,
    ray::Ray,
    shape::Shape,
    sphere::Sphere,
    triangle::{Triangle, TriangleHit},
};

use super::stage::{self, Make, camera, stage, view};

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "Three lattice balls on a dark stage, of 20, 80 and 320 triangles: only a strip along the edges of each triangle is \
               there, so that one sees through to the far side and to a glossy ball inside each.";
    stage::picture("1.5-triangle", alt, make)
}

/// The student's function.
pub(crate) type Intersect = fn(&Triangle, &Ray, Interval) -> Option<TriangleHit>;

/// The strips along the edges of many triangles.
struct Lattice {
    triangles: Vec<Triangle>,
    bound: Sphere,
    /// Least weight of the points that are cut out: a third of the triangle's height at most.
    width: f32,
    intersect: Intersect,
}

impl Shape for Lattice {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        // Most rays miss the ball, and so all its triangles.
        self.bound.roots(ray).span()?;
        let mut nearest = None;
        let mut range = range;
        for triangle in &self.triangles {
            let hit = (self.intersect)(triangle, ray, range);
            // What is far from all three edges is cut out.
            let strip = hit.filter(|hit| hit.weights.iter().any(|weight| *weight < self.width));
            if let Some(hit) = strip {
                range = range.up_to(hit.t);
                nearest = Some(Hit::new(ray, hit.t, triangle.normal()));
            }
        }
        nearest
    }
}

/// The balls, with triangles that `intersect` meets.
pub(crate) fn make(settings: &Settings, intersect: Intersect) -> Result<Box<dyn Render>, Error> {
    let mut scene = stage()?;
    let gold = Phong::of(srgb(214, 164, 62), 0.6, 50.0);
    let cream = Phong::of(srgb(226, 212, 184), 0.4, 40.0);
    let teal = Phong::of(srgb(52, 140, 140), 0.6, 60.0);
    let glossy = |color: Rgb| Phong::of(color, 0.9, 120.0);
    for (x, z, radius, halvings, width, lattice, inside) in [
        (-2.0, -0.5, 0.85, 0, 0.07, gold, glossy(srgb(190, 40, 48))),
        (0.0, 0.0, 1.0, 1, 0.10, cream, glossy(srgb(60, 104, 200))),
        (2.1, -0.7, 1.1, 2, 0.13, teal, glossy(srgb(206, 108, 74))),
    ] {
        let center = Vec3::new(x, radius, z);
        let triangles =
            ball(halvings).into_iter().map(|t| Triangle { corners: t.map(|v| center + v * radius) }).collect();
        let bound = Sphere::new(center, radius * 1.001);
        scene.add("lattice", Lattice { triangles, bound, width, intersect }, lattice);
        scene.add("ball", Sphere::new(center, radius * 0.52), inside);
    }
    Ok(view(scene, camera([0.3, 2.7, 7.4], [0.05, 0.92, -0.2], 28.0, &settings.values)?))
}

/// The icosahedron with its corners on the unit sphere, each triangle parted into four as often as `halvings` says.
fn ball(halvings: u32) -> Vec<[Vec3; 3]> {
    // Three golden rectangles at right angles to each other. The golden ratio is (1 + √5)/2.
    let golden = (1.0 + 5.0_f32.sqrt()) / 2.0;
    let corners: Vec<Vec3> = [Vec3::new(0.0, 1.0, golden), Vec3::new(golden, 0.0, 1.0), Vec3::new(1.0, golden, 0.0)]
        .into_iter()
        .flat_map(|v| [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)].map(|(a, b)| mirrored(v, a, b)))
        .collect();
    // Corners 2 apart are neighbors; three that are neighbors of each other are a face.
    let are_neighbors = |a: Vec3, b: Vec3| (a.distance(b) - 2.0).abs() < 0.1;
    let mut faces = Vec::new();
    for (i, &a) in corners.iter().enumerate() {
        for (j, &b) in corners.iter().enumerate().skip(i + 1) {
            for &c in corners.iter().skip(j + 1) {
                if are_neighbors(a, b) && are_neighbors(b, c) && are_neighbors(c, a) {
                    // Counter-clockwise when seen from outside.
                    let is_outward = (b - a).cross(c - a).dot(a) > 0.0;
                    faces.push(if is_outward { [a, b, c] } else { [a, c, b] }.map(Vec3::normalize));
                }
            }
        }
    }
    for _ in 0..halvings {
        faces = faces.into_iter().flat_map(parted).collect();
    }
    faces
}

/// A vector with one coordinate 0, its others multiplied by `a` and `b`.
fn mirrored(v: Vec3, a: f32, b: f32) -> Vec3 {
    let signs = match v.to_array() {
        [0.0, ..] => Vec3::new(1.0, a, b),
        [_, 0.0, _] => Vec3::new(a, 1.0, b),
        _ => Vec3::new(a, b, 1.0),
    };
    v * signs
}

/// A triangle of the unit sphere parted into four.
fn parted([a, b, c]: [Vec3; 3]) -> [[Vec3; 3]; 4] {
    let [ab, bc, ca] = [a + b, b + c, c + a].map(Vec3::normalize);
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
}
