//! Agreement with scenes that an independent program rendered.
//!
//! The figures are of Mitsuba 3.9.1, 64×64 pixels, with a noise of ±0.02 % in the mean and at most 0.6 % in a block of 8×8
//! pixels. The scenes are described where they are built. A mean that is off by more than 1 % is a bias, not noise.

use std::sync::Arc;

use common::{
    Rgb, Vec3,
    film::{Film, Size},
    obj::ObjMesh,
    renderer::{Plan, render},
};
use ray_casting::{
    camera::Camera, frame::Frame, light::PointLight, material::Phong, mesh::Shading, scene::Scene, sphere::Sphere,
};
use space_partitioning::{choice::Choice, scenes::builder::Builder};
use whitted::material::Fresnel;

use crate::{
    material::Material,
    path_tracer::{Method, PathTracer},
    world::World,
};

/// Scene B3 is a box of 2×2×2, open in front, with a red wall on the left, a green one on the right, two boxes in it, and a
/// point light of intensity 2 below the ceiling. Scene C3 has a gold ball in place of the boxes.
fn tracer(with_boxes: bool, fresnel: Fresnel) -> PathTracer {
    let white = Phong::of(Rgb::splat(0.75), 0.0, 1.0);
    let corner = |x: f32, y: f32, z: f32| Vec3::new(x, y, z);
    let mut builder = Builder::default();
    builder.part("white", white);
    builder.quad([corner(-1.0, 0.0, -1.0), corner(-1.0, 0.0, 1.0), corner(1.0, 0.0, 1.0), corner(1.0, 0.0, -1.0)]);
    builder.quad([corner(-1.0, 0.0, -1.0), corner(1.0, 0.0, -1.0), corner(1.0, 2.0, -1.0), corner(-1.0, 2.0, -1.0)]);
    builder.quad([corner(-1.0, 2.0, -1.0), corner(1.0, 2.0, -1.0), corner(1.0, 2.0, 1.0), corner(-1.0, 2.0, 1.0)]);
    if with_boxes {
        boxes(&mut builder);
    }
    builder.part("red", Phong::of(Rgb::new(0.63, 0.065, 0.05), 0.0, 1.0));
    builder.quad([corner(-1.0, 0.0, -1.0), corner(-1.0, 2.0, -1.0), corner(-1.0, 2.0, 1.0), corner(-1.0, 0.0, 1.0)]);
    builder.part("green", Phong::of(Rgb::new(0.14, 0.45, 0.091), 0.0, 1.0));
    builder.quad([corner(1.0, 0.0, -1.0), corner(1.0, 0.0, 1.0), corner(1.0, 2.0, 1.0), corner(1.0, 2.0, -1.0)]);
    let mut scene = Scene::new();
    scene.light(PointLight { position: corner(0.0, 1.75, 0.0), intensity: Rgb::splat(2.0) });
    if !with_boxes {
        scene.add("gold", Sphere::new(corner(0.0, 0.5, 0.0), 0.5), Material::GOLD);
    }
    let mesh: &ObjMesh = &builder.mesh;
    let world = World::new(scene)
        .with_parts((mesh, Shading::Flat), &builder.parts, Choice::KdTree, |_, phong| phong.into())
        .unwrap();
    let camera = Camera::new(corner(0.0, 1.0, 4.0), corner(0.0, 1.0, 0.0), Vec3::Y, 38.0).unwrap();
    PathTracer { world: Arc::new(world), camera, method: Method { fresnel, ..Method::BEST } }
}

/// Two boxes by the four corners of their upper sides.
fn boxes(builder: &mut Builder) {
    let tall = [[-0.702, -0.484], [-0.534, 0.092], [0.042, -0.076], [-0.126, -0.652]];
    let short = [[0.126, -0.012], [-0.042, 0.564], [0.534, 0.732], [0.702, 0.156]];
    for (corners, height) in [(tall, 1.2), (short, 0.6)] {
        let [top, bottom] = [height, 0.0].map(|y| corners.map(|[x, z]: [f32; 2]| Vec3::new(x, y, z)));
        builder.quad(top);
        for i in 0..4 {
            let j = (i + 1) % 4;
            builder.quad([bottom[i], top[i], top[j], bottom[j]]);
        }
    }
}

/// The figures of a file: a line for each block.
fn figures(text: &str) -> Vec<Rgb> {
    let number = |word: &str| word.parse::<f32>().unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| Rgb::from_slice(&line.split(' ').map(number).collect::<Vec<_>>())).collect()
}

/// The means of the blocks of 8×8 pixels.
fn blocks(tracer: &PathTracer, samples: u32) -> Vec<Rgb> {
    let mut film = Film::new(Size::of::<64, 64>());
    render(tracer, &mut film, &Plan { samples, seed: 68, threads: 0 }, &());
    assert_eq!(film.bad_samples(), 0);
    let pixel = |i: u32, j: u32| film.pixel(i, j).unwrap().mean();
    let block = |i: u32| {
        let (x, y) = (i % 8 * 8, i / 8 * 8);
        (0..64).map(|k| pixel(x + k % 8, y + k / 8)).sum::<Rgb>() / 64.0
    };
    (0..64).map(block).collect()
}

/// Compare means within 0.5 %, blocks with a median within 1 % and none beyond 5 %.
fn compare(name: &str, tracer: &PathTracer, reference: &str) {
    let samples = if super::long_run() { 4096 } else { 384 };
    let (ours, theirs) = (blocks(tracer, samples), figures(reference));
    assert_eq!(theirs.len(), 64);
    let mean = |blocks: &[Rgb]| blocks.iter().sum::<Rgb>() / 64.0;
    let off = (mean(&ours) / mean(&theirs) - 1.0).abs();
    let relative = |(a, b): (&Rgb, &Rgb)| {
        // Blocks with next to no light say nothing.
        let differs = |i: usize| (b[i] > 1e-3).then(|| (a[i] / b[i] - 1.0).abs());
        (0..3).filter_map(differs).collect::<Vec<_>>()
    };
    let mut differences: Vec<f32> = ours.iter().zip(&theirs).flat_map(relative).collect();
    differences.sort_by(f32::total_cmp);
    let (median, worst) = (differences[differences.len() / 2], differences[differences.len() - 1]);
    println!("{name}: mean off by {off}, blocks by {median} (median) and {worst} (worst), {samples} samples");
    assert!(off.max_element() < 0.005, "{name}: mean off by {off}");
    assert!(median < 0.01 && worst < 0.05, "{name}: blocks off by {median} and {worst}");
}

#[test]
fn the_box_with_two_boxes_agrees() {
    compare("B3", &tracer(true, Fresnel::Exact), include_str!("figures/B3.txt"));
}

/// The reference has the approximation of Fresnel's equations.
#[test]
fn the_box_with_a_gold_ball_agrees() {
    compare("C3", &tracer(false, Fresnel::Approximate), include_str!("figures/C3.txt"));
}

/// Scene A3: a gold ball under a sky of radiance 1, by Fresnel's equations; the mean of a closed form over all pixels.
#[test]
fn gold_under_the_sky_agrees() {
    let mut scene = Scene::new();
    scene.surround(Rgb::ONE);
    scene.add("gold", Sphere::new(Vec3::ZERO, 1.0), Material::GOLD);
    let camera = Camera::new(Vec3::Z * 4.0, Vec3::ZERO, Vec3::Y, 40.0).unwrap();
    let method = Method { roulette: false, ..Method::BEST };
    let ours = blocks(&PathTracer { world: World::new(scene).into(), camera, method }, 256);
    let mean = ours.iter().sum::<Rgb>() / 64.0;
    let off = (mean - Rgb::new(0.975_128, 0.940_261, 0.772_773)).abs();
    println!("A3: mean off by {off}");
    assert!(off.max_element() < 3e-4, "{mean}");
}

/// The frame of reference is right: a box that is turned over would be noticed.
#[test]
fn a_wrong_scene_is_noticed() {
    let right = tracer(true, Fresnel::Exact);
    let frame = Frame::at(Vec3::ZERO).turned(Vec3::Y, 2.0);
    let eye = frame.point_to_world(right.camera.eye());
    let camera = Camera::new(eye, Vec3::Y, Vec3::Y, 38.0).unwrap();
    let turned = PathTracer { camera, ..right };
    let (ours, theirs) = (blocks(&turned, 64), figures(include_str!("figures/B3.txt")));
    let worst = ours.iter().zip(&theirs).map(|(a, b)| (a.y / b.y - 1.0).abs()).fold(0.0, f32::max);
    assert!(worst > 0.1, "{worst}");
}
