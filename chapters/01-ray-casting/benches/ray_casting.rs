//! How fast the shapes of chapter 1 are: `cargo bench -p ray-casting`. Compare lines of one run only; machines differ.

use std::hint::black_box;

use common::{Interval, Stream, Vec3};
use criterion::{Criterion, criterion_group, criterion_main};
use ray_casting::{ray::Ray, sphere::Sphere, triangle::Triangle, triangle_barycentric::Shear};

/// A thousand rays from around a point toward the unit cube.
fn rays() -> Vec<Ray> {
    let mut random = Stream::new(0, 0, 0);
    let mut in_cube = || Vec3::from_array([(); 3].map(|()| 2.0 * random.uniform() - 1.0));
    (0..1000).map(|_| (in_cube() + Vec3::Z * 5.0, in_cube())).map(|(o, p)| Ray::new(o, (p - o).normalize())).collect()
}

/// A thousand rays against one shape, each way of the chapter.
fn shapes(c: &mut Criterion) {
    let rays = rays();
    let triangle = Triangle::new(Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -0.8, 0.2), Vec3::new(0.0, 1.0, -0.3));
    let sphere = Sphere::new(Vec3::ZERO, 1.0);
    let range = Interval::POSITIVE;
    let mut group = c.benchmark_group("1000 rays");
    let mut race = |name: &str, hits: &dyn Fn(&Ray) -> bool| {
        group.bench_function(name, |b| b.iter(|| rays.iter().filter(|ray| hits(black_box(ray))).count()));
    };
    race("triangle by edges", &|ray| triangle.hit_by_edges(ray, range).is_some());
    race("triangle by barycentric coordinates", &|ray| {
        triangle.hit_by_barycentric(&Shear::along(ray), range).is_some()
    });
    race("sphere by the textbook's formula", &|ray| sphere.roots_textbook(ray).first_in(range).is_some());
    race("sphere by the stable formula", &|ray| sphere.roots(ray).first_in(range).is_some());
    group.finish();
}

/// One ray against many triangles: the view along the ray is made once.
fn mesh(c: &mut Criterion) {
    let rays = rays();
    let mut random = Stream::new(1, 0, 0);
    let mut corner = || Vec3::from_array([(); 3].map(|()| 2.0 * random.uniform() - 1.0));
    let triangles: Vec<_> = (0..1000).map(|_| Triangle::new(corner(), corner(), corner())).collect();
    let mut group = c.benchmark_group("one ray, 1000 triangles");
    group.bench_function("by edges", |b| {
        b.iter(|| {
            triangles.iter().filter(|t| t.hit_by_edges(black_box(&rays[0]), Interval::POSITIVE).is_some()).count()
        });
    });
    group.bench_function("by barycentric coordinates", |b| {
        b.iter(|| {
            let along = Shear::along(black_box(&rays[0]));
            triangles.iter().filter(|t| t.hit_by_barycentric(&along, Interval::POSITIVE).is_some()).count()
        });
    });
    group.finish();
}

criterion_group!(benches, shapes, mesh);
criterion_main!(benches);
