//! How fast chapter 6 is: `cargo bench -p path-tracing`. Compare lines of one run only; machines differ.
//!
//! Beside the course's own room stands the box of scene B3 of the proof (a box with two boxes in it, lit by a point), which
//! other programs render too: multiply its rate by the number of threads that they use.

use std::{hint::black_box, sync::Arc};

use common::{
    Interval, Stream, Vec2,
    picture::{FilmPoint, Integrator as _, Settings},
    story::Untold,
};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use path_tracing::{
    experiments::cornell_box,
    method::Method,
    path_tracer::PathTracer,
    pictures::{room, steps},
};
use ray_casting::{
    mesh::{Mesh, Shading},
    ray::Ray,
};
use space_partitioning::choice::Choice;

/// Paths of one measurement.
const PATHS: u64 = 4096;

/// One path through each of many points of the film, on one core.
fn trace(tracer: &PathTracer) -> f32 {
    let size = Vec2::splat(64.0);
    let path = |i: u64| {
        let mut random = Stream::new(0, i, 0);
        let position = size * Vec2::new(random.uniform(), random.uniform());
        tracer.radiance(FilmPoint { position, size }, &mut random, &mut Untold).x
    };
    (0..PATHS).map(path).sum()
}

/// Paths per second, by scene and method.
fn paths(c: &mut Criterion) {
    let mut group = c.benchmark_group("paths");
    group.throughput(Throughput::Elements(PATHS)).sample_size(20);
    let names = ["random walk", "+ direct light", "+ importance sampling", "+ roulette"];
    for (name, method) in names.into_iter().zip(steps::methods()) {
        if let Ok(tracer) = room::tracer(method, &Settings::default()) {
            group.bench_function(format!("room, {name}"), |b| b.iter(|| trace(black_box(&tracer))));
        }
    }
    if let Ok(tracer) = cornell_box::tracer(true, Method::BEST) {
        group.bench_function("box", |b| b.iter(|| trace(black_box(&tracer))));
    }
    group.finish();
}

/// Rays from anywhere in the box to anywhere else, by what finds the triangles.
fn structures(c: &mut Criterion) {
    const RAYS: usize = 4096;
    let mut group = c.benchmark_group("rays in the box");
    let rays = cornell_box::rays(RAYS);
    group.throughput(Throughput::Elements(RAYS as u64)).sample_size(20);
    let Ok(mesh) = Mesh::new(&cornell_box::mesh(true).mesh, Shading::Flat).map(Arc::new) else { return };
    for choice in Choice::ALL {
        let Ok(structure) = choice.over(Arc::clone(&mesh)) else { return };
        let find = |ray: &Ray| structure.find(ray, Interval::POSITIVE).map_or(0.0, |found| found.t);
        group.bench_function(choice.name(), |b| b.iter(|| rays.iter().map(find).sum::<f32>()));
    }
    group.finish();
}

criterion_group!(benches, paths, structures);
criterion_main!(benches);
