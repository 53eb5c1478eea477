//! How the error falls with the number of samples, in half a furnace.

use common::{Error, Stream, parallel};
use sampling::sky_light::Choice;

use super::furnace::{Cell, Glow, traced};

/// `[M, error]` for M = 1, 2, 4, … 4096 samples: the root of the mean square over all runs.
///
/// # Errors
/// None.
pub fn measure(runs: usize) -> Result<Vec<[f64; 2]>, Error> {
    const LEVELS: usize = 13;
    const MOST: u64 = 1 << (LEVELS - 1);
    let cell = Cell { albedo: 0.5, choice: Choice::Uniform, roulette: true };
    let (tracer, expected) = (cell.tracer(Glow::Half)?, cell.expected(Glow::Half));
    // For each run and M the mean of the squared errors of all its groups of M samples, one after the other.
    let squares = parallel::map(runs, |run| {
        let (mut sums, mut squares) = ([0.0; LEVELS], [0.0; LEVELS]);
        for sample in 1..=MOST {
            let radiance = traced(&tracer, &mut Stream::new(66, run as u64, sample));
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
    Ok((0..LEVELS).map(point).collect())
}
