//! Several things at once, where there are threads.

/// Do something with that many threads; 0 for as many as there are cores.
pub fn with_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    // Threads that cannot be had are no reason to fail: those that there are do the work.
    #[cfg(feature = "threads")]
    if let Ok(pool) = rayon::ThreadPoolBuilder::new().num_threads(threads).build() {
        return pool.install(work);
    }
    #[cfg(not(feature = "threads"))]
    let _ = threads;
    work()
}

/// How many things are done at once.
#[must_use]
pub fn threads() -> usize {
    #[cfg(feature = "threads")]
    return rayon::current_num_threads();
    #[cfg(not(feature = "threads"))]
    1
}

/// Do both, side by side if the feature `threads` is on and a core is free.
pub fn join<A: Send, B: Send>(a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    #[cfg(feature = "threads")]
    return rayon::join(a, b);
    #[cfg(not(feature = "threads"))]
    (a(), b())
}

/// Do something for each number below `count`, side by side where that is possible. The results are in order.
pub fn map<T: Send>(count: usize, one: impl Fn(usize) -> T + Send + Sync) -> Vec<T> {
    #[cfg(feature = "threads")]
    {
        use rayon::prelude::*;
        (0..count).into_par_iter().with_max_len(1).map(one).collect()
    }
    #[cfg(not(feature = "threads"))]
    (0..count).map(one).collect()
}

/// Do something with each of many things, side by side where that is possible. The results are in order. Unlike [`map`]
/// this is meant for very many small pieces of work.
pub fn map_slice<A: Sync, B: Send>(all: &[A], one: impl Fn(&A) -> B + Send + Sync) -> Vec<B> {
    #[cfg(feature = "threads")]
    {
        use rayon::prelude::*;
        all.par_iter().map(one).collect()
    }
    #[cfg(not(feature = "threads"))]
    all.iter().map(one).collect()
}
