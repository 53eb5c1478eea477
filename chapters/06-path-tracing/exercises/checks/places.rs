//! Places that look at lamps, for exercise 6.4.

use std::sync::Arc;

use common::{Rgb, Stream, Vec3};
use ray_casting::{hit::Hit, ray::Ray, scene::Scene, sphere::Sphere};

use super::{lamp::Lamp, place::Place, words::triple};

/// A hit at the origin that faces some direction.
fn hit(normal: Vec3) -> Hit {
    let normal = normal.normalize();
    Hit::new(&Ray::new(normal, -normal), 1.0, normal)
}

/// A place below a square lamp at height 1, with sides of twice `half`.
pub(super) fn below(half: f32) -> Place {
    let lamp = Lamp::around(Vec3::Y, [Vec3::X * half, Vec3::Z * half], Rgb::ONE);
    Place::new(hit(Vec3::Y), lamp, Arc::new(Scene::new()))
}

/// Small and large lamps, one that is partly below the horizon, and two that are partly behind a ball.
pub(super) fn places() -> [Place; 4] {
    let beside = Lamp::around(Vec3::new(1.0, 0.2, 0.0), [Vec3::Y, Vec3::new(0.3, 0.0, 1.0)], Rgb::ONE);
    let behind = |center: Vec3, radius: f32| {
        let mut ball = Scene::new();
        ball.add("ball", Sphere::new(center, radius), ());
        Arc::new(ball)
    };
    let tilted = Lamp::around(Vec3::new(0.0, 2.0, 0.3), [Vec3::new(1.0, 0.4, 0.0), Vec3::Z], Rgb::ONE);
    [
        below(0.3),
        below(5.0),
        Place::new(hit(Vec3::new(0.2, 1.0, 0.1)), beside, behind(Vec3::new(0.5, -0.2, 0.0), 0.2)),
        Place::new(hit(Vec3::Y), tilted, behind(Vec3::new(0.4, 0.8, 0.0), 0.35)),
    ]
}

/// A place in words.
pub(super) fn words(place: &Place) -> String {
    let (position, normal, lamp) = (triple(place.hit().position), triple(place.normal()), place.lamp());
    let [a, b] = lamp.edges.map(triple);
    format!("{position}, normal {normal}, a lamp with the corner {} and the edges {a} and {b}", triple(lamp.corner))
}

/// Random numbers of this exercise.
pub(super) fn stream(number: u64) -> Stream {
    Stream::new(641, number, 0)
}
