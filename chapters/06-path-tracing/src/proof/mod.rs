//! The proof that the path tracer is right, and that the proof would notice if it were not. What is measured stands in
//! `experiments`; here it is asserted.
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

use common::{Rgb, story::Untold};
use ray_casting::ray::Ray;
use sampling::estimate::Estimate;

use crate::{experiments::estimate, path_tracer::PathTracer};

/// Whether time does not matter.
fn long_run() -> bool {
    std::env::var_os("LONG_RUN").is_some()
}

/// The red radiance along a ray.
fn red(tracer: &PathTracer, ray: Ray, paths: u64, seed: u64) -> Estimate {
    estimate(paths, seed, |random| tracer.trace(ray, random, &mut Untold).x.into())
}

/// The same in all channels.
fn gray(value: f32) -> Rgb {
    Rgb::splat(value)
}
