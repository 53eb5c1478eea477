//! Meshes: the nearest of their triangles is hit, and no ray slips between two of them.

use std::{collections::HashSet, path::Path};

use common::{
    Interval, Stream, Vec3,
    obj::{self, ObjMesh},
};
use ray_casting::{
    hit::Hit,
    mesh::{Mesh, Shading},
    ray::Ray,
    shape::Shape,
    triangle::Triangle,
    triangle_barycentric::Shear,
};

use crate::{
    exact::{Crossing, Line, Reference, Tally, V},
    icosphere::icosphere,
    rays::{Target, aimed, in_cube, magnitude, one_of},
    triangles::{Facet, Way, random_point},
};

/// How many rays found no triangle at all, although a closed surface is around them.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Leaks {
    pub(crate) rays: u32,
    pub(crate) by_edges: u32,
    pub(crate) by_barycentric: u32,
}

/// A random point on an edge of the mesh: a corner, the middle, or any other; and the corner it is next to.
fn on_edge(mesh: &ObjMesh, random: &mut Stream) -> (Vec3, u32) {
    let corners = mesh.triangles[one_of(random, mesh.triangles.len())];
    let i = one_of(random, 3);
    let [from, to] = [corners[i], corners[(i + 1) % 3]];
    let [p, q] = [from, to].map(|corner| mesh.positions[corner as usize]);
    let share = [0.0, 0.5, random.uniform()][one_of(random, 3)];
    (p + (q - p) * share, from)
}

/// Rays from inside a fine sphere aimed at its edges.
pub(crate) fn leaks_of_a_sphere() -> Leaks {
    let sphere = icosphere(5);
    // A ray that is aimed at an edge can meet only triangles around the edge.
    let mut around = vec![Vec::new(); sphere.positions.len()];
    for corners in &sphere.triangles {
        for &corner in corners {
            around[corner as usize].push(corners);
        }
    }
    let mut random = Stream::new(305, 0, 0);
    let mut leaks = Leaks::default();
    while leaks.rays < 200_000 {
        let (aim, corner) = on_edge(&sphere, &mut random);
        let ray = match leaks.rays % 4 {
            // Along an axis, so that the ray meets the edge exactly.
            0 if aim.truncate().length() < 0.9 => {
                Ray::new(aim.with_z(0.0), Vec3::Z * aim.z.signum() * magnitude(&mut random, 0.1, 10.0))
            }
            1 => Ray::new(Vec3::ZERO, aim),
            _ => aimed(in_cube(&mut random) * 0.5, aim),
        };
        let along = Shear::along(&ray);
        let triangles = around[corner as usize].iter();
        let mut triangles = triangles.map(|c| Triangle { corners: c.map(|i| sphere.positions[i as usize]) });
        leaks.rays += 1;
        let by_edges = triangles.clone().any(|t| t.hit_by_edges(&ray, Interval::POSITIVE).is_some());
        let by_barycentric = triangles.any(|t| t.hit_by_barycentric(&along, Interval::POSITIVE).is_some());
        leaks.by_edges += u32::from(!by_edges);
        leaks.by_barycentric += u32::from(!by_barycentric);
    }
    leaks
}

#[test]
fn no_ray_slips_between_the_triangles_of_a_sphere() {
    let leaks = leaks_of_a_sphere();
    assert_eq!(leaks.by_barycentric, 0, "{leaks:?}");
    // So the rays do meet the edges: the first way, which rounds differently on both sides, loses some.
    assert!(leaks.by_edges > 0, "{leaks:?}");
}

pub(crate) fn asset(name: &str) -> ObjMesh {
    obj::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets").join(name)).unwrap()
}

/// Whether each edge belongs to two triangles, which run through it in opposite directions.
fn is_closed(mesh: &ObjMesh) -> bool {
    let edges = || mesh.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let directed: HashSet<_> = edges().collect();
    directed.len() == edges().count() && edges().all(|(a, b)| directed.contains(&(b, a)))
}

#[test]
fn no_ray_leaves_a_closed_mesh() {
    let mut random = Stream::new(306, 0, 0);
    let mut shoot = |obj: &ObjMesh, rays: u32, inside: fn(&mut Stream) -> Vec3| {
        assert!(is_closed(obj));
        let mesh = Mesh::new(obj, Shading::Flat).unwrap();
        for _ in 0..rays {
            let ray = aimed(inside(&mut random), on_edge(obj, &mut random).0);
            assert!(mesh.intersect(&ray, Interval::POSITIVE).is_some(), "{ray:?}");
        }
    };
    // Start around the pawn's axis, and anywhere in the sphere.
    shoot(&asset("pawn.obj"), 60_000, |random| Vec3::new(0.1, 0.9, 0.1) * in_cube(random) + Vec3::Y);
    shoot(&icosphere(3), 40_000, |random| in_cube(random) * 0.5);
}

/// All triangles of a mesh in f64.
struct Facets(Vec<Facet>);

impl Reference for Facets {
    fn crossings(&self, line: &Line) -> Vec<Crossing> {
        let mut crossings: Vec<_> = self.0.iter().flat_map(|facet| facet.crossings(line)).collect();
        // What may be met first comes first.
        crossings.sort_by(|a, b| (a.distance - a.tolerance).total_cmp(&(b.distance - b.tolerance)));
        crossings
    }

    fn check_hit(&self, line: &Line, hit: &Hit, _: &Crossing) -> Result<(), String> {
        // One of the triangles must agree.
        let fits = |facet: &Facet| facet.crossings(line).iter().any(|c| facet.check_hit(line, hit, c).is_ok());
        if self.0.iter().any(fits) { Ok(()) } else { Err(format!("{hit:?} is on no triangle")) }
    }
}

#[test]
fn a_mesh_is_hit_where_its_nearest_triangle_is() {
    for (name, center, size) in [("pawn.obj", Vec3::Y, 1.2), ("gem.obj", Vec3::Y * 0.5, 0.7)] {
        let mesh = Mesh::new(&asset(name), Shading::Flat).unwrap();
        let facets = Facets(mesh.triangles().map(|triangle| Facet::of(&triangle, Way::Barycentric)).collect());
        let corners: Vec<_> = mesh.triangles().collect();
        let surface = |random: &mut Stream| {
            let triangle = corners[one_of(random, corners.len())];
            (random_point(&triangle, random).into(), V::from(triangle.normal()).unit())
        };
        let target = Target { center, size, farthest: 1e3, surface: &surface };
        let (mut random, mut tally) = (Stream::new(307, 0, 0), Tally::default());
        for i in 0..4_000 {
            let ray = target.ray(i, &mut random);
            let range = target.range(&ray, &mut random);
            facets.check(&mesh, &ray, range, &mut tally).unwrap_or_else(|error| panic!("{name}: {error}"));
        }
        tally.assert_fair(4_000, 0.2, 0.05);
    }
}
