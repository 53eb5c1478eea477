//! The numbers of chapter 2.

use common::{
    Interval, Stream, Vec2, Vec3,
    picture::{FilmPoint, Settings},
};
use ray_casting::{
    hit::{Hit, Side},
    ray::Ray,
    shape::Shape,
    sphere::Sphere,
};
use shadows::{offset::Offset, pictures::still_life};

use super::{Numbers, grouped, percent};
use crate::{
    offsets::self_hits,
    rays::{aimed, direction, in_cube},
    subjects::floor_mesh,
};

const RAYS: u32 = 100_000;

/// A shadow ray in a random direction on the side of the surface to which the normal points.
fn shadow_ray(hit: &Hit, offset: Offset, random: &mut Stream) -> Ray {
    let light = direction(random);
    let light = if light.dot(hit.geometric_normal) < 0.0 { -light } else { light };
    Ray::new(offset.origin(hit, hit.geometric_normal), light)
}

/// How many of [`RAYS`] shadow rays hit the shape that they leave. None should: the shapes are convex.
fn false_hits(shape: &dyn Shape, offset: Offset, mut camera_ray: impl FnMut(&mut Stream) -> Ray) -> u32 {
    let mut random = Stream::new(711, 0, 0);
    let [mut rays, mut hits] = [0; 2];
    while rays < RAYS {
        let ray = camera_ray(&mut random);
        // At the very outline a rounded normal may take the outside for the inside.
        let hit = shape.intersect(&ray, Interval::POSITIVE).filter(|hit| hit.side == Side::Outside);
        let Some(hit) = hit else { continue };
        rays += 1;
        hits += u32::from(shape.occluded(&shadow_ray(&hit, offset, &mut random), Interval::POSITIVE));
    }
    hits
}

/// The share of false hits on a unit sphere at (k, k, k), seen from 5 units away.
fn false_hits_of_sphere(k: f32, offset: Offset) -> String {
    let sphere = Sphere::new(Vec3::splat(k), 1.0);
    let hits = false_hits(&sphere, offset, |random| {
        aimed(sphere.center + direction(random) * 5.0, sphere.center + in_cube(random))
    });
    percent(hits, RAYS)
}

/// The share of false hits on a floor at height 0, 400 scenes wide, of a scene that is so large.
fn false_hits_of_floor(size: f32, offset: Offset) -> String {
    let floor = floor_mesh(0.0, 400.0 * size);
    let hits = false_hits(&floor, offset, |random| {
        let eye = direction(random) * 5.0 * size;
        aimed(eye.with_y(eye.y.abs()), in_cube(random).with_y(0.0) * size)
    });
    percent(hits, RAYS)
}

/// For all shadow rays of the cover: how many shapes are tested until the first one is hit, and how many there are.
fn tests_of_cover() -> [u32; 2] {
    let scene = still_life::scene().unwrap();
    let camera = still_life::view(&Settings::default()).unwrap();
    let [mut tested, mut all] = [0; 2];
    for i in 0..320_u16 * 180 {
        let position = Vec2::new(f32::from(i % 320) + 0.5, f32::from(i / 320) + 0.5);
        let ray = camera.ray(FilmPoint { position, size: Vec2::new(320.0, 180.0) });
        let Some((hit, _)) = scene.intersect(&ray, Interval::POSITIVE) else { continue };
        for light in &scene.lights {
            let light = light.illuminate(hit.position);
            let shadow_ray = Ray::new(Offset::Following.origin(&hit, hit.geometric_normal), light.direction);
            let range = Interval::POSITIVE.up_to(light.distance);
            let first = scene.objects.iter().position(|object| object.shape.occluded(&shadow_ray, range));
            let count = scene.objects.len();
            tested += first.map_or(count, |i| i + 1) as u32;
            all += count as u32;
        }
    }
    [tested, all]
}

pub(super) fn measured() -> String {
    let mut numbers = Numbers::titled("Numbers in the text of chapter 2, made by tests/course/numbers/shadows.rs.");

    numbers.about("Shadow rays that leave a unit sphere at (k, k, k), seen from 5 units away, in all directions: share that hits it");
    numbers.0.push_str("# again, with an offset of a thousandth of a unit.\n");
    for k in [1e3, 1e4, 2e4, 1e5] {
        numbers.pin(&format!("fixed-{k}"), false_hits_of_sphere(k, Offset::Fixed(1e-3)));
    }
    numbers.about(
        "The same at k = 10⁵ with an offset by the bits of the coordinates, and with one that follows the numbers.",
    );
    numbers.pin("bits-100000", false_hits_of_sphere(1e5, Offset::Bits));
    numbers.pin("following-100000", false_hits_of_sphere(1e5, Offset::Following));

    numbers.about("The same for a floor at height 0 in a scene of size 10⁴.");
    numbers.pin("bits-floor", false_hits_of_floor(1e4, Offset::Bits));
    numbers.pin("following-floor", false_hits_of_floor(1e4, Offset::Following));

    numbers.about("Shadow, reflected and refracted rays that leave all shapes at scales from 10⁻³ to 10⁵: how many there are, and how");
    numbers
        .0
        .push_str("# many of them falsely hit again what they have left, with the offset that follows the numbers.\n");
    let [rays, hits] = self_hits(Offset::Following);
    numbers.pin("self-hits-rays", grouped(rays));
    numbers.pin("self-hits-following", hits);

    numbers.about("Shape tests that are saved by stopping at the first hit, over all shadow rays of the cover.");
    let [tested, all] = tests_of_cover();
    numbers.pin("any-hit-tests", percent(all - tested, all));
    numbers.0
}
