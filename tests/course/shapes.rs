//! Sphere and quadrics against their equations, solved in f64.

#![expect(clippy::disallowed_methods, reason = "f64 has digits to spare: its last bits do not matter here")]

use common::{Interval, Stream, Vec3};
use ray_casting::{
    frame::Frame,
    hit::{Hit, Side},
    quadric::Quadric,
    ray::Ray,
    shape::Shape,
    sphere::{Sphere, TextbookSphere},
};

use crate::{
    exact::{AXES, Crossing, EPSILON, Line, ROUNDINGS, Reference, Tally, V, check_normals},
    rays::{Target, between, direction, in_cube, magnitude, one_of},
};

/// A surface of second degree as the books write it: the zeros of a function, between two heights, in a turned frame.
pub(crate) struct Surface {
    pub(crate) function: Box<dyn Fn(V) -> f64>,
    heights: [f64; 2],
    /// Radius of a ball around all of it.
    pub(crate) size: f64,
    center: V,
    /// Axes and angles in degrees by which it was turned, in order.
    turns: Vec<(V, f64)>,
}

impl Surface {
    fn to_local(&self, vector: V) -> V {
        self.turns.iter().rev().fold(vector, |v, &(axis, degrees)| turned(v, axis, -degrees))
    }

    fn to_world(&self, vector: V) -> V {
        self.turns.iter().fold(vector, |v, &(axis, degrees)| turned(v, axis, degrees))
    }

    /// The gradient by central differences: exact for functions of second degree, whatever the step.
    pub(crate) fn gradient(&self, p: V) -> V {
        let slope = |axis: V| ((self.function)(p + axis * self.size) - (self.function)(p - axis * self.size)) * 0.5;
        V(AXES.map(slope)) * (1.0 / self.size)
    }

    /// The place of its local origin.
    pub(crate) fn center(&self) -> V {
        self.center
    }

    /// The function at a point of the scene; not a number where the surface is cut away.
    pub(crate) fn value(&self, point: V) -> f64 {
        let local = self.to_local(point - self.center);
        let [bottom, top] = self.heights;
        if (bottom..=top).contains(&local.0[1]) { (self.function)(local) } else { f64::NAN }
    }

    /// The greatest second derivative along an axis.
    pub(crate) fn bend(&self) -> f64 {
        let bend = |axis: V| (self.function)(axis) + (self.function)(-axis) - 2.0 * (self.function)(V::ZERO);
        AXES.map(bend).map(f64::abs).into_iter().fold(0.0, f64::max)
    }

    /// How far from its place a ray may seem to be after rounding.
    fn blur(&self, line: &Line) -> f64 {
        ROUNDINGS * EPSILON * ((line.origin - self.center).length() + self.size)
    }

    /// A random point of the surface with its normal; every eighth within a thousandth of a rim.
    fn random_point(&self, random: &mut Stream) -> (V, V) {
        let [bottom, top] = self.heights.map(|y| y.clamp(-self.size, self.size));
        loop {
            let mut p = V::from(in_cube(random)) * self.size;
            let at_rim = one_of(random, 8) == 0;
            if at_rim {
                p.0[1] = [bottom, top][one_of(random, 2)] + 1e-3 * f64::from(between(random, -1.0, 1.0)) * self.size;
            }
            // Walk down the gradient to the surface; along the rim only sideways.
            for _ in 0..20 {
                let mut gradient = self.gradient(p);
                if at_rim {
                    gradient.0[1] = 0.0;
                }
                p = p - gradient * ((self.function)(p) / gradient.dot(gradient));
            }
            let is_there = p.length() < 1.1 * self.size && (at_rim || (bottom..=top).contains(&p.0[1]));
            if is_there && (self.function)(p).abs() < 1e-9 * self.bend() {
                return (self.center + self.to_world(p), self.to_world(self.gradient(p).unit()));
            }
        }
    }
}

impl Reference for Surface {
    fn crossings(&self, line: &Line) -> Vec<Crossing> {
        // Count the distance u from where the line passes the center, for f64 has roundings too.
        let shift = (self.center - line.origin).dot(line.direction);
        let (start, way) = (self.to_local(line.at(shift) - self.center), self.to_local(line.direction));
        let at = |u: f64| start + way * u;
        // Three values determine f = a·u² + 2h·u + c.
        let [before, c, after] = [-self.size, 0.0, self.size].map(|u| (self.function)(at(u)));
        let a = (before + after - 2.0 * c) / (2.0 * self.size * self.size);
        let h = (after - before) / (4.0 * self.size);
        let discriminant = h * h - a * c;
        // What rounding may add to f: the ray was blurred, and the terms of f were rounded.
        let (blur, rounding) = (self.blur(line), ROUNDINGS * EPSILON * self.bend() * self.size * self.size);
        let error = |u: f64| self.gradient(at(u)).length() * blur + rounding;
        let turning_point = -h / a;
        let slack = a.abs() * error(turning_point);
        let roots = if slack.is_finite() && discriminant < 4.0 * slack {
            // Two roots so near each other that rounding may join or part them.
            let radius = (discriminant.max(0.0) / (a * a)).sqrt();
            let tolerance = (slack / (a * a)).sqrt() * 2.0 + blur;
            let near = |u: f64| (discriminant > -slack).then_some((u, tolerance, false));
            [near(turning_point - radius), near(turning_point + radius)]
        } else {
            let q = -(h + discriminant.sqrt().copysign(h));
            [c / q, q / a].map(|u| u.is_finite().then(|| (u, error(u) / (2.0 * discriminant.sqrt()) + blur, true)))
        };
        let mut crossings = Vec::new();
        for (u, tolerance, certain) in roots.into_iter().flatten() {
            // Look whether the point lies between the heights, below or above them, or on a rim.
            let (y, margin) = (at(u).0[1], blur + tolerance * way.0[1].abs());
            let [bottom, top] = self.heights;
            if y > bottom - margin && y < top + margin {
                let inside = y > bottom + margin && y < top - margin;
                crossings.push(Crossing { distance: u + shift, tolerance, certain: certain && inside });
            }
        }
        crossings.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        crossings
    }

    fn check_hit(&self, line: &Line, hit: &Hit, crossing: &Crossing) -> Result<(), String> {
        let position = V::from(hit.position);
        let blur = self.blur(line) + ROUNDINGS * EPSILON * position.length();
        let away = (position - line.at(crossing.distance)).length();
        if away > crossing.tolerance + blur {
            return Err(format!("{hit:?} is {away} away from its place"));
        }
        // Near the tip of a cone the gradient vanishes, and with it its direction.
        let gradient = self.to_world(self.gradient(self.to_local(position - self.center)));
        let tolerance = self.bend() * blur / gradient.length();
        if !crossing.certain || tolerance > 0.1 {
            return Ok(());
        }
        check_normals(line, hit, gradient, tolerance)
    }
}

/// A vector turned about a unit axis: what lies along the axis stays, what lies across it goes round.
fn turned(v: V, axis: V, degrees: f64) -> V {
    let along = axis * v.dot(axis);
    let across = v - along;
    along + across * degrees.to_radians().cos() + axis.cross(across) * degrees.to_radians().sin()
}

/// Ask a shape about 900 random rays, from up to so many sizes away; tell the first wrong answer.
fn judge(
    shape: &dyn Shape,
    surface: &Surface,
    farthest: f32,
    random: &mut Stream,
    tally: &mut Tally,
) -> Result<(), String> {
    let target = Target {
        center: surface.center.to_f32(),
        size: surface.size as f32,
        farthest,
        surface: &|random| surface.random_point(random),
    };
    for i in 0..900 {
        let ray = target.ray(i, random);
        let range = target.range(&ray, random);
        surface.check(shape, &ray, range, tally)?;
    }
    Ok(())
}

/// A random sphere, and its equation.
fn random_sphere(random: &mut Stream) -> (Sphere, Surface) {
    let sphere = Sphere::new(in_cube(random) * magnitude(random, 0.01, 100.0), magnitude(random, 0.01, 100.0));
    (sphere, surface_of(&sphere))
}

/// The equation |p|² − R² = 0 of a sphere.
pub(crate) fn surface_of(sphere: &Sphere) -> Surface {
    let radius = f64::from(sphere.radius);
    let function = Box::new(move |p: V| p.dot(p) - radius * radius);
    let heights = [f64::NEG_INFINITY, f64::INFINITY];
    Surface { function, heights, size: radius, center: sphere.center.into(), turns: vec![] }
}

/// A random quadric of one of the six kinds in a random frame, and its equation from the gallery.
pub(crate) fn random_quadric(kind: usize, random: &mut Stream) -> (Quadric, Surface) {
    scaled_quadric(kind, 1.0, random)
}

/// The same, with all lengths multiplied by `scale`.
pub(crate) fn scaled_quadric(kind: usize, scale: f32, random: &mut Stream) -> (Quadric, Surface) {
    let mut number = || between(random, 0.3, 2.0) * scale;
    let (p, q, r) = (number(), number(), number());
    let [a, b, c] = [p, q, r].map(f64::from);
    let endless = [f64::NEG_INFINITY, f64::INFINITY];
    let (quadric, function, heights, size): (_, Box<dyn Fn(V) -> f64>, _, f64) = match kind {
        0 => (
            Quadric::ellipsoid(Vec3::new(p, q, r)),
            Box::new(move |V([x, y, z])| x * x / (a * a) + y * y / (b * b) + z * z / (c * c) - 1.0),
            endless,
            a.max(b).max(c),
        ),
        1 => (Quadric::cylinder(p, q), Box::new(move |V([x, _, z])| x * x + z * z - a * a), [0.0, b], a.hypot(b)),
        2 => (
            Quadric::cone(p, q),
            Box::new(move |V([x, y, z])| x * x + z * z - (a / b) * (a / b) * (b - y) * (b - y)),
            [0.0, b],
            a.hypot(b),
        ),
        3 => (
            Quadric::paraboloid(p, q),
            Box::new(move |V([x, y, z])| x * x + z * z - a * a * y / b),
            [0.0, b],
            a.hypot(b),
        ),
        4 => (
            Quadric::hyperboloid_of_one_sheet(p, q, r),
            Box::new(move |V([x, y, z])| (x * x + z * z) / (a * a) - y * y / (b * b) - 1.0),
            [-c, c],
            (a * (1.0 + c * c / (b * b)).sqrt()).hypot(c),
        ),
        _ => {
            // The sheets begin at the heights ±b, so they must end beyond.
            let (r, c) = (q + r, b + c);
            (
                Quadric::hyperboloid_of_two_sheets(p, q, r),
                Box::new(move |V([x, y, z])| (x * x + z * z) / (a * a) - y * y / (b * b) + 1.0),
                [-c, c],
                (a * (c * c / (b * b) - 1.0).sqrt()).hypot(c),
            )
        }
    };
    let center = in_cube(random) * 3.0 * scale;
    let mut frame = Frame::at(center);
    let mut turns = vec![];
    for _ in 0..one_of(random, 3) {
        let (axis, degrees) = (direction(random), between(random, -180.0, 180.0));
        frame = frame.turned(axis, degrees);
        turns.push((axis.into(), degrees.into()));
    }
    (quadric.placed(frame), Surface { function, heights, size, center: center.into(), turns })
}

#[test]
fn spheres_are_hit_where_their_equation_says() {
    let (mut random, mut tally) = (Stream::new(101, 0, 0), Tally::default());
    for _ in 0..200 {
        let (sphere, surface) = random_sphere(&mut random);
        judge(&sphere, &surface, 1e4, &mut random, &mut tally).unwrap();
    }
    tally.assert_fair(100_000, 0.3, 0.01);
}

#[test]
fn quadrics_are_hit_where_their_equations_say() {
    for kind in 0..6 {
        let (mut random, mut tally) = (Stream::new(102, kind as u64, 0), Tally::default());
        for _ in 0..40 {
            let (quadric, surface) = random_quadric(kind, &mut random);
            judge(&quadric, &surface, 1e3, &mut random, &mut tally).unwrap();
        }
        tally.assert_fair(30_000, 0.2, 0.04);
    }
}

/// A shape with a mistake.
struct Mistaken<S>(S, fn(&S, &Ray, Interval) -> Option<Hit>);

impl<S: Send + Sync> Shape for Mistaken<S> {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        self.1(&self.0, ray, range)
    }
}

/// The judge is strict: it finds each of these mistakes, in nearly every sphere.
#[test]
fn mistakes_in_spheres_are_found() {
    type Mistake = fn(&Sphere, &Ray, Interval) -> Option<Hit>;
    let mistakes: [(&str, Mistake); 7] = [
        ("the textbook's roots", |sphere, ray, range| TextbookSphere(*sphere).intersect(ray, range)),
        ("only the nearer root", |sphere, ray, range| {
            let t = sphere.roots(ray).0[0];
            range.contains(t).then(|| Hit::new(ray, t, ray.at(t) - sphere.center))
        }),
        ("only the farther root", |sphere, ray, range| {
            let t = sphere.roots(ray).0[1];
            range.contains(t).then(|| Hit::new(ray, t, ray.at(t) - sphere.center))
        }),
        ("no end of the range", |sphere, ray, range| sphere.intersect(ray, Interval::new(range.min, f32::INFINITY))),
        ("directions taken for unit vectors", |sphere, ray, range| {
            sphere.intersect(&Ray::new(ray.origin, ray.direction.normalize()), range)
        }),
        ("normals not turned", |sphere, ray, range| {
            let hit = sphere.intersect(ray, range)?;
            let normal = (hit.position - sphere.center).normalize();
            Some(Hit { geometric_normal: normal, shading_normal: normal, ..hit })
        }),
        ("the side decided after turning", |sphere, ray, range| {
            Some(Hit { side: Side::Outside, ..sphere.intersect(ray, range)? })
        }),
    ];
    for (what, mistake) in mistakes {
        let mut random = Stream::new(103, 0, 0);
        let found = (0..20).filter(|_| {
            let (sphere, surface) = random_sphere(&mut random);
            judge(&Mistaken(sphere, mistake), &surface, 1e4, &mut random, &mut Tally::default()).is_err()
        });
        assert!(found.count() > 18, "{what}");
    }
}

/// The same for quadrics, with mistakes of their own.
#[test]
fn mistakes_in_quadrics_are_found() {
    type Mistake = fn(&Quadric, &Ray, Interval) -> Option<Hit>;
    let mistakes: [(&str, Mistake); 2] = [
        ("the inside is never hit", |quadric, ray, range| {
            let hit = quadric.intersect(ray, range)?;
            (hit.side == Side::Outside).then_some(hit)
        }),
        ("a normal that is a little off", |quadric, ray, range| {
            let hit = quadric.intersect(ray, range)?;
            let normal = (hit.geometric_normal + Vec3::splat(1e-3)).normalize();
            Some(Hit { geometric_normal: normal, shading_normal: normal, ..hit })
        }),
    ];
    for (what, mistake) in mistakes {
        for kind in 0..6 {
            let mut random = Stream::new(104, kind as u64, 0);
            let (quadric, surface) = random_quadric(kind, &mut random);
            let verdict = judge(&Mistaken(quadric, mistake), &surface, 1e3, &mut random, &mut Tally::default());
            assert!(verdict.is_err(), "{what}, kind {kind}");
        }
    }
}
