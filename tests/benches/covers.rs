//! How fast the covers of all chapters are: `cargo bench -p tests`. Compare lines of one run only; machines differ.

use common::{
    film::{Film, Size},
    picture::Settings,
    renderer::{Plan, render},
};
use criterion::{Criterion, criterion_group, criterion_main};

/// Each cover at 1280×720, one sample a pixel, by one thread and by two.
fn covers(c: &mut Criterion) {
    let mut group = c.benchmark_group("cover 1280x720, one sample");
    group.sample_size(10);
    for chapter in course::CHAPTERS {
        let Ok(picture) = (chapter.pictures[0].make)(&Settings::default()) else { continue };
        for threads in [1, 2] {
            group.bench_function(format!("{}, threads: {threads}", chapter.name), |b| {
                b.iter(|| {
                    let mut film = Film::new(Size::of::<1280, 720>());
                    render(picture.as_ref(), &mut film, &Plan { samples: 1, seed: 0, threads }, &());
                    film
                });
            });
        }
    }
    group.finish();
}

criterion_group!(benches, covers);
criterion_main!(benches);
