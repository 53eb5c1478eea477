//! Trees of rays: both ways to write the recursion agree, and what a limit cuts off bounds the error.

use common::{Rgb, Stream, picture::Settings, story::Story};
use ray_casting::{
    light::{DirectionalLight, PointLight},
    material::Phong,
    scene::Scene,
    sphere::Sphere,
};
use whitted::{
    branches::Branch,
    material::Material,
    pictures::{glass, treasure},
    probe::{Probe, RayTree},
    whitted::Limits,
};

use crate::{
    illumination::random_color,
    mirrors::{Colors, whitted},
    rays::{aimed, between, direction, in_cube, one_of},
    recursion::points,
    shadows::any_camera,
};

/// A random scene of balls, rough and smooth ones, with lights.
pub(crate) fn random_scene(coated: bool, random: &mut Stream) -> Scene<Material> {
    let mut scene = Scene::new();
    scene.ambient = random_color(random) * 0.3;
    scene.surround(Colors);
    scene.light(DirectionalLight::new(direction(random), Rgb::ONE));
    scene.light(PointLight { position: in_cube(random) * 5.0, intensity: Rgb::splat(9.0) });
    for _ in 0..9 {
        let phong = Phong::of(random_color(random), 0.04, 30.0);
        let index = between(random, 0.6, 2.0);
        let material = match one_of(random, 6) {
            0 => Material::rough(phong),
            1 => Material::GOLD,
            2 if coated => Material::coated(phong, 1.5),
            2 => Material::COPPER,
            _ => Material::glass(index),
        };
        scene.add("ball", Sphere::new(in_cube(random) * 2.0, between(random, 0.4, 1.0)), material);
    }
    scene
}

/// The two ways to write the recursion add up the same terms in another order.
#[test]
fn the_loop_and_the_plain_recursion_agree() {
    let mut random = Stream::new(853, 0, 0);
    let (mut rays, mut branching) = (0, 0);
    for i in 0..300 {
        let mut whitted = whitted(random_scene(true, &mut random), any_camera(), i % 8);
        whitted.limits.min_weight = 0.0;
        for _ in 0..10 {
            let branch = Branch::from_camera(aimed(direction(&mut random) * 5.0, in_cube(&mut random) * 2.0));
            let mut tree = RayTree::default();
            let (found, plain) = (whitted.trace(branch, 0, &mut tree), whitted.trace_plain(&branch, 0));
            let slack = 32.0 * f32::EPSILON * (1.0 + plain.max_element());
            assert!((found - plain).abs().max_element() < slack, "depth {}: {found} {plain}", i % 8);
            assert!(tree.0.iter().all(|segment| segment.depth <= i % 8));
            rays += tree.0.len();
            branching += u32::from(tree.0.len() > 8);
        }
    }
    assert!(rays > 10_000 && branching > 300, "{rays} {branching}");
}

/// The same on the scenes of pictures, with all their shapes.
#[test]
fn both_agree_on_pictures() {
    let settings = Settings::default();
    let cover = whitted(treasure::scene(), treasure::view(&settings).unwrap(), 7);
    for mut picture in [cover, glass::panel(&settings, glass::solid).unwrap()] {
        picture.limits = Limits { max_depth: 7, min_weight: 0.0 };
        for point in points() {
            let branch = Branch::from_camera(picture.camera.ray(point));
            let (found, plain) = (picture.trace(branch, 0, &mut RayTree::default()), picture.trace_plain(&branch, 0));
            let slack = 32.0 * f32::EPSILON * (1.0 + plain.max_element());
            assert!((found - plain).abs().max_element() < slack, "{point:?}: {found} {plain}");
        }
    }
}

/// Adds up the weights that are not followed, as means of the channels.
#[derive(Default)]
struct Cuts(f64);

impl Probe for Cuts {
    fn cut(&mut self, weight: Rgb) {
        self.0 += f64::from(weight.element_sum()) / 3.0;
    }
}

/// Words are not for it.
impl Story for Cuts {
    fn tell(&mut self, _line: impl FnOnce() -> String) {}
    fn enter(&mut self, _line: impl FnOnce() -> String) {}
    fn leave(&mut self) {}
}

/// Whatever is not followed is replaced by a guess. The error is at most what was cut times the greatest radiance there is.
#[test]
fn the_error_of_the_weight_limit_is_bounded_by_what_was_cut() {
    // No radiance is greater than that of the surroundings: a rough ball has at most 0.3 + 1.04/π without the point light.
    const GREATEST: f64 = 0.4 * 2.1;
    let mut random = Stream::new(854, 0, 0);
    let [mut cut, mut errors, mut worst] = [0.0_f64; 3];
    for _ in 0..150 {
        let mut whitted = whitted(random_scene(false, &mut random), any_camera(), 9);
        whitted.scene.lights.truncate(1);
        for _ in 0..10 {
            let branch = Branch::from_camera(aimed(direction(&mut random) * 5.0, in_cube(&mut random) * 2.0));
            // The whole tree; and the one that is cut at 5 %. What the depth cuts is the same in both, or less.
            whitted.limits.min_weight = 0.0;
            let (mut by_both, mut tree) = (Cuts::default(), RayTree::default());
            let whole = whitted.trace(branch, 0, &mut RayTree::default());
            whitted.limits.min_weight = 0.05;
            let found = whitted.trace(branch, 0, &mut by_both);
            whitted.trace(branch, 0, &mut tree);
            assert!(tree.0.iter().all(|segment| segment.weight.element_sum() / 3.0 >= 0.05));
            let error = f64::from((found - whole).abs().element_sum() / 3.0);
            // The sums are rounded.
            let bound = 1.000_1 * by_both.0 * GREATEST + 1e-5;
            assert!(error <= bound, "{error} {bound}");
            cut += by_both.0;
            errors += error;
            worst = worst.max(error / bound);
        }
    }
    assert!(errors > 1.0 && worst < 1.0, "{cut} {errors} {worst}");
}
