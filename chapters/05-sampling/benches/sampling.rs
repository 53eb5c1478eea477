//! How fast the sampling functions of chapter 5 are: `cargo bench -p sampling`. Compare lines of one run only; machines
//! differ.

use std::hint::black_box;

use common::{Stream, Vec2, Vec3};
use criterion::{Criterion, criterion_group, criterion_main};
use sampling::{
    cosine_hemisphere::{sample_cosine_hemisphere, sample_cosine_hemisphere_by_rejection},
    direction_sampling::DirectionSampling,
    disc::{sample_uniform_disc_by_rejection, sample_uniform_disc_concentric, sample_uniform_disc_polar},
    uniform_hemisphere::{sample_uniform_hemisphere, sample_uniform_hemisphere_by_rejection},
    uniform_sphere::{sample_uniform_sphere, sample_uniform_sphere_by_rejection},
    unit_square::sample_unit_square,
};

/// A thousand samples each way, with the random numbers that they need.
fn samples(c: &mut Criterion) {
    const UP: Vec3 = Vec3::Z;
    let mut group = c.benchmark_group("1000 samples");
    let mut race = |name: &str, draw: &dyn Fn(&mut Stream) -> Vec3| {
        let mut random = Stream::new(0, 0, 0);
        group.bench_function(name, |b| b.iter(|| (0..1000).map(|_| draw(black_box(&mut random))).sum::<Vec3>()));
    };
    let flat = |point: Vec2| point.extend(0.0);
    race("random numbers alone", &|random| flat(sample_unit_square(random)));
    race("disc by rejection", &|random| flat(sample_uniform_disc_by_rejection(random)));
    race("disc, polar", &|random| flat(sample_uniform_disc_polar(sample_unit_square(random))));
    race("disc, concentric", &|random| flat(sample_uniform_disc_concentric(sample_unit_square(random))));
    race("sphere by rejection", &sample_uniform_sphere_by_rejection);
    race("sphere", &|random| sample_uniform_sphere(sample_unit_square(random)));
    race("hemisphere by rejection", &|random| sample_uniform_hemisphere_by_rejection(UP, random));
    race("hemisphere", &|random| sample_uniform_hemisphere(sample_unit_square(random)));
    race("cosine hemisphere by rejection", &sample_cosine_hemisphere_by_rejection);
    race("cosine hemisphere", &|random| sample_cosine_hemisphere(sample_unit_square(random)));
    group.finish();
}

/// A thousand directions at a surface, with their densities.
fn directions(c: &mut Criterion) {
    let normal = Vec3::new(0.6, 0.0, -0.8);
    let mut group = c.benchmark_group("1000 directions at a surface");
    for way in DirectionSampling::ALL {
        let mut random = Stream::new(0, 0, 0);
        group.bench_function(way.name(), |b| {
            b.iter(|| {
                let one = |_| way.sample(black_box(normal), sample_unit_square(&mut random));
                (0..1000).map(one).map(|sample| sample.direction * sample.density.weight()).sum::<Vec3>()
            });
        });
    }
    group.finish();
}

criterion_group!(benches, samples, directions);
criterion_main!(benches);
