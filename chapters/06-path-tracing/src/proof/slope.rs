//! The error falls like 1/√M, over 1 to 4096 samples.

use common::{Stream, story::Untold};
use sampling::{sky_light::Choice, slope::log_log_slope};

use super::furnace::{Cell, Glow, ray};

#[test]
fn the_error_falls_with_slope_one_half() {
    const MOST: u64 = 4096;
    let runs: usize = if super::long_run() { 8192 } else { 1024 };
    let cell = Cell { albedo: 0.5, choice: Choice::Uniform, roulette: true };
    let (tracer, expected) = (cell.tracer(Glow::Half), cell.expected(Glow::Half));
    // For each run the squared error after 1, 2, 4 … samples.
    let squares = common::parallel::map(runs, |run| {
        let (mut sum, mut squares) = (0.0, Vec::new());
        for sample in 1..=MOST {
            sum += f64::from(tracer.trace(ray(), &mut Stream::new(66, run as u64, sample), &mut Untold).x);
            if sample.is_power_of_two() {
                let error = sum / sample as f64 - expected;
                squares.push(error * error);
            }
        }
        squares
    });
    let points: Vec<[f64; 2]> = (0..=12)
        .map(|i| {
            let mean = squares.iter().map(|run| run[i]).sum::<f64>() / runs as f64;
            [(1_u64 << i) as f64, mean.sqrt()]
        })
        .collect();
    let slope = log_log_slope(&points).unwrap();
    println!("slope of the error: {slope:.4}");
    assert!((slope + 0.5).abs() < 0.02, "{slope}: {points:?}");
}
