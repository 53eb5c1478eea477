//! Both ways to hit a triangle, against f64.

use common::{Interval, Stream, Vec3};
use ray_casting::{
    hit::{Hit, Side},
    ray::Ray,
    shape::Shape,
    triangle::{Triangle, TriangleHit},
    triangle_barycentric::Shear,
};

use crate::{
    exact::{Crossing, EPSILON, Line, ROUNDINGS, Reference, Tally, V, check_normals},
    rays::{Target, aimed, direction, in_cube, magnitude, one_of},
};

/// A triangle in f64, and which way the f32 goes that it judges.
pub(crate) struct Facet {
    corners: [V; 3],
    way: Way,
}

/// The two ways to hit a triangle.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Way {
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
    pub(crate) fn of(triangle: &Triangle, way: Way) -> Facet {
        Facet { corners: triangle.corners.map(V::from), way }
    }

    pub(crate) fn normal(&self) -> V {
        let [r1, r2, r3] = self.corners;
        (r2 - r1).cross(r3 - r1)
    }

    /// How far above the plane of the triangle a point is, on the side that its normal points to.
    pub(crate) fn height(&self, point: V) -> f64 {
        (point - self.corners[0]).dot(self.normal().unit())
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

    /// A line nearly in the plane of a triangle may meet it anywhere or not at all, unless it is clearly beside.
    fn seen_along_its_plane(&self, line: &Line, reach: f64) -> Vec<Crossing> {
        let middle = self.corners.into_iter().fold(V::ZERO, |sum, r| sum + r) * (1.0 / 3.0);
        let distance = (middle - line.origin).dot(line.direction);
        let (aside, n) = (middle - line.at(distance), self.normal().unit());
        let (size, blur) = (self.longest_side(), ROUNDINGS * EPSILON * reach);
        if aside.length() > size + blur || aside.dot(n).abs() > size * line.direction.dot(n).abs() + blur {
            return vec![];
        }
        vec![Crossing { distance, tolerance: size, certain: false }]
    }
}

impl Reference for Facet {
    fn crossings(&self, line: &Line) -> Vec<Crossing> {
        let Met { distance, weights, slack, reach } = self.meet(line);
        let least = weights.into_iter().fold(f64::INFINITY, f64::min);
        if least < -slack {
            return vec![];
        }
        if slack.is_nan() || slack > 0.1 {
            return self.seen_along_its_plane(line, reach);
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
        let tolerance = ROUNDINGS * EPSILON * (1.0 + self.longest_side() * self.longest_side() / n.length());
        check_normals(line, hit, n, tolerance)
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
pub(crate) fn random_point(triangle: &Triangle, random: &mut Stream) -> Vec3 {
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

/// A triangle, up to a hundred thousand times as long as wide.
fn random_sliver(random: &mut Stream) -> Triangle {
    let length = magnitude(random, 1e-2, 10.0);
    let (start, way) = (in_cube(random) * 5.0, direction(random));
    let aside = direction(random) * length * magnitude(random, 1e-5, 1e-1);
    let [r1, r2, r3] = [start, start + way * length, start + way * length * random.uniform() + aside];
    Triangle::new(r1, r2, r3)
}

/// How far, as a share of ε times the distance to the farthest corner, the place on the ray is from the place on the
/// triangle that the same hit tells; the worst of many rays at slivers, from far, near, and right beside them.
fn worst_gap(seed: u64, hit: impl Fn(&Triangle, &Shear) -> Option<TriangleHit>) -> f64 {
    let mut random = Stream::new(seed, 0, 0);
    let (mut worst, mut hits) = (0.0_f64, 0);
    for i in 0..400_000 {
        let triangle = random_sliver(&mut random);
        let aim = random_point(&triangle, &mut random);
        let ray = match i % 3 {
            0 => aimed(aim + in_cube(&mut random) * magnitude(&mut random, 1e-3, 1e2), aim),
            1 => aimed(aim + direction(&mut random) * magnitude(&mut random, 1e-8, 1e-4), aim),
            // Nearly along it.
            _ => aimed(random_point(&triangle, &mut random) + in_cube(&mut random) * 1e-5, aim),
        };
        let Some(hit) = hit(&triangle, &Shear::along(&ray)) else { continue };
        hits += 1;
        let (o, d) = (V::from(ray.origin), V::from(ray.direction));
        let corners = triangle.corners.map(V::from);
        let sum = |sum: V, (r, w): (V, f32)| sum + (r - o) * f64::from(w);
        let on_triangle = corners.into_iter().zip(hit.weights).fold(V::ZERO, sum);
        let largest = |v: V| v.0.into_iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let farthest = corners.map(|r| largest(r - o)).into_iter().fold(0.0, f64::max);
        worst = worst.max(largest(on_triangle - d * f64::from(hit.t)) / (EPSILON * farthest));
    }
    assert!(hits > 100_000, "{hits}");
    worst
}

/// The structures of chapter 4 count on it: for a triangle whose corners are moved by less than six roundings, a hit is
/// exactly right, however thin the triangle is. Each of its three numbers is rounded once more when it is told.
#[test]
fn a_hit_is_right_for_corners_a_hair_beside_their_places() {
    let worst = worst_gap(305, |triangle, along| triangle.hit_by_barycentric(along, Interval::POSITIVE));
    assert!(worst > 0.5 && worst < 6.0, "{worst}");
}

/// With areas in f32 alone, they are rounded too much, and the test above would say so.
#[test]
fn areas_of_slivers_need_more_than_f32() {
    let worst = worst_gap(305, |triangle, along| {
        let [a, b, c] = triangle.corners.map(|r| along.view(r));
        let area = |p: Vec3, q: Vec3| p.x * q.y - p.y * q.x;
        let areas = [area(c, b), area(a, c), area(b, a)];
        let inside = areas.iter().all(|&a| a >= 0.0) || areas.iter().all(|&a| a <= 0.0);
        let sum: f32 = areas.iter().sum();
        let weights = areas.map(|area| area / sum);
        let t = weights[0] * a.z + weights[1] * b.z + weights[2] * c.z;
        (inside && t > 0.0).then_some(TriangleHit { t, weights })
    });
    assert!(worst > 100.0, "{worst}");
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
        // between its neighbors, and it may be hit; but only where the ray meets that line, and facing the ray.
        let Some(hit) = triangle.intersect(&ray, Interval::POSITIVE) else { continue };
        let across = V::from(d).cross(V::from(ray.direction));
        let aside = (V::from(ray.origin) - V::from(c)).dot(across.unit()).abs();
        let scale = f64::from(c.length() + d.length() + ray.origin.length());
        assert!(i % 4 == 3 && aside < ROUNDINGS * EPSILON * scale, "{triangle:?} {ray:?} {hit:?}");
        assert_eq!(hit.geometric_normal, -ray.direction.normalize());
    }
}
