//! Occlusion: any hit is enough, only what lies between counts, and a shadow ray starts above its surface.

use common::{Interval, Rgb, Stream, Vec3, story::Untold};
use ray_casting::{
    frame::Frame,
    hit::Hit,
    light::{Illumination, Light, PointLight},
    mesh::{Mesh, Shading},
    quadric::Quadric,
    ray::Ray,
    scene::{Object, Scene},
    shape::Shape,
    sphere::Sphere,
};
use shadows::{direct_light::direct_light, offset::Offset, shadow_ray::is_in_shadow};

use crate::{
    icosphere::icosphere,
    illumination::random_color,
    rays::{aimed, between, direction, in_cube, magnitude, one_of},
    shadows::random_material,
    subjects::{floor_mesh, subjects},
};

/// Any hit will do: to ask whether there is one gives the same answer as to look for the nearest.
#[test]
fn there_is_any_hit_where_there_is_a_nearest() {
    let mut random = Stream::new(832, 0, 0);
    let mut scene = Scene::new();
    for subject in subjects(1.0, &mut random) {
        scene.objects.push(Object { name: subject.name, shape: subject.shape, material: () });
    }
    let mut ask = |shape: &dyn Fn(&Ray, Interval) -> [bool; 2], rays: u32| -> u32 {
        let mut hits = 0;
        for _ in 0..rays {
            let Ray { origin, direction } = aimed(in_cube(&mut random) * 8.0, in_cube(&mut random) * 4.0);
            let ray = Ray::new(origin, direction * magnitude(&mut random, 0.1, 10.0));
            let min = [0.0, random.uniform() * 4.0][one_of(&mut random, 2)];
            let range =
                Interval::new(min, min + [f32::INFINITY, magnitude(&mut random, 0.1, 10.0)][one_of(&mut random, 2)]);
            let [any, nearest] = shape(&ray, range);
            assert_eq!(any, nearest, "{ray:?} {range:?}");
            hits += u32::from(any);
        }
        hits
    };
    let (mut hits, mut rays) = (0, 0);
    for Object { shape, .. } in &scene.objects {
        hits += ask(&|ray, range| [shape.occluded(ray, range), shape.intersect(ray, range).is_some()], 2_000);
        rays += 2_000;
    }
    assert!(hits > rays / 20, "{hits}");
    // All of them together, few at a time so that not every ray is stopped.
    while scene.objects.len() > 4 {
        let rest = scene.objects.split_off(4);
        let hits = ask(&|ray, range| [scene.occluded(ray, range), scene.intersect(ray, range).is_some()], 2_000);
        assert!(hits > 20 && hits < 1_900, "{hits}");
        rays += 2_000;
        scene.objects = rest;
    }
    assert!(rays >= 90_000, "{rays}");
}

/// Some shape of this size at this place.
fn any_shape(center: Vec3, size: f32, random: &mut Stream) -> Box<dyn Shape> {
    match one_of(random, 3) {
        0 => Box::new(Sphere::new(center, size)),
        1 => {
            let mut obj = icosphere(0);
            obj.positions.iter_mut().for_each(|p| *p = center + *p * size);
            Box::new(Mesh::new(&obj, Shading::Flat).unwrap())
        }
        _ => {
            let frame = Frame::at(center);
            Box::new(Quadric::ellipsoid(Vec3::new(1.0, 0.8, 1.2) * size).placed(frame))
        }
    }
}

/// A lamp between two things: what stands behind the lamp casts no shadow, nor does what stands behind the point.
#[test]
fn what_is_behind_the_lamp_or_behind_the_point_casts_no_shadow() {
    let mut random = Stream::new(833, 0, 0);
    for i in 0..20_000 {
        let scale = magnitude(&mut random, 1e-2, 1e3);
        let toward = direction(&mut random);
        // A ball, and the lamp above some point of it that is turned to the lamp.
        let ball = Sphere::new(in_cube(&mut random) * scale, between(&mut random, 0.3, 1.0) * scale);
        let normal = (toward + direction(&mut random) * 0.9).normalize();
        let point = ball.center + normal * ball.radius;
        let distance = between(&mut random, 0.5, 4.0) * scale;
        let lamp = PointLight { position: point + toward * distance, intensity: Rgb::ONE };
        let mut scene = Scene::new();
        scene.add("ball", ball, ());
        // Just behind the lamp, and behind the ball: things that the line through point and lamp meets.
        let size = between(&mut random, 0.1, 2.0) * scale;
        let behind_lamp = lamp.position + toward * (size * between(&mut random, 1.3, 3.0));
        let behind_point = ball.center - toward * (2.3 * ball.radius + 1.3 * size);
        for center in [behind_lamp, behind_point] {
            let shape = any_shape(center, size, &mut random);
            scene.objects.push(Object { name: "bystander", shape, material: () });
        }
        let Some(hit) = ball.intersect(&aimed(point + normal * scale, point), Interval::POSITIVE) else {
            panic!("{i}")
        };
        let light = lamp.illuminate(hit.position);
        for offset in [Offset::Following, Offset::Bits, Offset::Fixed(1e-4 * scale)] {
            assert!(!is_in_shadow(&scene, &hit, &light, offset), "{i}: {scale} {offset:?} {hit:?} {light:?}");
            // Both would be hit by those who forget where the lamp is, or which way it is.
            let beyond = Illumination { distance: f32::INFINITY, ..light };
            assert!(is_in_shadow(&scene, &hit, &beyond, offset), "{i}: nothing behind the lamp");
            let backward = Illumination { direction: -light.direction, ..beyond };
            assert!(is_in_shadow(&scene, &hit, &backward, offset), "{i}: nothing behind the point");
        }
        // And a thing before the lamp does cast one: then the ambient term is all there is.
        let mut hidden = Scene::new();
        hidden.ambient = random_color(&mut random);
        hidden.light(lamp);
        hidden.objects.append(&mut scene.objects);
        let before = hit.position.lerp(lamp.position, between(&mut random, 0.3, 0.7));
        hidden.add("in the way", Sphere::new(before, 0.1 * distance), ());
        let material = random_material(&mut random);
        let radiance = direct_light(&hidden, &material, &hit, normal, Offset::Following, &mut Untold);
        assert_eq!(
            radiance.to_array().map(f32::to_bits),
            (material.ambient * hidden.ambient).to_array().map(f32::to_bits)
        );
    }
}

/// A shadow ray leaves the surface that is there, along its geometric normal, wherever the shading normal points to.
#[test]
fn shadow_rays_start_above_the_surface_itself() {
    let mut random = Stream::new(835, 0, 0);
    let mut scene = Scene::new();
    scene.add("floor", floor_mesh(0.0, 400.0), ());
    for _ in 0..10_000 {
        // A point of the floor, as rounding may leave it: a little below. Its shading normal is as askew as can be.
        let point = in_cube(&mut random).with_y(between(&mut random, -200.0, 0.0) * f32::EPSILON);
        let mut hit =
            scene.objects[0].shape.intersect(&aimed(point + Vec3::Y * 4.0, point), Interval::POSITIVE).unwrap();
        hit = Hit { position: point, ..hit };
        hit.shading_normal = (direction(&mut random).with_y(0.0) + Vec3::Y * 1e-4).normalize();
        let light = direction(&mut random);
        let light =
            Illumination { direction: light.with_y(light.y.abs()), distance: f32::INFINITY, strength: Rgb::ONE };
        assert!(!is_in_shadow(&scene, &hit, &light, Offset::Following), "{hit:?} {light:?}");
    }
}
