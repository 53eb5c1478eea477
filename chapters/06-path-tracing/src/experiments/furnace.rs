//! The furnace: a closed ball whose wall glows and reflects. However long a path, its mean is known.

use common::{Error, Interval, Rgb, Stream, Vec3, story::Untold};
use ray_casting::{hit::Hit, ray::Ray, scene::Scene, shape::Shape, sphere::Sphere};
use sampling::{estimate::Estimate, sky_light::Choice};

use super::estimate;
use crate::{importance::Step, material::Material, method::Method, path_tracer::PathTracer};

/// A cell of the table: albedo, directions, roulette.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Of the wall.
    pub albedo: f32,
    /// Which directions are followed.
    pub choice: Choice,
    /// Whether chance may end a path.
    pub roulette: bool,
}

/// Which part of the wall glows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Glow {
    /// All of it, with radiance 1: the light is the same everywhere, `1/(1 − ρ)`, so any direction sees the right thing.
    Whole,
    /// The half with x > 0 only. Any point of a ball sends the same share of its light to any other, so that a wall point
    /// receives the mean light: `L = Le + ρ/(1 − ρ) · ½`. Here it matters where paths go.
    Half,
}

/// All cells.
pub fn cells() -> impl Iterator<Item = Cell> {
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
    #[must_use]
    pub fn expected(self, glow: Glow) -> f64 {
        let albedo = f64::from(self.albedo);
        match glow {
            Glow::Whole => 1.0 / (1.0 - albedo),
            Glow::Half => 0.5 * albedo / (1.0 - albedo),
        }
    }

    /// The tracer of this cell, with a greatest number of bounces that plays no part: 0.8²⁰⁰ < 10⁻¹⁹.
    ///
    /// # Errors
    /// None.
    pub fn tracer(self, glow: Glow) -> Result<PathTracer, Error> {
        let sphere = Sphere::new(Vec3::ZERO, 2.0);
        let mut scene = Scene::new();
        for is_right in [false, true] {
            let emission = if is_right || glow == Glow::Whole { Rgb::ONE } else { Rgb::ZERO };
            let wall = Material { emission, ..Material::matte(Rgb::splat(self.albedo)) };
            scene.add("wall", Half { sphere, is_right }, wall);
        }
        let method =
            Method { choice: self.choice, roulette: self.roulette, direct: true, bounces: 0..=200, ..Method::PLAIN };
        super::tracer(scene, method)
    }
}

/// The ray that asks for the radiance of the wall.
fn ray() -> Ray {
    Ray::new(Vec3::new(0.3, 0.1, -0.2), Vec3::new(-0.9, 0.3, 0.4).normalize())
}

/// One path.
pub fn traced(tracer: &PathTracer, random: &mut Stream) -> f64 {
    tracer.trace(ray(), random, &mut Untold).x.into()
}

/// One path, where `next_step` chooses how it goes on.
pub fn walked(
    tracer: &PathTracer,
    random: &mut Stream,
    next_step: impl Fn(&Material, &Hit, Vec3, &mut Stream, &mut Untold) -> Option<Step>,
) -> f64 {
    tracer.walk(ray(), random, &mut Untold, next_step).x.into()
}

/// Measure a cell, where one path is `path`.
///
/// # Errors
/// None.
pub fn measure(
    cell: Cell,
    glow: Glow,
    path: impl Fn(&PathTracer, &mut Stream) -> f64 + Sync,
) -> Result<Estimate, Error> {
    const PATHS: u64 = 40_000;
    let tracer = cell.tracer(glow)?;
    // Without roulette all paths are long.
    let paths = if cell.roulette { PATHS } else { PATHS / 10 };
    Ok(estimate(paths, 61, |random| path(&tracer, random)))
}
