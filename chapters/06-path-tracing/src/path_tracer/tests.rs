use common::story::{Told, Untold};
use ray_casting::{
    light::PointLight,
    pictures::stage::{square, whole},
    scene::Scene,
    sphere::Sphere,
};
use sampling::sky_light::Choice;

use super::*;
use crate::{probe::RayCounts, random_walk::random_walk};

/// A red and a gold ball on a gray floor under a bright sky, with a lamp.
fn tracer(method: Method) -> PathTracer {
    let mut scene = Scene::new();
    scene.surround(Rgb::new(0.4, 0.6, 1.0));
    scene.light(PointLight { position: Vec3::new(0.0, 3.0, 0.0), intensity: Rgb::splat(5.0) });
    scene
        .add("floor", square(0.0, 3.0).unwrap(), Material::matte(Rgb::splat(0.6)))
        .add("red", Sphere::new(Vec3::new(-0.6, 0.5, 0.0), 0.5), Material::matte(Rgb::new(0.8, 0.1, 0.1)))
        .add("gold", Sphere::new(Vec3::new(0.6, 0.5, 0.0), 0.5), Material::GOLD)
        .add("lantern", Sphere::new(Vec3::new(0.0, 0.2, 1.2), 0.2), Material::glowing(Rgb::splat(4.0)));
    let bounds = square(0.0, 1.0).unwrap().bounds();
    let camera = whole(bounds, &common::knob::Values::default()).unwrap();
    PathTracer { world: World::new(scene).into(), camera, method }
}

/// Rays from the camera to all over the picture.
fn rays(tracer: &PathTracer) -> impl Iterator<Item = Ray> {
    let size = common::Vec2::splat(16.0);
    let at = move |x: u8, y: u8| FilmPoint { position: common::Vec2::new(x.into(), y.into()) + 0.5, size };
    (0..256_u16).map(move |i| tracer.camera.ray(at((i % 16) as u8, (i / 16) as u8)))
}

/// The path tracer without anything that makes it better is the plain random walk, to the last bit.
#[test]
fn the_plain_method_is_the_random_walk() {
    for bounces in [0, 1, 2, 7] {
        let tracer = tracer(Method { bounces: 0..=bounces, ..Method::PLAIN });
        for (i, ray) in rays(&tracer).enumerate() {
            let stream = || Stream::new(1, i as u64, 0);
            let walked = random_walk(&tracer.world, ray, bounces, &mut stream());
            // The walk goes on from mirrors and lamps with a throughput of 0; the tracer ends there.
            assert_eq!(tracer.trace(ray, &mut stream(), &mut Untold), walked);
        }
    }
}

/// The light of 0, 1, 2 … bounces adds up to all of it, path by path.
#[test]
fn bounces_add_up() {
    for best in [Method::BEST, Method { choice: Choice::Uniform, ..Method::BEST }] {
        let tracers: Vec<_> = (0..4).map(|k| tracer(Method { bounces: k..=k, ..best.clone() })).collect();
        let all = tracer(Method { bounces: 0..=3, ..best });
        for (i, ray) in rays(&all).enumerate() {
            let light = |tracer: &PathTracer| tracer.trace(ray, &mut Stream::new(2, i as u64, 0), &mut Untold);
            let sum: Rgb = tracers.iter().map(light).sum();
            assert!((sum - light(&all)).length() < 1e-4 * sum.length().max(1.0), "{sum} {}", light(&all));
        }
    }
}

/// One bounce of direct light, and the sky, is what chapter 2 shows.
#[test]
fn one_bounce_is_the_direct_light_of_chapter_2() {
    let tracer = tracer(Method { bounces: 1..=1, ..Method::BEST });
    let mut scene: Scene<()> = Scene::new();
    scene.light(PointLight { position: Vec3::new(0.0, 3.0, 0.0), intensity: Rgb::splat(5.0) });
    scene.add("red", Sphere::new(Vec3::new(-0.6, 0.5, 0.0), 0.5), ());
    let ray = Ray::new(Vec3::new(-0.6, 3.0, 0.3), -Vec3::Y);
    let (hit, object) = tracer.world.intersect(&ray).unwrap();
    let phong = ray_casting::material::Phong {
        diffuse: object.material.diffuse,
        ..ray_casting::material::Phong::of(Rgb::ZERO, 0.0, 1.0)
    };
    let expected = shadows::direct_light::direct_light(&scene, &phong, &hit, Vec3::Y, Offset::Following, &mut Untold);
    let shown = direct_light(&tracer.world, object.material, &hit, &mut Untold);
    assert!((shown - expected).length() < 1e-6 && shown.x > 0.1, "{shown} {expected}");
}

#[test]
fn the_story_tells_hits_choices_densities_and_weights() {
    let tracer = tracer(Method::BEST);
    let ray = Ray::new(Vec3::new(-0.6, 3.0, 0.3), -Vec3::Y);
    // A path that does not end at once.
    let tell = |sample| {
        let mut told = Told::default();
        let color = tracer.trace(ray, &mut Stream::new(3, 0, sample), &mut Listener(&mut told));
        (sample, color, told.to_string())
    };
    let (sample, color, story) = (0..100).map(tell).find(|(.., story)| story.contains("chosen: diffuse")).unwrap();
    for word in ["hits 'red'", "light 1", "chances", "chosen", "density p", "weight", "throughput"] {
        assert!(story.contains(word), "'{word}' is missing: {story}");
    }
    assert_eq!(color, tracer.trace(ray, &mut Stream::new(3, 0, sample), &mut Untold));
}

#[test]
fn rays_are_counted() {
    let tracer = tracer(Method { bounces: 0..=1, ..Method::BEST });
    let mut counts = RayCounts::default();
    let ray = Ray::new(Vec3::new(-2.0, 3.0, 0.3), -Vec3::Y);
    tracer.trace(ray, &mut Stream::new(4, 0, 0), &mut counts);
    assert_eq!(counts.shadow_rays, 1);
    assert!((1..=2).contains(&counts.path_rays));
}
