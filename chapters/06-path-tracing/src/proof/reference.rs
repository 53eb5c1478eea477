//! Agreement with scenes that an independent program rendered.
//!
//! The figures are of Mitsuba 3.9.1, 64×64 pixels, with a noise of ±0.02 % in the mean and at most 0.6 % in a block of 8×8
//! pixels. The scenes are described where they are built. A mean that is off by more than 1 % is a bias, not noise.

use common::{
    Rgb, Vec3,
    film::{Film, Size},
    renderer::{Plan, render},
};
use ray_casting::{camera::Camera, frame::Frame, scene::Scene, sphere::Sphere};
use whitted::material::Fresnel;

use crate::{material::Material, method::Method, path_tracer::PathTracer, pictures::cornell_box, world::World};

/// The box with two boxes (B3) or a gold ball (C3).
fn tracer(with_boxes: bool, fresnel: Fresnel) -> PathTracer {
    cornell_box::tracer(with_boxes, Method { fresnel, ..Method::BEST }).unwrap()
}

/// The figures of a file: a line for each block.
fn figures(text: &str) -> Vec<Rgb> {
    let number = |word: &str| word.parse::<f32>().unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| Rgb::from_slice(&line.split(' ').map(number).collect::<Vec<_>>())).collect()
}

/// The means of the blocks of 8×8 pixels, and their standard errors.
fn blocks(tracer: &PathTracer, samples: u32) -> Vec<[Rgb; 2]> {
    let mut film = Film::new(Size::of::<64, 64>());
    render(tracer, &mut film, &Plan { samples, seed: 68, threads: 0 }, &());
    assert_eq!(film.bad_samples(), 0);
    let block = |i: u32| {
        let (x, y) = (i % 8 * 8, i / 8 * 8);
        let pixels = || (0..64).filter_map(|k| film.pixel(x + k % 8, y + k / 8));
        let variance: Rgb = pixels().map(|pixel| pixel.standard_error() * pixel.standard_error()).sum();
        let sigma = Rgb::from_array(variance.to_array().map(f32::sqrt)) / 64.0;
        [pixels().map(|pixel| pixel.mean()).sum::<Rgb>() / 64.0, sigma]
    };
    (0..64).map(block).collect()
}

/// The mean over all blocks.
fn mean(blocks: &[[Rgb; 2]]) -> Rgb {
    blocks.iter().map(|block| block[0]).sum::<Rgb>() / 64.0
}

/// Compare means within 0.5 %, blocks with a median within 1 % and none beyond 5 %. Few samples leave blocks of dim colors
/// with more noise than that: in the short run they may be off by five standard deviations instead, and the median by two
/// thirds of one, as it should be, and a little more.
fn compare(name: &str, tracer: &PathTracer, reference: &str) {
    let samples = if super::long_run() { 4096 } else { 256 };
    let (ours, theirs) = (blocks(tracer, samples), figures(reference));
    assert_eq!(theirs.len(), 64);
    let off = (mean(&ours) / (theirs.iter().sum::<Rgb>() / 64.0) - 1.0).abs();
    let (mut differences, mut by_noise) = (Vec::new(), Vec::new());
    for ([block, sigma], reference) in ours.iter().zip(&theirs) {
        let [differs, noise] = [(*block / *reference - 1.0).abs(), *sigma / *reference].map(|v| v.to_array());
        differences.extend(differs);
        by_noise.extend(differs.into_iter().zip(noise).map(|(differs, noise)| differs / noise));
        let allowed = |noise: f32| if super::long_run() { 0.05 } else { (5.0 * noise).max(0.05) };
        let is_near = differs.into_iter().zip(noise).all(|(differs, noise)| differs < allowed(noise));
        assert!(is_near, "{name}: a block is off by {differs:?}, with a noise of {noise:?}");
    }
    differences.sort_by(f32::total_cmp);
    by_noise.sort_by(f32::total_cmp);
    let [median, by_noise] = [&differences, &by_noise].map(|all| all[all.len() / 2]);
    let worst = differences[differences.len() - 1];
    println!(
        "{name}: mean off by {off}, blocks by {median} (median, {by_noise} σ) and {worst} (worst), {samples} samples"
    );
    assert!(off.max_element() < 0.005, "{name}: mean off by {off}");
    assert!(median < 0.01 || !super::long_run() && by_noise < 0.9, "{name}: blocks off by {median}, {by_noise} σ");
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
    let mean = mean(&ours);
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
    let worst = ours.iter().zip(&theirs).map(|([a, _], b)| (a.y / b.y - 1.0).abs()).fold(0.0, f32::max);
    assert!(worst > 0.1, "{worst}");
}
