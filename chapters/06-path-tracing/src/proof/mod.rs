//! The proof that the path tracer is right, and that the proof would notice if it were not.
//!
//! What takes long is done less thoroughly by `cargo test`, and in full by
//! `LONG_RUN=1 cargo test --release -p path-tracing --lib proof -- --nocapture`.

mod furnace;
mod honest;
mod inside_sphere;
mod reference;
mod same_mean;
mod samples;
mod slope;
mod wrong;

use common::{Rgb, Stream, Vec3, parallel, story::Untold};
use ray_casting::{camera::Camera, ray::Ray};
use sampling::estimate::Estimate;

use crate::path_tracer::PathTracer;

/// Whether time does not matter.
fn long_run() -> bool {
    std::env::var_os("LONG_RUN").is_some()
}

/// An estimate of one number from many paths, by all cores, the same whatever their number.
fn estimate(paths: u64, seed: u64, one: impl Fn(&mut Stream) -> f64 + Sync) -> Estimate {
    const CHUNK: u64 = 4096;
    let chunk = |chunk: usize| {
        let first = chunk as u64 * CHUNK;
        let mut estimate = Estimate::default();
        for path in first..paths.min(first + CHUNK) {
            estimate.add(one(&mut Stream::new(seed, path, 0)));
        }
        estimate
    };
    let chunks = parallel::map(usize::try_from(paths.div_ceil(CHUNK)).unwrap(), chunk);
    chunks.into_iter().fold(Estimate::default(), Estimate::merge)
}

/// The red radiance along a ray.
fn red(tracer: &PathTracer, ray: Ray, paths: u64, seed: u64) -> Estimate {
    estimate(paths, seed, |random| tracer.trace(ray, random, &mut Untold).x.into())
}

/// The same in all channels.
fn gray(value: f32) -> Rgb {
    Rgb::splat(value)
}

/// Some camera, for those who trace rays of their own.
fn camera() -> Camera {
    Camera::new(Vec3::ZERO, Vec3::X, Vec3::Y, 40.0).unwrap()
}
