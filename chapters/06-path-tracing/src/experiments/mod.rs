//! What is measured of the path tracer: scenes whose light is known, on paper or from another program, and what comes out
//! when they are rendered. That it is right is asserted by the tests in `proof`.

pub mod coat;
pub mod cornell_box;
pub mod furnace;
pub mod honest;
pub mod mistakes;
pub mod reference;
pub mod slope;

use common::{Error, Stream, Vec3, parallel};
use ray_casting::{camera::Camera, pictures::stage::camera_error, scene::Scene};
use sampling::estimate::Estimate;

use crate::{material::Material, method::Method, path_tracer::PathTracer, world::World};

/// An estimate of one number from many paths, by all cores, the same whatever their number.
pub fn estimate(paths: u64, seed: u64, one: impl Fn(&mut Stream) -> f64 + Sync) -> Estimate {
    const CHUNK: u64 = 4096;
    let chunk = |chunk: usize| {
        let first = chunk as u64 * CHUNK;
        let mut estimate = Estimate::default();
        for path in first..paths.min(first + CHUNK) {
            estimate.add(one(&mut Stream::new(seed, path, 0)));
        }
        estimate
    };
    let chunks = parallel::map(usize::try_from(paths.div_ceil(CHUNK)).unwrap_or(usize::MAX), chunk);
    chunks.into_iter().fold(Estimate::default(), Estimate::merge)
}

/// Whether an estimate is right: within 3σ, or within rounding where nothing is left to chance.
#[must_use]
pub fn is_right(estimate: &Estimate, expected: f64) -> bool {
    (estimate.mean() - expected).abs() <= estimate.three_sigma() + 1e-5 * expected
}

/// The tracer of a scene, with some camera, for those who trace rays of their own.
pub(crate) fn tracer(scene: Scene<Material>, method: Method) -> Result<PathTracer, Error> {
    let camera = Camera::new(Vec3::ZERO, Vec3::X, Vec3::Y, 40.0).map_err(camera_error)?;
    Ok(PathTracer { world: World::new(scene).into(), camera, method })
}
