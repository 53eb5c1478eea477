//! Where samples lie within their strata.

use common::exercise::{Diagnosis, Finding, Verdict};

use super::{tally::Tally, words::number};

/// A diagnosis.
pub(super) fn wrong(name: &'static str, tried: &str, got: String, expected: String, advice: &str) -> Diagnosis {
    Finding { tried: tried.into(), got, expected, advice: advice.into() }.named(name)
}

/// Where samples lie in their strata, from 0 to 1: one list for each call, in the order of strata.
pub(super) fn scattered(tried: &str, offsets: &[Vec<f32>]) -> Verdict {
    let all = || offsets.iter().flatten().copied();
    let (least, most) = all().fold((1.0_f32, 0.0_f32), |(least, most), x| (least.min(x), most.max(x)));
    let rule = "places all over the stratum, each as likely as any other";
    let told = |x: f32| number((f64::from(x) * 1000.0).round() / 1000.0);
    let range = format!("samples between {} and {} of the width of their strata", told(least), told(most));
    if most - least < 0.01 {
        let advice = "All samples lie at the same place of their strata: these are regular samples. Draw a random number for \
                      each of them.";
        return Err(wrong("not-random", tried, range, rule.into(), advice));
    }
    let neighbors = correlation(offsets.iter().flat_map(|call| call.windows(2).map(|pair| (pair[0], pair[1]))));
    if neighbors.abs() > 0.05 {
        let got = format!("samples of neighbors with a correlation of {}", told(neighbors as f32));
        let advice = "Neighbors lie at the same place of their strata: one random number serves for several samples. Draw a new \
                      one for each.";
        return Err(wrong("one-number-for-all", tried, got, "a correlation near 0".into(), advice));
    }
    if least > 0.02 || most < 0.98 {
        let advice = "A part of each stratum never gets a sample, so that what happens there is never seen. The random number \
                      from 0 to 1 must reach over the whole width.";
        return Err(wrong("part-of-the-stratum", tried, range, rule.into(), advice));
    }
    let mut tally = Tally::even(21);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 21")]
    all().for_each(|x| tally.add((x * 21.0) as usize));
    if tally.fits() {
        return Ok(());
    }
    let advice = "Some places of a stratum come more often than others. The random number is uniform as it is: take it as it is.";
    Err(wrong("not-uniform", tried, tally.got(), tally.wanted(), advice))
}

/// The correlation of pairs from 0 to 1: 0 if they know nothing of each other, and 1 if they are equal and uniform.
pub(super) fn correlation(pairs: impl Iterator<Item = (f32, f32)>) -> f64 {
    let (mut sums, mut product, mut count) = ([0.0, 0.0], 0.0, 0.0);
    for (a, b) in pairs.map(|(a, b)| (f64::from(a), f64::from(b))) {
        sums = [sums[0] + a, sums[1] + b];
        product += a * b;
        count += 1.0;
    }
    (product / count - sums[0] / count * sums[1] / count) * 12.0
}
