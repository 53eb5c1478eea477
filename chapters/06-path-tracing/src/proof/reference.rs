//! Agreement with scenes that an independent program rendered. A mean that is off by more than 1 % is a bias, not noise.

use common::{Rgb, Vec3, film::Film};
use ray_casting::{camera::Camera, frame::Frame, scene::Scene, sphere::Sphere};

use crate::{
    experiments::reference::{self, Comparison, Reference, blocks, mean},
    material::Material,
    method::Method,
    path_tracer::PathTracer,
    world::World,
};

/// A picture without bad samples.
fn sound_film(tracer: &PathTracer, samples: u32) -> Film {
    let film = reference::film(tracer, samples);
    assert_eq!(film.bad_samples(), 0);
    film
}

/// Compare means within 0.5 %, blocks with a median within 1 % and none beyond 5 %. Few samples leave blocks of dim colors
/// with more noise than that: in the short run they may be off by five standard deviations instead, and the median by two
/// thirds of one, as it should be, and a little more.
fn compare(reference: Reference) {
    let samples = if super::long_run() { 4096 } else { 256 };
    assert_eq!(reference.figures().len(), 64);
    let comparison = Comparison::of(&sound_film(&reference.tracer().unwrap(), samples), reference);
    for [differs, noise] in &comparison.blocks {
        let allowed = if super::long_run() { 0.05 } else { (5.0 * noise).max(0.05) };
        assert!(*differs < allowed, "{reference:?}: a block is off by {differs}, with a noise of {noise}");
    }
    let (off, [median, by_noise]) = (comparison.mean, comparison.medians());
    let worst = comparison.blocks.iter().map(|[differs, _]| *differs).fold(0.0, f32::max);
    println!(
        "{reference:?}: mean off by {off}, blocks by {median} (median, {by_noise} σ) and {worst} (worst), {samples} samples"
    );
    assert!(off.max_element() < 0.005, "{reference:?}: mean off by {off}");
    assert!(
        median < 0.01 || !super::long_run() && by_noise < 0.9,
        "{reference:?}: blocks off by {median}, {by_noise} σ"
    );
}

#[test]
fn the_box_with_two_boxes_agrees() {
    compare(Reference::Boxes);
}

#[test]
fn the_box_with_a_gold_ball_agrees() {
    compare(Reference::Gold);
}

/// Scene A3: a gold ball under a sky of radiance 1, by Fresnel's equations; the mean of a closed form over all pixels.
#[test]
fn gold_under_the_sky_agrees() {
    let mut scene = Scene::new();
    scene.surround(Rgb::ONE);
    scene.add("gold", Sphere::new(Vec3::ZERO, 1.0), Material::GOLD);
    let camera = Camera::new(Vec3::Z * 4.0, Vec3::ZERO, Vec3::Y, 40.0).unwrap();
    let method = Method { roulette: false, ..Method::BEST };
    let mean = mean(&blocks(&sound_film(&PathTracer { world: World::new(scene).into(), camera, method }, 256)));
    let off = (mean - Rgb::new(0.975_128, 0.940_261, 0.772_773)).abs();
    println!("A3: mean off by {off}");
    assert!(off.max_element() < 3e-4, "{mean}");
}

/// The frame of reference is right: a box that is turned over would be noticed.
#[test]
fn a_wrong_scene_is_noticed() {
    let right = Reference::Boxes.tracer().unwrap();
    let frame = Frame::at(Vec3::ZERO).turned(Vec3::Y, 2.0);
    let eye = frame.point_to_world(right.camera.eye());
    let camera = Camera::new(eye, Vec3::Y, Vec3::Y, 38.0).unwrap();
    let turned = PathTracer { camera, ..right };
    let comparison = Comparison::of(&sound_film(&turned, 64), Reference::Boxes);
    // Of green, which has the least noise.
    let worst = comparison.blocks.iter().skip(1).step_by(3).map(|[differs, _]| *differs).fold(0.0, f32::max);
    assert!(worst > 0.1, "{worst}");
}
