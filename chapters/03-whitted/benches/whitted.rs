//! How fast chapter 3 is: `cargo bench -p whitted`. Compare lines of one run only; machines differ.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use whitted::fresnel;

/// The reflectance of gold for a thousand angles, by both formulas.
fn reflectance(c: &mut Criterion) {
    let cosines: Vec<_> = (1..=1000_u16).map(|i| f32::from(i) / 1000.0).collect();
    let (n, kappa) = (0.17, 3.1);
    let f0 = fresnel::at_normal_incidence(n, kappa);
    let mut group = c.benchmark_group("1000 reflectances");
    group.bench_function("exact", |b| {
        b.iter(|| cosines.iter().map(|&cosine| fresnel::exact(black_box(cosine), n, kappa)).sum::<f32>());
    });
    group.bench_function("approximate", |b| {
        b.iter(|| cosines.iter().map(|&cosine| fresnel::approximate(black_box(cosine), f0)).sum::<f32>());
    });
    group.finish();
}

criterion_group!(benches, reflectance);
criterion_main!(benches);
