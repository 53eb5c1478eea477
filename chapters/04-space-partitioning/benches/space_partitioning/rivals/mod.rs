//! Those who are compared: each builds a structure over the same triangles and answers the same rays.

mod bvh_crate;
mod embree;
mod obvhs_crate;
mod ours;

use std::{sync::Arc, time::Instant};

use ray_casting::{mesh::Mesh, triangle::Triangle};
use space_partitioning::workload::Cast;

use self::bvh_crate::{BvhCrate, Search};

/// Why a rival cannot take part, in words.
pub(crate) type Failure = String;

/// What all of them are given.
pub(crate) struct Given {
    /// The triangles.
    pub(crate) mesh: Arc<Mesh>,
    /// Rays whose nearest hits are wanted.
    pub(crate) rays: Vec<Cast>,
}

impl Given {
    fn triangles(&self) -> Vec<Triangle> {
        self.mesh.triangles().collect()
    }
}

/// One who takes part.
pub(crate) trait Rival {
    /// What to call it.
    fn name(&self) -> &'static str;

    /// Build the structure anew, with all threads. Returns seconds.
    fn build(&mut self) -> Result<f64, Failure>;

    /// Memory of what was built, in bytes.
    fn bytes(&self) -> Option<usize>;

    /// Find the nearest hit of every ray, in one thread. Returns seconds.
    fn trace(&mut self) -> Result<f64, Failure>;

    /// The `t` of the nearest hit of every ray, infinite where there is none.
    fn answers(&mut self) -> Result<Vec<f32>, Failure>;
}

/// Everybody: the kd-tree first, since all others are compared with it. Whoever is not installed is told at once.
pub(crate) fn all(given: &Arc<Given>) -> Vec<Box<dyn Rival>> {
    let mut rivals = ours::all(given);
    rivals.push(Box::new(obvhs_crate::Obvhs::new(given)));
    for search in [Search::Sorted, Search::Pruned] {
        rivals.push(Box::new(BvhCrate::new(given, search)));
    }
    match embree::Embree::new(given) {
        Ok(embree) => rivals.push(Box::new(embree)),
        Err(why) => println!("Embree takes no part: {why}"),
    }
    rivals
}

/// How long something takes, in seconds, and what comes out.
fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = work();
    (start.elapsed().as_secs_f64(), result)
}

/// How long it takes to find the nearest hit of all rays.
fn traced(rays: &[Cast], mut nearest: impl FnMut(&Cast) -> f32) -> f64 {
    let (seconds, hits) = timed_here(|| rays.iter().map(&mut nearest).filter(|t| t.is_finite()).count());
    // Nobody needs them, but the compiler must not know.
    std::hint::black_box(hits);
    seconds
}

/// How long something takes in this thread alone: time that the processor spends on it, where the system tells that.
pub(crate) fn timed_here<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let before = processor_seconds();
    let (elapsed, result) = timed(work);
    // The system counts in steps of some milliseconds: too coarse for short work.
    let spent = processor_seconds().zip(before).map(|(after, before)| after - before).filter(|spent| *spent > 0.05);
    (spent.unwrap_or(elapsed), result)
}

/// Time that the processor has spent on this thread so far. Linux tells it.
fn processor_seconds() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    let nanoseconds: f64 = text.split_whitespace().next()?.parse().ok()?;
    Some(nanoseconds * 1e-9)
}
