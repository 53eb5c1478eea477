//! Shadows: which lights a point sees, by f64 and by closed forms, and what it gets of them.

#![expect(clippy::disallowed_methods, reason = "f64 has digits to spare: its last bits do not matter here")]

use common::{Interval, Rgb, Stream, Vec3, story::Untold};
use ray_casting::{
    camera::Camera,
    hit::{Hit, Side},
    light::{Light, PointLight},
    local_illumination::{LocalIllumination, Terms},
    material::Phong,
    scene::Scene,
    sphere::Sphere,
};
use shadows::{direct_light::DirectLight, offset::Offset, shadow_ray::is_in_shadow};

use crate::{
    exact::V,
    illumination::{Lamp, random_color},
    rays::{aimed, between, direction, in_cube, magnitude},
    subjects::floor_mesh,
};

/// A rough material of any kind.
pub(crate) fn random_material(random: &mut Stream) -> Phong {
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

/// Nobody looks through it.
pub(crate) fn any_camera() -> Camera {
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
