//! Measures what rays and structures cost as a scene grows, and prints the file behind the plots `growth` and `building`:
//!
//! `cargo run --release -p space-partitioning --no-default-features --example space-partitioning-measure > growth.csv`
//!
//! Without the feature `threads`, so that structures are built in one thread too. It takes some minutes and some
//! gigabytes of memory; the greatest size can be given as an argument.

use std::{
    hint::black_box,
    sync::Arc,
    time::{Duration, Instant},
};

use common::Error;
use space_partitioning::{
    choice::{Choice, Countable},
    growth::{MOST_BY_FORCE, SCENE, SIZES, Subject},
    measured::{COLUMNS, Measured},
    workload::Cast,
};

/// Repeat what takes less time than this.
const LONG: Duration = Duration::from_millis(1500);
/// But not more often than this.
const OFTEN: u32 = 400;

fn main() -> Result<(), Error> {
    let largest = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(u32::MAX);
    println!("# Scene '{}', seen by its camera; one diffuse bounce off what each camera ray sees.", SCENE.name);
    println!(
        "# Counts are sums over all rays, the same on every machine. Seconds are the least of several runs in one"
    );
    println!("# thread: to build the structure, and for one ray, the mean.");
    println!("{COLUMNS}");
    for triangles in SIZES.into_iter().filter(|&size| size <= largest) {
        let subject = Subject::new(triangles)?;
        for choice in [Choice::BruteForce, Choice::Grid, Choice::Octree, Choice::KdTree] {
            if choice == Choice::BruteForce && triangles > MOST_BY_FORCE {
                continue;
            }
            let (structure, build) = least(|| choice.over(Arc::clone(&subject.mesh)));
            let structure = structure?;
            let ((), rays) = least(|| trace(&subject, structure.as_ref()));
            let row = subject.row(choice, structure.as_ref());
            println!("{}", Measured { row, build, ray: rays / row.rays as f32 }.line());
        }
    }
    Ok(())
}

/// Trace all rays, told to nobody.
fn trace(subject: &Subject, structure: &dyn Countable) {
    for Cast { ray, range } in subject.casts() {
        black_box(structure.find(ray, *range));
    }
}

/// Do something several times. Returns its last result, and the seconds of the fastest time.
fn least<T>(mut once: impl FnMut() -> T) -> (T, f32) {
    let begin = Instant::now();
    let mut seconds = f32::INFINITY;
    for time in 1.. {
        let start = Instant::now();
        let result = once();
        seconds = seconds.min(start.elapsed().as_secs_f32());
        if begin.elapsed() > LONG || time >= OFTEN {
            return (result, seconds);
        }
    }
    (once(), seconds)
}
