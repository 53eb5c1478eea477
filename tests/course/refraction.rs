//! Mirrored and refracted directions against an independent table, there and back, and through a slab of glass.

#![expect(clippy::disallowed_methods, reason = "f64 has digits to spare: its last bits do not matter here")]

use common::{Interval, Rgb, Stream, Vec3, obj::ObjMesh};
use ray_casting::{
    mesh::{Mesh, Shading},
    ray::Ray,
    scene::Scene,
    shape::Shape,
};
use shadows::offset::{FOLLOWING, Offset};
use whitted::{
    branches::branches,
    material::{Fresnel, Material},
    reflection::reflect,
    refraction::refract,
};

use crate::{
    exact::{EPSILON, ROUNDINGS, V},
    icosphere::icosphere,
    optics::rows,
    rays::{aimed, between, direction, in_cube, magnitude, one_of},
};

#[test]
fn directions_are_what_the_table_says() {
    let mut total = 0;
    for row in rows("directions", 68) {
        let [ray, normal] = [0, 3].map(|i| row.vector(i).unwrap().to_f32());
        let (n, mirrored, refracted) = (row.numbers[6], row.vector(7).unwrap(), row.vector(10));
        let error = (V::from(reflect(ray, normal)) - mirrored).length();
        assert!(error < ROUNDINGS * EPSILON, "{ray} {normal}: {error}");
        match (refract(ray, normal, n as f32), refracted) {
            (Some(found), Some(expected)) => {
                // The cosine behind is a root of what rounding has blurred.
                let cosine = -expected.dot(normal.into());
                let error = (V::from(found) - expected).length();
                assert!(
                    error < ROUNDINGS * EPSILON * (1.0 + 1.0 / n + 1.0 / (n * n * cosine)),
                    "{ray} {normal} {n}: {error}"
                );
            }
            (None, None) => total += 1,
            (found, expected) => panic!("{ray} {normal} {n}: {found:?}, not {expected:?}"),
        }
    }
    assert_eq!(total, 20);
}

/// A random unit direction and a unit normal that faces it, and their cosine.
fn random_meeting(random: &mut Stream) -> (Vec3, Vec3, f32) {
    loop {
        let (ray, normal) = (direction(random), direction(random));
        let cosine = ray.dot(normal);
        if cosine < -0.02 {
            return (ray, normal, -cosine);
        }
    }
}

#[test]
fn mirroring_twice_is_nothing_and_keeps_the_angle() {
    let mut random = Stream::new(811, 0, 0);
    for _ in 0..100_000 {
        let (ray, normal, cosine) = random_meeting(&mut random);
        let mirrored = reflect(ray, normal);
        assert!((reflect(mirrored, normal) - ray).length() < 16.0 * f32::EPSILON);
        assert!((mirrored.dot(normal) - cosine).abs() < 8.0 * f32::EPSILON);
        assert!((mirrored.length() - 1.0).abs() < 8.0 * f32::EPSILON);
    }
}

/// Whatever the index: the direction behind obeys Snell's law, lies in the plane of ray and normal, and has unit length. And
/// turned round, it is bent back to where it came from.
#[test]
fn refraction_goes_there_and_back() {
    let mut random = Stream::new(812, 0, 0);
    let (mut total, mut through) = (0, 0);
    for _ in 0..100_000 {
        let (ray, normal, cosine) = random_meeting(&mut random);
        let n = magnitude(&mut random, 0.3, 3.0);
        let sine = V::from(ray).cross(normal.into()).length();
        let Some(behind) = refract(ray, normal, n) else {
            assert!(sine > (1.0 - 4.0 * EPSILON) * f64::from(n), "no direction at {cosine} in {n}");
            total += 1;
            continue;
        };
        through += 1;
        assert!(sine < (1.0 + 4.0 * EPSILON) * f64::from(n));
        // A rounding is divided by the cosine behind when the root is taken.
        let cosine_behind = -behind.dot(normal);
        let slack = 4.0 * EPSILON * (1.0 + 1.0 / f64::from(n)).powi(2) * (1.0 + 1.0 / f64::from(cosine_behind));
        let exact = V::from(behind);
        assert!((exact.length() - 1.0).abs() < slack, "{ray} {normal} {n}");
        assert!((exact.cross(normal.into()).length() * f64::from(n) - sine).abs() < slack * f64::from(n));
        assert!(exact.dot(V::from(ray).cross(normal.into())).abs() < slack);
        // There and back.
        if let Some(back) = refract(-behind, -normal, 1.0 / n) {
            let slack = slack * (1.0 + f64::from(n)) * (1.0 + 1.0 / f64::from(cosine));
            assert!((V::from(back) + V::from(ray)).length() < slack, "{ray} {normal} {n}: {back}");
        } else {
            assert!(cosine < 0.05, "no way back: {cosine} {n}");
        }
    }
    assert!(total > 10_000 && through > 50_000, "{total} {through}");
}

/// A block of glass with its faces at right angles to z, `wide` in x and y.
fn slab(center: Vec3, thick: f32, wide: f32) -> Mesh {
    let corner = |i: u8| {
        let sign = |bit: u8| if i >> bit & 1 == 1 { 0.5 } else { -0.5 };
        center + Vec3::new(sign(0) * wide, sign(1) * wide, sign(2) * thick)
    };
    let faces: [[u32; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    let obj = ObjMesh { positions: (0..8).map(corner).collect(), triangles, ..ObjMesh::default() };
    Mesh::new(&obj, Shading::Flat).unwrap()
}

/// A slab of thickness d shifts a ray by d sin θ (1 − cos θ / (n cos θ_t)) and does not turn it.
#[test]
fn a_slab_of_glass_shifts_a_ray_and_does_not_turn_it() {
    let mut random = Stream::new(813, 0, 0);
    for _ in 0..20_000 {
        let (n, thick) = (between(&mut random, 1.0, 2.5), between(&mut random, 0.1, 1.0));
        let center = in_cube(&mut random);
        let mut scene = Scene::new();
        scene.add("slab", slab(center, thick, 100.0), Material::glass(n));
        // From one side or the other, at up to 80° from the normal.
        let (sin, cos) = between(&mut random, 0.0, 80.0_f32.to_radians()).sin_cos();
        let (x, y) = between(&mut random, -3.0, 3.0).sin_cos();
        let way = Vec3::new(x * sin, y * sin, [cos, -cos][one_of(&mut random, 2)]);
        let start = Ray::new(center - way * between(&mut random, 3.0, 9.0), way.normalize());
        // Go through both faces, always with the refracted ray.
        let (mut ray, mut magnitude) = (start, 0.0_f32);
        for _ in 0..2 {
            let (hit, object) = scene.intersect(&ray, Interval::POSITIVE).unwrap();
            let [_, refracted] = branches(&ray, &hit, &object.material, Fresnel::Exact, Offset::Following);
            ray = refracted.unwrap().ray;
            magnitude = magnitude.max(hit.magnitude);
        }
        assert!(scene.intersect(&ray, Interval::POSITIVE).is_none());
        // The same by the closed form.
        let (direction, out) = (V::from(start.direction), V::from(ray.direction));
        let cosine = direction.0[2].abs();
        let sine = (1.0 - cosine * cosine).sqrt();
        let n = f64::from(n);
        let behind = (1.0 - sine * sine / (n * n)).sqrt();
        let expected = f64::from(thick) * sine * (1.0 - cosine / (n * behind));
        // How far beside the old line does the new one pass?
        let between = V::from(ray.origin) - V::from(start.origin);
        let shift = (between - direction * between.dot(direction)).length();
        let turn = (out - direction).length();
        assert!(turn < 2.0 * ROUNDINGS * EPSILON / cosine, "turned by {turn} at {cosine}");
        // Each of the two rays starts a little before its face.
        let offsets = 4.0 * f64::from(FOLLOWING * magnitude);
        assert!((shift - expected).abs() < offsets, "{shift}, not {expected}, at {cosine} in {n}; {offsets}");
    }
}

/// Smooth shading bends rays as the round surface would: directions come from the shading normal. But the rays start above and
/// below the triangle that is there.
#[test]
fn smooth_meshes_mirror_and_bend_by_their_shading_normals() {
    let mesh = Mesh::new(&icosphere(2), Shading::Smooth).unwrap();
    let mut random = Stream::new(815, 0, 0);
    let mut rays = 0;
    for _ in 0..20_000 {
        let ray = aimed(direction(&mut random) * 4.0, in_cube(&mut random) * 0.8);
        let Some(hit) = mesh.intersect(&ray, Interval::POSITIVE) else { continue };
        let material = Material::glass(1.5);
        let [Some(reflected), Some(refracted)] = branches(&ray, &hit, &material, Fresnel::Exact, Offset::Following)
        else {
            panic!("{hit:?}")
        };
        let (d, n, flat) = (V::from(ray.direction), V::from(hit.shading_normal), V::from(hit.geometric_normal));
        // The mirror direction, and Snell's law in sines: what lies across the normal is divided by the index.
        let (along, cosine) = (n * d.dot(n), -d.dot(n));
        let across = (d - along) * (1.0 / 1.5);
        let bent = across - n * (1.0 - across.dot(across)).sqrt();
        let slack = 8.0 * EPSILON;
        assert!((V::from(reflected.ray.direction) - (d - along * 2.0)).length() < slack, "{hit:?} {cosine}");
        assert!((V::from(refracted.ray.direction) - bent).length() < slack, "{hit:?} {cosine}");
        let height = |ray: &Ray| (V::from(ray.origin) - V::from(hit.position)).dot(flat);
        let offset = f64::from(FOLLOWING * hit.magnitude);
        assert!((height(&reflected.ray) - offset).abs() < offset / 4.0, "{hit:?}");
        assert!((height(&refracted.ray) + offset).abs() < offset / 4.0, "{hit:?}");
        // Where the two normals differ, to exchange them would be seen.
        rays += u32::from((n - flat).length() > 0.02);
    }
    assert!(rays > 5_000, "{rays}");
}

/// An index of one for every color is no border at all.
#[test]
fn equal_media_do_not_bend() {
    let mut random = Stream::new(814, 0, 0);
    for _ in 0..10_000 {
        let (ray, normal, cosine) = random_meeting(&mut random);
        let straight = refract(ray, normal, 1.0).unwrap();
        assert!((straight - ray).length() < 2.0 * f32::EPSILON * (1.0 + 1.0 / cosine));
    }
    assert_eq!(Material::glass(1.0).index, Rgb::ONE);
}
