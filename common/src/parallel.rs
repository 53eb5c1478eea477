//! Several things at once, where there are threads.

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
