//! Triangles and meshes: both ways to hit a triangle against each other and against f64, and no ray between two of them.

use std::{collections::HashSet, path::Path};

use common::{
    Interval, Stream, Vec3,
    obj::{self, ObjMesh},
};
use ray_casting::{
    hit::{Hit, Side},
    mesh::{Mesh, Shading},
    ray::Ray,
    shape::Shape,
    triangle::Triangle,
    triangle_barycentric::Shear,
};

use crate::{
    exact::{Crossing, EPSILON, Line, Reference, Tally, V},
    icosphere::icosphere,
    rays::{Target, aimed, between, direction, in_cube, magnitude, one_of},
};

/// How many roundings an honest computation may add up.
const ROUNDINGS: f64 = 4.0;

/// A triangle in f64, and which way the f32 goes that it judges.
struct Facet {
    corners: [V; 3],
    way: Way,
}

/// The two ways to hit a triangle.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Edges,
    Barycentric,
}

/// What f64 says about a line and the plane of a triangle.
struct Met {
    distance: f64,
    weights: [f64; 3],
    /// By how much an honest f32 computation may differ in the weights.
    slack: f64,
    /// Distance of what is farthest away, all of which is rounded.
    reach: f64,
}

impl Facet {
    fn of(triangle: &Triangle, way: Way) -> Facet {
        Facet { corners: triangle.corners.map(V::from), way }
    }

    fn normal(&self) -> V {
        let [r1, r2, r3] = self.corners;
        (r2 - r1).cross(r3 - r1)
    }

    fn longest_side(&self) -> f64 {
        let [r1, r2, r3] = self.corners;
        (r2 - r1).length().max((r3 - r2).length()).max((r1 - r3).length())
    }

    /// Where the line meets the plane, and the shares of the triangle's area that each corner has there.
    fn meet(&self, line: &Line) -> Met {
        let ([r1, r2, r3], n) = (self.corners, self.normal());
        let distance = (r1 - line.origin).dot(n) / line.direction.dot(n);
        let p = line.at(distance);
        let share = |from: V, to: V| (to - from).cross(p - from).dot(n) / n.dot(n);
        let reach = self.corners.map(|r| (r - line.origin).length().max(r.length())).into_iter().fold(0.0, f64::max);
        let reach = reach.max(line.origin.length());
        // A blur of the ray across, divided by the height of the triangle as the ray sees it.
        let slack = ROUNDINGS * EPSILON * reach * self.longest_side() / line.direction.dot(n).abs();
        // The first way meets the plane first: a thin triangle's rounded normal leans, and carries the point aside.
        let leaning = self.longest_side() * self.longest_side() / n.length();
        let slack = if self.way == Way::Edges { slack * leaning } else { slack };
        Met { distance, weights: [share(r2, r3), share(r3, r1), share(r1, r2)], slack, reach }
    }
}

impl Reference for Facet {
    fn crossings(&self, line: &Line) -> Vec<Crossing> {
        let Met { distance, weights, slack, reach } = self.meet(line);
        let least = weights.into_iter().fold(f64::INFINITY, f64::min);
        if least < -slack {
            return vec![];
        }
        // Seen along its plane, a triangle may be hit anywhere or not at all.
        if !(slack < 0.1) {
            let middle = (self.corners[0] + self.corners[1] + self.corners[2]) * (1.0 / 3.0);
            let distance = (middle - line.origin).dot(line.direction);
            return vec![Crossing { distance, tolerance: self.longest_side(), certain: false }];
        }
        let tolerance = slack * self.longest_side() + ROUNDINGS * EPSILON * reach;
        vec![Crossing { distance, tolerance, certain: least > slack }]
    }

    fn check_hit(&self, line: &Line, hit: &Hit, crossing: &Crossing) -> Result<(), String> {
        if !crossing.certain {
            return Ok(());
        }
        let position = V::from(hit.position);
        let away = (position - line.at(crossing.distance)).length();
        if away > crossing.tolerance + ROUNDINGS * EPSILON * position.length() {
            return Err(format!("{hit:?} is {away} away from its place"));
        }
        let n = self.normal();
        let leaves = n.dot(line.direction) > 0.0;
        let expected = n.unit() * if leaves { -1.0 } else { 1.0 };
        let error = (V::from(hit.geometric_normal) - expected).length();
        let tolerance = ROUNDINGS * EPSILON * (1.0 + self.longest_side() * self.longest_side() / n.length());
        if error > tolerance || hit.shading_normal != hit.geometric_normal {
            return Err(format!("normals of {hit:?} are {error} away from {expected:?}, allowed {tolerance}"));
        }
        let side = if leaves { Side::Inside } else { Side::Outside };
        if hit.side == side { Ok(()) } else { Err(format!("{hit:?} should be on the side {side:?}")) }
    }
}

/// A triangle that is hit by its edges.
struct ByEdges(Triangle);

impl Shape for ByEdges {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        Some(Hit::new(ray, self.0.hit_by_edges(ray, range)?, self.0.normal()))
    }
}

/// A point of a triangle: inside, or sometimes on an edge or in a corner.
fn random_point(triangle: &Triangle, random: &mut Stream) -> Vec3 {
    let [r1, r2, r3] = triangle.corners;
    let (mut u, mut v) = (random.uniform(), random.uniform());
    if u + v > 1.0 {
        (u, v) = (1.0 - u, 1.0 - v);
    }
    match one_of(random, 100) {
        0 => r1,
        1 => r2 + (r3 - r2) * u,
        _ => r1 + (r2 - r1) * u + (r3 - r1) * v,
    }
}

/// A random triangle of size 10⁻³ to 10³; every sixth is a sliver or a needle.
fn random_triangle(random: &mut Stream) -> Triangle {
    let size = magnitude(random, 1e-3, 1e3);
    let center = in_cube(random) * size * magnitude(random, 0.01, 10.0);
    let [r1, r2, r3] = [(); 3].map(|()| center + in_cube(random) * size);
    let thin = magnitude(random, 1e-3, 1e-1);
    match one_of(random, 12) {
        0 => Triangle::new(r1, r2, r1 + (r2 - r1) * random.uniform() + direction(random) * size * thin),
        1 => Triangle::new(r1, r2, r2 + direction(random) * size * thin),
        _ => Triangle::new(r1, r2, r3),
    }
}

/// What to aim at when asking about a triangle.
fn with_target<T>(triangle: &Triangle, ask: impl FnOnce(&Target) -> T) -> T {
    let facet = Facet::of(triangle, Way::Edges);
    let [r1, r2, r3] = triangle.corners;
    let surface = |random: &mut Stream| (random_point(triangle, random).into(), facet.normal().unit());
    let size = facet.longest_side() as f32;
    ask(&Target { center: (r1 + r2 + r3) / 3.0, size, farthest: 1e3, surface: &surface })
}

#[test]
fn both_ways_hit_triangles_where_f64_does() {
    let mut random = Stream::new(301, 0, 0);
    let mut tallies = [Tally::default(), Tally::default()];
    for _ in 0..4_000 {
        let triangle = random_triangle(&mut random);
        let ways: [(_, &dyn Shape); 2] = [(Way::Edges, &ByEdges(triangle)), (Way::Barycentric, &triangle)];
        with_target(&triangle, |target| {
            for i in 0..36 {
                let ray = target.ray(i, &mut random);
                let range = target.range(&ray, &mut random);
                for ((way, shape), tally) in ways.into_iter().zip(&mut tallies) {
                    let judged = Facet::of(&triangle, way).check(shape, &ray, range, tally);
                    judged.unwrap_or_else(|error| panic!("{triangle:?}: {error}"));
                }
            }
        });
    }
    let [by_edges, by_barycentric] = tallies;
    by_edges.assert_fair(100_000, 0.1, 0.06);
    by_barycentric.assert_fair(100_000, 0.1, 0.02);
}

#[test]
fn weights_are_shares_of_the_area() {
    let mut random = Stream::new(302, 0, 0);
    let mut hits = 0;
    for _ in 0..100_000 {
        let triangle = random_triangle(&mut random);
        let aim = random_point(&triangle, &mut random);
        let ray = aimed(aim + in_cube(&mut random) * magnitude(&mut random, 1e-3, 1e3), aim);
        let Some(hit) = triangle.hit_by_barycentric(&Shear::along(&ray), Interval::POSITIVE) else { continue };
        let met = Facet::of(&triangle, Way::Barycentric).meet(&Line::of(&ray));
        if met.slack > 0.1 {
            continue;
        }
        hits += 1;
        for (weight, expected) in hit.weights.into_iter().zip(met.weights) {
            assert!(weight >= 0.0, "{weight}");
            assert!((f64::from(weight) - expected).abs() < met.slack, "{weight} {expected} {}", met.slack);
        }
        assert!((hit.weights.iter().sum::<f32>() - 1.0).abs() < 3.0 * f32::EPSILON);
    }
    assert!(hits > 80_000, "{hits}");
}

/// Each of these mistakes is found among 36 rays at each of 100 triangles.
#[test]
fn mistakes_in_triangles_are_found() {
    type Mistake = fn(&Triangle, &Ray, Interval) -> Option<Hit>;
    let mistakes: [(&str, Mistake); 5] = [
        ("a fixed bound drops small triangles", |triangle, ray, range| {
            let is_large = triangle.normal().dot(ray.direction).abs() > 1e-6;
            triangle.intersect(ray, range).filter(|_| is_large)
        }),
        ("only from outside", |triangle, ray, range| {
            triangle.intersect(ray, range).filter(|hit| hit.side == Side::Outside)
        }),
        ("corners in the wrong order", |triangle, ray, range| {
            let [r1, r2, r3] = triangle.corners;
            Triangle::new(r1, r3, r2).intersect(ray, range)
        }),
        ("one edge forgotten", |triangle, ray, range| {
            let [r1, r2, r3] = triangle.corners;
            let beyond = Triangle::new(r1, r2 + (r2 - r1), r3 + (r3 - r1));
            triangle.intersect(ray, range).or_else(|| beyond.intersect(ray, range))
        }),
        ("a hundredth too small", |triangle, ray, range| {
            let middle = triangle.corners.into_iter().sum::<Vec3>() / 3.0;
            let smaller = triangle.corners.map(|r| middle + (r - middle) * 0.99);
            Triangle { corners: smaller }.intersect(ray, range)
        }),
    ];
    struct Mistaken(Triangle, Mistake);
    impl Shape for Mistaken {
        fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
            self.1(&self.0, ray, range)
        }
    }
    for (what, mistake) in mistakes {
        let mut random = Stream::new(303, 0, 0);
        let found = (0..100).any(|_| {
            let triangle = random_triangle(&mut random);
            let facet = Facet::of(&triangle, Way::Barycentric);
            with_target(&triangle, |target| {
                (0..36).any(|i| {
                    let ray = target.ray(i, &mut random);
                    let shape = Mistaken(triangle, mistake);
                    facet.check(&shape, &ray, Interval::POSITIVE, &mut Tally::default()).is_err()
                })
            })
        });
        assert!(found, "{what}");
    }
}

#[test]
fn triangles_without_area_are_no_surface() {
    let mut random = Stream::new(304, 0, 0);
    for i in 0..100_000 {
        // Two or three corners in one point, or all on a line, exactly so in f32.
        let size = magnitude(&mut random, 1e-3, 1e3);
        let (a, b) = (in_cube(&mut random) * size, in_cube(&mut random) * size);
        let [c, d] = [a, b].map(|v| (v * (512.0 / size)).round());
        let corners = [[a, a, a], [a, a, b], [a, b, a], [c, c + d * 2.0, c + d]][i % 4];
        let triangle = Triangle { corners };
        let aim = random_point(&triangle, &mut random);
        let ray = aimed(aim + in_cube(&mut random) * size, aim);
        assert_eq!(triangle.hit_by_edges(&ray, Interval::POSITIVE), None, "{triangle:?} {ray:?}");
        // Seen along a ray, three corners on a line may be rounded to a triangle one rounding thin. It fills the crack
        // between its neighbours, and it may be hit; but only where the ray
        // meets that line, and facing the ray.
        let Some(hit) = triangle.intersect(&ray, Interval::POSITIVE) else { continue };
        let across = V::from(d).cross(V::from(ray.direction));
        let aside = (V::from(ray.origin) - V::from(c)).dot(across.unit()).abs();
        let scale = f64::from(c.length() + d.length() + ray.origin.length());
        assert!(i % 4 == 3 && aside < ROUNDINGS * EPSILON * scale, "{triangle:?} {ray:?} {hit:?}");
        assert_eq!(hit.geometric_normal, -ray.direction.normalize());
    }
}

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
    let mut around = vec![HashSet::new(); sphere.positions.len()];
    for corners in &sphere.triangles {
        for &corner in corners {
            around[corner as usize].insert(corners);
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
    let (pawn, sphere) = (asset("pawn.obj"), icosphere(3));
    let mut random = Stream::new(306, 0, 0);
    // Points inside: around the pawn's axis, and anywhere in the sphere.
    let in_pawn = |random: &mut Stream| Vec3::new(0.1, 0.9, 0.1) * in_cube(random) + Vec3::Y;
    let in_sphere = |random: &mut Stream| in_cube(random) * 0.5;
    let meshes: [(&ObjMesh, &dyn Fn(&mut Stream) -> Vec3, u32); 2] =
        [(&pawn, &in_pawn, 60_000), (&sphere, &in_sphere, 40_000)];
    for (obj, inside, rays) in meshes {
        assert!(is_closed(obj));
        let mesh = Mesh::new(obj, Shading::Flat).unwrap();
        for _ in 0..rays {
            let ray = aimed(inside(&mut random), on_edge(obj, &mut random).0);
            assert!(mesh.intersect(&ray, Interval::POSITIVE).is_some(), "{ray:?}");
        }
    }
}
