//! The error falls like 1/√M, over 1 to 4096 samples.

use common::{Stream, story::Untold};
use sampling::{sky_light::Choice, slope::log_log_slope};

use super::furnace::{Cell, Glow, ray};

#[test]
fn the_error_falls_with_slope_one_half() {
    const LEVELS: usize = 13;
    const MOST: u64 = 1 << (LEVELS - 1);
    let runs: usize = if super::long_run() { 8192 } else { 1024 };
    let cell = Cell { albedo: 0.5, choice: Choice::Uniform, roulette: true };
    let (tracer, expected) = (cell.tracer(Glow::Half), cell.expected(Glow::Half));
    // For each run and M the mean of the squared errors of all its groups of M samples, one after the other.
    let squares = common::parallel::map(runs, |run| {
        let (mut sums, mut squares) = ([0.0; LEVELS], [0.0; LEVELS]);
        for sample in 1..=MOST {
            let radiance = f64::from(tracer.trace(ray(), &mut Stream::new(66, run as u64, sample), &mut Untold).x);
            for (level, (sum, square)) in sums.iter_mut().zip(&mut squares).enumerate() {
                *sum += radiance;
                let count = 1_u64 << level;
                if sample % count == 0 {
                    let error = std::mem::take(sum) / count as f64 - expected;
                    *square += error * error * count as f64 / MOST as f64;
                }
            }
        }
        squares
    });
    let point = |level: usize| {
        let mean = squares.iter().map(|run| run[level]).sum::<f64>() / runs as f64;
        [(1_u64 << level) as f64, mean.sqrt()]
    };
    let points: Vec<[f64; 2]> = (0..LEVELS).map(point).collect();
    let slope = log_log_slope(&points).unwrap();
    println!("slope of the error: {slope:.4}");
    assert!((slope + 0.5).abs() < 0.02, "{slope}: {points:?}");
}
