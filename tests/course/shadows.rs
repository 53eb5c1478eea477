//! Shadows: which lights a point sees, by f64 and by closed forms, and what it gets of them.

#![expect(clippy::disallowed_methods, reason = "f64 has digits to spare: its last bits do not matter here")]

use common::{Interval, Rgb, Stream, Vec3, story::Untold};
use ray_casting::{
    camera::Camera,
    hit::{Hit, Side},
    light::{Illumination, Light, PointLight},
    local_illumination::{LocalIllumination, Terms},
    material::Phong,
    mesh::{Mesh, Shading},
    ray::Ray,
    scene::{Object, Scene},
    shape::Shape,
    sphere::Sphere,
};
use shadows::{
    direct_light::{DirectLight, direct_light},
    offset::Offset,
    shadow_ray::is_in_shadow,
};

use crate::{
    exact::V,
    illumination::{Lamp, random_color},
    rays::{aimed, between, direction, in_cube, magnitude, one_of},
    subjects::{floor_mesh, subjects},
};

fn random_material(random: &mut Stream) -> Phong {
    Phong {
        ambient: random_color(random),
        diffuse: random_color(random),
        specular: random_color(random),
        shininess: magnitude(random, 1.0, 1000.0),
    }
}

/// Width of the floor below.
const FLOOR_WIDE: f64 = 400.0;

/// Balls over a floor.
struct Balls {
    balls: Vec<Sphere>,
    floor: f32,
}

/// What is between a point and a light.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Between {
    Nothing,
    Something,
    /// An outline is so near that f32 cannot know.
    Perhaps,
}

impl Balls {
    fn random(random: &mut Stream) -> Balls {
        let ball = |random: &mut Stream| Sphere::new(in_cube(random) * 3.0, between(random, 0.2, 1.2));
        Balls { balls: (0..5).map(|_| ball(random)).collect(), floor: -2.0 }
    }

    fn scene(&self, materials: &[Phong]) -> Scene<Phong> {
        let mut scene = Scene::new();
        for (ball, material) in self.balls.iter().zip(materials) {
            scene.add("ball", *ball, *material);
        }
        scene.add("floor", floor_mesh(self.floor, FLOOR_WIDE as f32), materials[self.balls.len()]);
        scene
    }

    /// What is between a point of the surfaces with this normal and a light in this direction and distance.
    fn between(&self, point: V, normal: V, toward: V, distance: f64) -> Between {
        const MARGIN: f64 = 1e-3;
        // Started a little above a ball, a ray sees a little beyond the horizon.
        const HORIZON: f64 = 0.03;
        // The surface of the point itself is in the way of what comes from behind it.
        let facing = toward.dot(normal);
        let mut verdict = if facing > MARGIN { Between::Nothing } else { Between::Perhaps };
        if facing < -HORIZON {
            return Between::Something;
        }
        for ball in &self.balls {
            let (to_center, radius) = (V::from(ball.center) - point, f64::from(ball.radius));
            // The point lies on this ball, which is convex.
            if (to_center.length() - radius).abs() < MARGIN / 10.0 {
                continue;
            }
            let nearest = to_center.dot(toward).clamp(0.0, distance);
            let aside = (to_center - toward * nearest).length();
            // A light inside a ball, or a point, is hidden just like one behind it.
            if aside < radius - MARGIN {
                return Between::Something;
            }
            if aside < radius + MARGIN {
                verdict = Between::Perhaps;
            }
        }
        let floor = f64::from(self.floor);
        let crossing = (point.0[1] - floor) / -toward.0[1];
        let V([x, _, z]) = point + toward * crossing;
        let is_above = point.0[1] > floor + MARGIN;
        if is_above && crossing > 0.0 && crossing < distance && x.abs().max(z.abs()) < FLOOR_WIDE / 2.0 {
            return Between::Something;
        }
        verdict
    }
}

fn any_camera() -> Camera {
    Camera::new(Vec3::Z, Vec3::ZERO, Vec3::Y, 40.0).unwrap()
}

/// For each point f64 says which lights it sees. Chapter 1's local illumination by these lights alone must then be the same,
/// to the last bit; and where no light is seen, that is the ambient term.
#[test]
fn a_point_gets_the_ambient_term_and_the_lights_that_it_sees() {
    let mut random = Stream::new(831, 0, 0);
    let [mut hits, mut unclear] = [0; 2];
    // Points that see so many of the three lights.
    let mut seeing = [0; 4];
    for _ in 0..1_500 {
        let balls = Balls::random(&mut random);
        let materials: Vec<_> = (0..6).map(|_| random_material(&mut random)).collect();
        let lamps: Vec<_> = (0..3).map(|_| Lamp::random(&mut random)).collect();
        let (ambient, background) = (random_color(&mut random), random_color(&mut random));
        let lit_by = |lamps: &[Lamp]| {
            let mut scene = balls.scene(&materials);
            scene.ambient = ambient;
            scene.surround(background);
            lamps.iter().for_each(|lamp| lamp.shine_on(&mut scene));
            scene
        };
        let chapter_2 = DirectLight { scene: lit_by(&lamps), camera: any_camera(), offset: Offset::Following };
        for _ in 0..20 {
            let ray = aimed(direction(&mut random) * 6.0 + Vec3::Y * 5.0, in_cube(&mut random) * 3.0);
            let found = chapter_2.trace(&ray, &mut Untold);
            let Some((hit, object)) = chapter_2.scene.intersect(&ray, Interval::POSITIVE) else {
                assert_eq!(found, background);
                continue;
            };
            // A camera inside a ball sees what the judge knows nothing of.
            if hit.side == Side::Inside {
                continue;
            }
            hits += 1;
            let (point, normal) = (V::from(hit.position), V::from(hit.geometric_normal));
            let between = |lamp: &Lamp| {
                let (toward, distance) = match *lamp {
                    Lamp::Sun { toward, .. } => (V::from(toward), 1e6),
                    Lamp::Point { position, .. } => (V::from(position) - point, (V::from(position) - point).length()),
                };
                balls.between(point, normal, toward.unit(), distance)
            };
            let verdicts: Vec<_> = lamps.iter().map(between).collect();
            if verdicts.contains(&Between::Perhaps) {
                unclear += 1;
                continue;
            }
            let seen = lamps.iter().zip(&verdicts).filter(|(_, verdict)| **verdict == Between::Nothing);
            let seen: Vec<_> = seen.map(|(lamp, _)| *lamp).collect();
            let chapter_1 = LocalIllumination { scene: lit_by(&seen), camera: any_camera(), terms: Terms::ALL };
            let bits = |color: Rgb| color.to_array().map(f32::to_bits);
            assert_eq!(bits(found), bits(chapter_1.trace(&ray, &mut Untold)), "{hit:?} {verdicts:?}");
            if seen.is_empty() {
                assert_eq!(bits(found), bits(object.material.ambient * ambient));
            }
            seeing[seen.len()] += 1;
        }
    }
    assert!(hits > 15_000 && unclear < hits / 15, "{hits} {unclear}");
    assert!(seeing.iter().all(|&n| n > 1_000), "{seeing:?}");
}

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
            let mut obj = crate::icosphere::icosphere(0);
            obj.positions.iter_mut().for_each(|p| *p = center + *p * size);
            Box::new(Mesh::new(&obj, Shading::Flat).unwrap())
        }
        _ => {
            let frame = ray_casting::frame::Frame::at(center);
            Box::new(ray_casting::quadric::Quadric::ellipsoid(Vec3::new(1.0, 0.8, 1.2) * size).placed(frame))
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

/// The shadow of a ball is the part of a cone: its tip in the lamp, its sides touching the ball.
#[test]
fn the_shadow_of_a_ball_is_a_section_of_a_cone() {
    let mut random = Stream::new(834, 0, 0);
    let [mut inside, mut outside, mut near] = [0; 3];
    for _ in 0..400 {
        let ball = Sphere::new(Vec3::Y * between(&mut random, 1.1, 3.0), between(&mut random, 0.3, 1.0));
        let lamp_at = in_cube(&mut random) * 3.0 + Vec3::Y * 9.0;
        let lamp = PointLight { position: lamp_at, intensity: Rgb::ONE };
        let mut scene = Scene::new();
        scene.add("floor", floor_mesh(0.0, 400.0), ());
        scene.add("ball", ball, ());
        let (tip, axis) = (V::from(lamp_at), V::from(ball.center) - V::from(lamp_at));
        // From the lamp to where the cone touches the ball.
        let touching = (axis.dot(axis) - f64::from(ball.radius).powi(2)).sqrt();
        // The middle of the shadow: where the axis meets the floor.
        let middle = (tip + axis * (-tip.0[1] / axis.0[1])).to_f32();
        for _ in 0..100 {
            let point = Vec3::new(middle.x, 0.0, middle.z) + in_cube(&mut random).with_y(0.0) * 2.0;
            let Some(hit): Option<Hit> =
                scene.objects[0].shape.intersect(&aimed(point + Vec3::Y, point), Interval::POSITIVE)
            else {
                panic!("{point}")
            };
            let from_lamp = V::from(hit.position) - tip;
            // The cosine of the angle at the tip, as a length: within the cone if it is greater than `touching`.
            let within = from_lamp.dot(axis) / from_lamp.length() - touching;
            if within.abs() < 1e-5 {
                near += 1;
                continue;
            }
            let found = is_in_shadow(&scene, &hit, &lamp.illuminate(hit.position), Offset::Following);
            assert_eq!(found, within > 0.0, "{ball:?} {lamp_at} {hit:?}: {within}");
            *if found { &mut inside } else { &mut outside } += 1;
        }
    }
    assert!(inside > 5_000 && outside > 5_000 && near < 20, "{inside} {outside} {near}");
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
