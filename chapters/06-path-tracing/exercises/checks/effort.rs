//! How many rays each way needs, for exercise 6.4.

use common::{
    exercise::{Finding, Verdict, trying},
    output,
};
use sampling::{estimate::Estimate, unit_square::sample_unit_square};

use super::{
    asked_or_found::Answer,
    lamp_exact::irradiance,
    places::{below, stream, words},
    words::{about, is_near},
};

/// Half the side of the lamps, which hang at height 1.
pub(crate) const HALVES: [f32; 9] = [0.05, 0.1, 0.2, 0.4, 0.8, 1.6, 3.2, 6.4, 12.8];
/// Samples of each way and lamp.
const COUNT: u32 = 20_000;
/// The ways and the rays of one sample.
pub(crate) const WAYS: [(&str, f64); 3] = [("asked", 1.0), ("found", 1.0), ("combined", 2.0)];

/// How many rays each way needs for an error of 10 % at one lamp.
pub(crate) struct Effort {
    /// Half the side of the lamp.
    pub(crate) half: f32,
    /// For each way.
    pub(crate) rays: [f64; 3],
    /// What came out of it.
    estimates: [Estimate; 3],
    expected: f64,
}

impl Effort {
    /// Measure the ways at one lamp.
    pub(crate) fn measure(answer: Answer, half: f32) -> Self {
        let place = below(half);
        let expected = irradiance(place.lamp(), place.hit().position, place.normal());
        let mut estimates = [Estimate::default(); 3];
        let mut random = stream(u64::from(half.to_bits()));
        for _ in 0..COUNT {
            let [u, v, u_ask, u_find] = [(); 4].map(|()| sample_unit_square(&mut random));
            let tried = || format!("a sample at {}", words(&place));
            let samples = trying(tried, || {
                [(answer.asked)(&place, u), (answer.found)(&place, v), (answer.combined)(&place, u_ask, u_find)]
            });
            estimates.iter_mut().zip(samples).for_each(|(estimate, sample)| estimate.add(sample.into()));
        }
        // An error of 10 % is a hundredth of the square of the mean.
        let need =
            |(estimate, (_, rays)): (Estimate, (&str, f64))| rays * estimate.variance() / (expected * expected) * 100.0;
        let [a, b, c] = estimates;
        let [x, y, z] = WAYS;
        Self { half, rays: [(a, x), (b, y), (c, z)].map(need), estimates, expected }
    }
}

/// Accept ways that are right on average, and a combination that is never much worse than the better one. If so, the table
/// is printed.
pub(super) fn efforts(answer: Answer) -> Verdict {
    let efforts = HALVES.map(|half| Effort::measure(answer, half));
    efforts.iter().try_for_each(one_effort)?;
    // Whoever closed the pipe has seen enough.
    let _ = output::write_to_stdout(table(&efforts).as_bytes());
    Ok(())
}

fn one_effort(effort: &Effort) -> Verdict {
    let tried =
        |way: &str| format!("{COUNT} samples of `{way}`, for a lamp at height 1 with sides of {}", 2.0 * effort.half);
    for (estimate, (way, _)) in effort.estimates.iter().zip(WAYS) {
        let slack = estimate.three_sigma() * 5.0 / 3.0 + 1e-3 * effort.expected;
        if !is_near(estimate.mean(), effort.expected, slack) {
            let (got, expected) = (format!("the mean {}", about(estimate.mean())), about(effort.expected));
            let advice =
                "One by one these samples were right. Does your function give another result when it is asked again?";
            return Err(Finding { tried: tried(way), got, expected, advice: advice.into() }.named("wrong-mean"));
        }
    }
    // The balance heuristic has at most the variance of either way and half the square of the mean. In rays for 10 % that is
    // twice as many, since it takes two for a sample, and 100.
    let [asked, found, combined] = effort.rays;
    let most = 2.0 * asked.min(found) + 100.0;
    if combined > most {
        let (got, expected) =
            (format!("{} rays for an error of 10 %", about(combined)), format!("at most {}", about(most)));
        let advice = "The combination must never be much worse than the better way. Look at the weights.";
        return Err(Finding { tried: tried("combined"), got, expected, advice: advice.into() }.named("too-noisy"));
    }
    Ok(())
}

/// The table in letters.
fn table(efforts: &[Effort]) -> String {
    let mut table = String::from("Rays for an error of 10 %, below a square lamp at height 1:\n\n  side of the lamp");
    WAYS.iter().for_each(|(way, _)| table += &format!("{way:>12}"));
    for Effort { half, rays, .. } in efforts {
        table += &format!("\n{:>18}", 2.0 * half);
        rays.iter().for_each(|rays| table += &format!("{rays:>12.1}"));
    }
    table + "\n"
}
