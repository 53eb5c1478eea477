//! All shapes of the course at any scale, and what f64 knows about them.

use common::{Stream, Vec3, obj::ObjMesh};
use ray_casting::{
    hit::{Hit, Side},
    implicit::{Gyroid, Heart, Implicit, ImplicitSurface, Tanglecube},
    mesh::{Mesh, Shading},
    shape::Shape,
    sphere::Sphere,
    triangle::Triangle,
};

use crate::{
    exact::{Line, Reference, V},
    icosphere::icosphere,
    implicit::{GYROID, HEART, TANGLECUBE, Zeros},
    meshes::asset,
    rays::in_cube,
    shapes::{Surface, scaled_quadric, surface_of},
    triangles::{Facet, Way},
};

/// What is known about a shape in f64.
pub(crate) trait Truth {
    /// Positive where the outward normal points to, negative on the other side; `hit` says near which part of it.
    fn height(&self, hit: &Hit, point: V) -> f64;

    /// Whether the line meets the shape before it has come so far.
    fn is_met(&self, line: &Line, until: f64) -> bool;
}

impl Truth for Surface {
    fn height(&self, _: &Hit, point: V) -> f64 {
        self.value(point)
    }

    fn is_met(&self, line: &Line, until: f64) -> bool {
        self.crossings(line).iter().any(|c| 0.0 < c.distance && c.distance < until)
    }
}

/// An implicit surface of unit size, made `scale` times as large.
struct Scaled<F> {
    function: F,
    scale: f32,
}

impl<F: Implicit> Implicit for Scaled<F> {
    fn value(&self, p: Vec3) -> f32 {
        self.function.value(p / self.scale)
    }

    fn gradient(&self, p: Vec3) -> Vec3 {
        self.function.gradient(p / self.scale)
    }
}

impl Truth for Scaled<&Zeros> {
    fn height(&self, _: &Hit, point: V) -> f64 {
        (self.function.function)(point * (1.0 / f64::from(self.scale)))
    }

    fn is_met(&self, line: &Line, until: f64) -> bool {
        const STEPS: u32 = 1000;
        let shrink = 1.0 / f64::from(self.scale);
        let is_outside = |i: u32| {
            let point = line.at(until * f64::from(i) / f64::from(STEPS));
            (self.function.function)(point * shrink) > 0.0
        };
        (1..=STEPS).any(|i| is_outside(i) != is_outside(i - 1))
    }
}

/// The triangles of a mesh, or one.
impl Truth for Vec<Facet> {
    fn height(&self, hit: &Hit, point: V) -> f64 {
        // The triangle that was hit: of those with its normal, the one whose plane is nearest.
        let normal = V::from(hit.geometric_normal) * if hit.side == Side::Inside { -1.0 } else { 1.0 };
        let facets = self.iter().filter(|facet| facet.normal().unit().dot(normal) > 1.0 - 1e-6);
        let away = |facet: &&Facet| facet.height(hit.position.into()).abs();
        let facet = facets.min_by(|a, b| away(a).total_cmp(&away(b)));
        facet.unwrap().height(point)
    }

    fn is_met(&self, line: &Line, until: f64) -> bool {
        self.iter().flat_map(|facet| facet.crossings(line)).any(|c| 0.0 < c.distance && c.distance < until)
    }
}

/// A shape to leave, and what is known about it.
pub(crate) struct Subject {
    pub(crate) name: &'static str,
    pub(crate) shape: Box<dyn Shape>,
    pub(crate) truth: Box<dyn Truth>,
    pub(crate) center: Vec3,
    /// Radius of what rays are aimed at, in scene units.
    pub(crate) size: f32,
    /// Who leaves it from outside never comes back.
    pub(crate) convex: bool,
}

/// A square floor `wide` in x and z.
fn floor(height: f32, wide: f32) -> [Triangle; 2] {
    let corner = |x: f32, z: f32| Vec3::new(x * wide / 2.0, height, z * wide / 2.0);
    let (a, b, c, d) = (corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0));
    [Triangle::new(a, b, c), Triangle::new(a, c, d)]
}

/// A square floor as a mesh.
pub(crate) fn floor_mesh(height: f32, wide: f32) -> Mesh {
    let positions = floor(height, wide).iter().flat_map(|triangle| triangle.corners).collect();
    let obj = ObjMesh { positions, triangles: vec![[0, 1, 2], [3, 4, 5]], ..ObjMesh::default() };
    Mesh::new(&obj, Shading::Flat).unwrap()
}

/// A mesh `scale` times as large, moved by `center`.
fn scaled_mesh(obj: &ObjMesh, center: Vec3, scale: f32) -> ObjMesh {
    ObjMesh { positions: obj.positions.iter().map(|&p| center + p * scale).collect(), ..obj.clone() }
}

/// All shapes of the course of about this size, somewhere near the scene's origin.
pub(crate) fn subjects(scale: f32, random: &mut Stream) -> Vec<Subject> {
    let place = |random: &mut Stream| in_cube(random) * 3.0 * scale;
    let mut subjects = Vec::new();
    let mut add = |name, shape: Box<dyn Shape>, truth: Box<dyn Truth>, center, size, convex| {
        subjects.push(Subject { name, shape, truth, center, size, convex });
    };
    for _ in 0..4 {
        let sphere = Sphere::new(place(random), scale);
        add("sphere", Box::new(sphere), Box::new(surface_of(&sphere)), sphere.center, scale, true);
    }
    let names =
        ["ellipsoid", "cylinder", "cone", "paraboloid", "hyperboloid of one sheet", "hyperboloid of two sheets"];
    for (kind, name) in names.into_iter().enumerate() {
        for _ in 0..4 {
            let (quadric, surface) = scaled_quadric(kind, scale, random);
            let (center, size) = (surface.center().to_f32(), surface.size as f32);
            add(name, Box::new(quadric), Box::new(surface), center, size, kind < 4);
        }
    }
    let facets = |triangles: &mut dyn Iterator<Item = Triangle>| -> Box<dyn Truth> {
        Box::new(triangles.map(|t| Facet::of(&t, Way::Barycentric)).collect::<Vec<_>>())
    };
    for _ in 0..3 {
        let center = place(random);
        let triangle = Triangle { corners: [(); 3].map(|()| center + in_cube(random) * scale) };
        add("triangle", Box::new(triangle), facets(&mut [triangle].into_iter()), center, scale, true);
    }
    for height in [0.0, in_cube(random).y * scale] {
        let mesh = floor_mesh(height, 400.0 * scale);
        let truth = facets(&mut mesh.triangles());
        add("floor", Box::new(mesh), truth, Vec3::Y * height, scale, true);
    }
    for (name, obj, shading, convex) in [
        ("flat mesh", icosphere(2), Shading::Flat, true),
        ("smooth mesh", icosphere(2), Shading::Smooth, true),
        ("pawn", asset("pawn.obj"), Shading::Smooth, false),
        ("gem", asset("gem.obj"), Shading::Flat, false),
    ] {
        let center = place(random);
        let mesh = Mesh::new(&scaled_mesh(&obj, center, scale), shading).unwrap();
        let middle = mesh.bounds().center();
        let truth = facets(&mut mesh.triangles());
        add(name, Box::new(mesh), truth, middle, scale, convex);
    }
    fn implicit<F: Implicit + 'static>(function: F, zeros: &Zeros, scale: f32) -> Box<dyn Shape> {
        let bound = Sphere::new(Vec3::ZERO, zeros.radius as f32 * scale);
        Box::new(ImplicitSurface { function: Scaled { function, scale }, bound, step: zeros.step as f32 * scale })
    }
    for (name, zeros, shape) in [
        ("tanglecube", &TANGLECUBE, implicit(Tanglecube, &TANGLECUBE, scale)),
        ("heart", &HEART, implicit(Heart, &HEART, scale)),
        ("gyroid", &GYROID, implicit(Gyroid { frequency: 5.0 }, &GYROID, scale)),
    ] {
        let size = zeros.radius as f32 * scale;
        add(name, shape, Box::new(Scaled { function: zeros, scale }), Vec3::ZERO, size, false);
    }
    subjects
}
