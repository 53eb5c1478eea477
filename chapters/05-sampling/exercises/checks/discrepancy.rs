//! Radical inverses in another way, and how fast the error of points falls.

use common::float;
use sampling::slope::log_log_slope;

/// The radical inverse in whole numbers: the mirrored digits, over a power of the base.
///
/// Both stay below 2¹²⁸ for 64 bits of index and 32 bits of base.
pub(crate) fn inverse_of(base: u32, index: u64) -> f64 {
    let base = u128::from(base.max(2));
    let (mut left, mut mirrored, mut power) = (u128::from(index), 0_u128, 1_u128);
    while left > 0 {
        mirrored = mirrored * base + left % base;
        power *= base;
        left /= base;
    }
    (mirrored as f64 / power as f64).min(1.0 - f64::EPSILON / 2.0)
}

/// The slope of the error of the mean of e^(x + y) on a log–log plot: −1/2 for random points, nearly −1 for Halton
/// points. `None` where there is none, as when all errors are 0 or no numbers.
///
/// For each count the error is the root mean square over 16 stretches of the sequence.
pub(crate) fn error_slope(point: &dyn Fn(u64) -> [f64; 2]) -> Option<f64> {
    let counts = [16, 64, 256, 1024, 4096];
    log_log_slope(&counts.map(|count| [count as f64, error(point, count)])).filter(|slope| slope.is_finite())
}

/// The root mean square error of means over `count` points.
pub(crate) fn error(point: &dyn Fn(u64) -> [f64; 2], count: u64) -> f64 {
    const RUNS: u64 = 16;
    let exact = (std::f64::consts::E - 1.0) * (std::f64::consts::E - 1.0);
    let error = |run: u64| {
        let values = (0..count).map(|i| point(run * count + i)).map(|[x, y]| float::exp_f64(x + y));
        values.sum::<f64>() / count as f64 - exact
    };
    ((0..RUNS).map(|run| error(run) * error(run)).sum::<f64>() / RUNS as f64).sqrt()
}
