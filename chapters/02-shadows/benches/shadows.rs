//! What stopping at the first hit saves: `cargo bench -p shadows`. Compare lines of one run only; machines differ.

use std::hint::black_box;

use common::{Interval, Stream, Vec3};
use criterion::{Criterion, criterion_group, criterion_main};
use ray_casting::{pictures::still_life, ray::Ray};

/// A thousand shadow rays through the still life, asked for the nearest hit and for any hit.
fn queries(c: &mut Criterion) {
    let Ok(scene) = still_life::scene() else { return };
    let mut random = Stream::new(0, 0, 0);
    let mut point = || Vec3::new(3.0 * random.uniform() - 1.5, 2.0 * random.uniform(), 3.0 * random.uniform() - 1.5);
    let rays: Vec<_> = (0..1000).map(|_| point()).map(|p| Ray::new(p, Vec3::new(0.4, 0.7, 0.6).normalize())).collect();
    let mut group = c.benchmark_group("1000 shadow rays");
    group.bench_function("nearest hit", |b| {
        b.iter(|| rays.iter().filter(|ray| scene.intersect(black_box(ray), Interval::POSITIVE).is_some()).count());
    });
    group.bench_function("any hit", |b| {
        b.iter(|| rays.iter().filter(|ray| scene.occluded(black_box(ray), Interval::POSITIVE)).count());
    });
    group.finish();
}

criterion_group!(benches, queries);
criterion_main!(benches);
