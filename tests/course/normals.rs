//! Normals: along the gradient, turned toward the ray, and interpolated without harm.

use common::{Interval, Stream, Vec3, float::atan2, obj::ObjMesh};
use ray_casting::{
    hit::Side,
    implicit::{Gyroid, Heart, Implicit, ImplicitSurface, Tanglecube},
    mesh::{Mesh, Shading},
    quadric::Quadric,
    ray::Ray,
    shape::Shape,
    sphere::Sphere,
};

use crate::{
    exact::{EPSILON, ROUNDINGS, V},
    icosphere::icosphere,
    implicit::{GYROID, HEART, TANGLECUBE, Zeros},
    meshes::asset,
    rays::{aimed, direction, in_cube, magnitude},
    shapes::random_quadric,
};

#[test]
fn implicit_functions_have_the_value_and_gradient_that_they_should() {
    let functions: [(&dyn Implicit, &Zeros); 3] =
        [(&Tanglecube, &TANGLECUBE), (&Heart, &HEART), (&Gyroid { frequency: 5.0 }, &GYROID)];
    let mut random = Stream::new(401, 0, 0);
    for (function, zeros) in functions {
        for _ in 0..20_000 {
            let p = in_cube(&mut random) * zeros.radius as f32;
            let exact = V::from(p);
            let gradient = zeros.gradient(exact);
            let rounding = ROUNDINGS * EPSILON * ((zeros.terms)(exact) + gradient.length() * zeros.radius);
            assert!((f64::from(function.value(p)) - (zeros.function)(exact)).abs() < rounding, "{p}");
            let rounding = ROUNDINGS * EPSILON * ((zeros.terms)(exact) + zeros.bend(exact) * zeros.radius);
            assert!((V::from(function.gradient(p)) - gradient).length() < rounding, "{p}");
        }
    }
}

#[test]
fn quadrics_have_the_value_and_gradient_of_their_equations() {
    let mut random = Stream::new(402, 0, 0);
    for i in 0..60 {
        let (quadric, surface) = random_quadric(i % 6, &mut random);
        let rounding = ROUNDINGS * EPSILON * surface.bend() * surface.size;
        for _ in 0..1_000 {
            let p = in_cube(&mut random) * surface.size as f32;
            let value = (surface.function)(p.into());
            assert!((f64::from(quadric.value(p)) - value).abs() < rounding * surface.size, "{p}");
            let gradient = surface.gradient(p.into());
            assert!((V::from(quadric.gradient(p)) - gradient).length() < rounding, "{p}");
        }
    }
}

/// The greatest error of a sphere's normal, (r − c) / R, over many hits of unit spheres near the origin, in degrees.
pub(crate) fn error_of_sphere_normals() -> f64 {
    let mut random = Stream::new(403, 0, 0);
    let errors = (0..100_000).filter_map(|_| {
        let sphere = Sphere::new(in_cube(&mut random), 1.0);
        let ray = aimed(sphere.center + direction(&mut random) * 4.0, sphere.center + in_cube(&mut random));
        let hit = sphere.intersect(&ray, Interval::POSITIVE)?;
        let outward = V::from(hit.position) - V::from(sphere.center);
        // The angle is the sine, which is the length of the cross product, as long as it is small.
        Some(V::from(hit.geometric_normal).cross(outward.unit()).length().to_degrees())
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn the_normal_of_a_sphere_points_away_from_its_center() {
    // One rounding of the position and one of the direction, in units in the last place.
    let error = error_of_sphere_normals();
    assert!(error < (2.0 * EPSILON).to_degrees(), "{error}°");
}

/// A triangle in the plane z = 0 with other normals in its corners than its own, none of unit length.
fn leaning_triangle() -> ObjMesh {
    ObjMesh {
        positions: vec![Vec3::ZERO, Vec3::X * 4.0, Vec3::Y * 4.0],
        normals: vec![Vec3::new(0.0, 0.0, 3.0), Vec3::new(2.0, 0.0, 2.0), Vec3::new(0.0, 0.3, 0.4)],
        triangles: vec![[0, 1, 2]],
        triangle_normals: vec![[0, 1, 2]],
    }
}

#[test]
fn shading_normals_are_exact_in_the_corners_and_linear_between() {
    let obj = leaning_triangle();
    let mesh = Mesh::new(&obj, Shading::Smooth).unwrap();
    let units = [0, 1, 2].map(|i| V::from(obj.normals[i]).unit());
    let mut random = Stream::new(404, 0, 0);
    for i in 0..10_000 {
        // A corner, a point on an edge, or one inside.
        let (u, v) = (random.uniform(), random.uniform());
        let [_, beta, gamma] = match i % 8 {
            0 => [1.0, 0.0, 0.0],
            1 => [0.0, 1.0, 0.0],
            2 => [0.0, 0.0, 1.0],
            3 => [u, 1.0 - u, 0.0],
            _ => [1.0 - u.max(v), u.min(v), u.max(v) - u.min(v)],
        };
        // From above, or from below.
        let side = if i % 3 == 0 { Side::Inside } else { Side::Outside };
        let up = if side == Side::Inside { -Vec3::Z } else { Vec3::Z };
        let ray = Ray::new(Vec3::new(4.0 * beta, 4.0 * gamma, 0.0) + up * 7.0, -up);
        let hit = mesh.intersect(&ray, Interval::POSITIVE).unwrap();
        let (beta, gamma) = (f64::from(beta), f64::from(gamma));
        let expected = (units[0] * (1.0 - beta - gamma) + units[1] * beta + units[2] * gamma).unit();
        let expected = if side == Side::Inside { -expected } else { expected };
        let error = (V::from(hit.shading_normal) - expected).length();
        assert!(error < ROUNDINGS * EPSILON, "{ray:?} {hit:?}, not {expected:?}");
        assert_eq!((hit.geometric_normal, hit.side), (up, side));
    }
}

#[test]
fn large_triangles_count_more_in_the_normals_of_their_corners() {
    // Two triangles at right angles with a common edge along x; the second is three times as large.
    let obj = ObjMesh {
        positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y, -3.0 * Vec3::Z],
        triangles: vec![[0, 1, 2], [1, 0, 3]],
        ..ObjMesh::default()
    };
    let mesh = Mesh::new(&obj, Shading::Smooth).unwrap();
    let hit = mesh.intersect(&Ray::new(Vec3::Z, -Vec3::Z), Interval::POSITIVE).unwrap();
    assert_eq!(hit.geometric_normal, Vec3::Z);
    assert!((hit.shading_normal - Vec3::new(0.0, -3.0, 1.0).normalize()).length() < 1e-6, "{hit:?}");
}

/// The greatest angle in degrees between the normals of an icosphere and the radius: flat, and smooth.
pub(crate) fn error_of_icosphere_normals(levels: u32) -> [f64; 2] {
    let obj = icosphere(levels);
    [Shading::Flat, Shading::Smooth].map(|shading| {
        let mesh = Mesh::new(&obj, shading).unwrap();
        let mut random = Stream::new(405, 0, 0);
        let errors = (0..10_000).map(|_| {
            let radius = direction(&mut random);
            let hit = mesh.intersect(&Ray::new(radius * 2.0, -radius), Interval::POSITIVE).unwrap();
            V::from(hit.shading_normal).cross(V::from(radius)).length()
        });
        let sine = errors.fold(0.0, f64::max);
        f64::from(atan2(sine as f32, (1.0 - sine * sine).sqrt() as f32).to_degrees())
    })
}

#[test]
fn smooth_normals_make_an_icosphere_look_round() {
    let [flat, smooth] = error_of_icosphere_normals(2);
    assert!(flat > 8.0 && smooth < 2.0, "{flat}° {smooth}°");
}

#[test]
fn smooth_shading_changes_nothing_but_the_shading_normal() {
    let obj = asset("pawn.obj");
    let [flat, smooth] = [Shading::Flat, Shading::Smooth].map(|shading| Mesh::new(&obj, shading).unwrap());
    let mut random = Stream::new(406, 0, 0);
    let mut shaded = 0;
    for _ in 0..10_000 {
        let ray = aimed(Vec3::Y + in_cube(&mut random) * 3.0, Vec3::Y + in_cube(&mut random) * 0.7);
        let [flat, smooth] = [&flat, &smooth].map(|mesh| mesh.intersect(&ray, Interval::POSITIVE));
        let (Some(flat), Some(smooth)) = (flat, smooth) else {
            assert_eq!(flat, smooth);
            continue;
        };
        assert_eq!((flat.t, flat.position, flat.side), (smooth.t, smooth.position, smooth.side));
        assert_eq!((flat.geometric_normal, flat.shading_normal), (smooth.geometric_normal, flat.geometric_normal));
        // Both normals are on the same side of the surface, whatever the ray meets.
        assert!(smooth.shading_normal.dot(smooth.geometric_normal) > 0.0, "{ray:?} {smooth:?}");
        assert!((smooth.shading_normal.length() - 1.0).abs() < 1e-6);
        shaded += u32::from(smooth.shading_normal != smooth.geometric_normal);
    }
    assert!(shaded > 2_000, "{shaded}");
}

#[test]
fn the_side_is_known_although_the_normal_is_turned() {
    let ball = icosphere(2);
    let bound = Sphere::new(Vec3::ZERO, 3.4);
    let shapes: [&dyn Shape; 5] = [
        &Sphere::new(Vec3::ZERO, 1.0),
        &Quadric::ellipsoid(Vec3::new(0.9, 1.0, 1.1)),
        &Mesh::new(&ball, Shading::Flat).unwrap(),
        &Mesh::new(&ball, Shading::Smooth).unwrap(),
        &ImplicitSurface { function: Ball, bound, step: 0.1 },
    ];
    let mut random = Stream::new(407, 0, 0);
    for shape in shapes {
        for _ in 0..1_000 {
            let speed = magnitude(&mut random, 1e-2, 1e2);
            let from_inside = Ray::new(in_cube(&mut random) * 0.4, direction(&mut random) * speed);
            let from_outside = Ray::new(from_inside.at(-3.0 / speed), from_inside.direction);
            for (ray, side) in [(from_inside, Side::Inside), (from_outside, Side::Outside)] {
                let hit = shape.intersect(&ray, Interval::POSITIVE).unwrap();
                assert_eq!(hit.side, side, "{ray:?}");
                assert!(hit.geometric_normal.dot(ray.direction) < 0.0, "{ray:?} {hit:?}");
                assert!(hit.shading_normal.dot(hit.geometric_normal) > 0.9, "{ray:?} {hit:?}");
            }
        }
    }
}

/// |p|² − 1.
struct Ball;

impl Implicit for Ball {
    fn value(&self, p: Vec3) -> f32 {
        p.length_squared() - 1.0
    }

    fn gradient(&self, p: Vec3) -> Vec3 {
        2.0 * p
    }
}
