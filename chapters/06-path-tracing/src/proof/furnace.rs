//! The furnace: a closed ball whose wall glows and reflects. However long a path, its mean is known.

use common::{Interval, Stream, Vec3};
use ray_casting::{hit::Hit, ray::Ray, scene::Scene, shape::Shape, sphere::Sphere};
use sampling::{estimate::Estimate, sky_light::Choice};

use super::{camera, estimate, gray};
use crate::{material::Material, method::Method, path_tracer::PathTracer, world::World};

/// A cell of the table: albedo, directions, roulette.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cell {
    pub(super) albedo: f32,
    pub(super) choice: Choice,
    pub(super) roulette: bool,
}

/// Which part of the wall glows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Glow {
    /// All of it, with radiance 1: the light is the same everywhere, `1/(1 − ρ)`, so any direction sees the right thing.
    Whole,
    /// The half with x > 0 only. Any point of a ball sends the same share of its light to any other, so that a wall point
    /// receives the mean light: `L = Le + ρ/(1 − ρ) · ½`. Here it matters where paths go.
    Half,
}

/// All cells.
pub(super) fn cells() -> impl Iterator<Item = Cell> {
    let with = |albedo| {
        let choices = [Choice::Uniform, Choice::CosineAndMirror].into_iter();
        choices.flat_map(move |choice| [true, false].map(|roulette| Cell { albedo, choice, roulette }))
    };
    [0.5, 0.8].into_iter().flat_map(with)
}

/// The half of a sphere on one side of x = 0.
struct Half {
    sphere: Sphere,
    is_right: bool,
}

impl Shape for Half {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        self.sphere.intersect(ray, range).filter(|hit| (hit.position.x > 0.0) == self.is_right)
    }
}

impl Cell {
    /// The radiance of the wall at x < 0.
    pub(super) fn expected(self, glow: Glow) -> f64 {
        let albedo = f64::from(self.albedo);
        match glow {
            Glow::Whole => 1.0 / (1.0 - albedo),
            Glow::Half => 0.5 * albedo / (1.0 - albedo),
        }
    }

    /// The tracer of this cell, with a greatest number of bounces that plays no part: 0.8²⁰⁰ < 10⁻¹⁹.
    pub(super) fn tracer(self, glow: Glow) -> PathTracer {
        let sphere = Sphere::new(Vec3::ZERO, 2.0);
        let mut scene = Scene::new();
        for is_right in [false, true] {
            let emission = if is_right || glow == Glow::Whole { gray(1.0) } else { gray(0.0) };
            scene.add("wall", Half { sphere, is_right }, Material { emission, ..Material::matte(gray(self.albedo)) });
        }
        let method =
            Method { choice: self.choice, roulette: self.roulette, direct: true, bounces: 0..=200, ..Method::PLAIN };
        PathTracer { world: World::new(scene).into(), camera: camera(), method }
    }
}

/// The ray that asks for the radiance of the wall.
pub(super) fn ray() -> Ray {
    Ray::new(Vec3::new(0.3, 0.1, -0.2), Vec3::new(-0.9, 0.3, 0.4).normalize())
}

/// Paths of each cell.
const PATHS: u64 = 40_000;

/// Measure a cell, where one path is `path`.
pub(super) fn measure(path: impl Fn(&PathTracer, &mut Stream) -> f64 + Sync, cell: Cell, glow: Glow) -> Estimate {
    let tracer = cell.tracer(glow);
    // Without roulette all paths are long.
    let paths = if cell.roulette { PATHS } else { PATHS / 10 };
    estimate(paths, 61, |random| path(&tracer, random))
}

/// Whether an estimate is right: within 3σ, or within rounding where nothing is left to chance.
pub(super) fn is_right(estimate: &Estimate, expected: f64) -> bool {
    (estimate.mean() - expected).abs() <= estimate.three_sigma() + 1e-5 * expected
}

#[test]
fn every_cell_of_the_furnace_is_right() {
    for glow in [Glow::Whole, Glow::Half] {
        for cell in cells() {
            let path = |tracer: &PathTracer, random: &mut Stream| {
                f64::from(tracer.trace(ray(), random, &mut common::story::Untold).x)
            };
            let (estimate, expected) = (measure(path, cell, glow), cell.expected(glow));
            println!("{glow:?} {cell:?}: {:.4} ± {:.4}, {expected:.4}", estimate.mean(), estimate.three_sigma());
            assert!(is_right(&estimate, expected), "{glow:?} {cell:?}: {estimate:?}, not {expected}");
        }
    }
}
