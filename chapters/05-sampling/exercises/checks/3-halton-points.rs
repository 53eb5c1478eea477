//! Checks exercise 5.3, Halton points.

use common::exercise::{Diagnosis, Finding, Verdict, trying};

use super::{
    discrepancy::{error_slope, inverse_of},
    words::number,
};

/// What the student writes.
#[derive(Clone, Copy)]
pub(crate) struct Answer {
    /// The radical inverse, by base and index.
    pub(crate) radical_inverse: fn(u32, u64) -> f64,
    /// A point of the square, by its number.
    pub(crate) halton: fn(u64) -> [f64; 2],
}

/// Bases that are tried.
const BASES: [u32; 8] = [2, 3, 10, 5, 7, 16, 1000, u32::MAX];
/// How far rounding may carry an inverse.
const ROUNDING: f64 = 1e-14;

/// A likely mistake: its name, what it answers, and what to say about it.
type Rival<'a> = (&'static str, &'a dyn Fn(u32, u64) -> f64, &'static str);

/// Accept Halton points, or name what is wrong with them.
pub(crate) fn check(answer: Answer) -> Verdict {
    let inverse = |base: u32, index: u64| {
        trying(|| format!("`radical_inverse({base}, {index})`"), || (answer.radical_inverse)(base, index))
    };
    let point = |index: u64| trying(|| format!("`halton({index})`"), || (answer.halton)(index));
    if (0..20).all(|index| inverse(2, index) == 0.0) {
        return Err(Diagnosis::not_started("All numbers are the same: `radical_inverse` returns 0 for every index."));
    }
    inverses(&inverse)?;
    if (0..20).all(|index| point(index) == [0.0; 2]) {
        let message = "`radical_inverse` is right. Now for `halton`, which returns the point (0, 0) for every index.";
        return Err(Diagnosis::new("halton-not-started", message));
    }
    points(&point)
}

/// Radical inverses of small indices, then of large ones.
fn inverses(inverse: &dyn Fn(u32, u64) -> f64) -> Verdict {
    let small = || BASES[..7].iter().flat_map(|&base| (0..300).map(move |index| (base, index)));
    let is_near = |a: f64, b: f64| (a - b).abs() <= ROUNDING * b.max(1.0);
    let digits = |base: u32, index: u64| {
        std::iter::successors(Some(index), move |i| Some(i / u64::from(base))).take_while(|i| *i > 0).count()
    };
    let power = |base: u32, count: usize| (0..count).fold(1.0, |power, _| power * f64::from(base));
    let rivals: [Rival<'_>; 7] = [
        (
            "not-mirrored",
            &|base, index| index as f64 / power(base, digits(base, index)),
            "The digits come in the order in which they are written: 123 became 0.123. The last digit must become the first one \
             behind the point.",
        ),
        (
            "no-point",
            &|base, index| inverse_of(base, index) * power(base, digits(base, index)),
            "The digits are mirrored, but they stand before the point: 123 became 321. The first digit that you take off weighs \
             1 / base, not 1.",
        ),
        (
            "one-place-late",
            &|base, index| inverse_of(base, index) * f64::from(base),
            "All numbers are `base` times too large: the first digit weighs 1. Divide the weight by the base before it is used.",
        ),
        (
            "one-place-early",
            &|base, index| inverse_of(base, index) / f64::from(base),
            "All numbers are `base` times too small: the first digit weighs 1 / base², not 1 / base.",
        ),
        (
            "next-index",
            &|base, index| inverse_of(base, index + 1),
            "These are the inverses of the index after the one that was asked for. The index 0 becomes 0.",
        ),
        (
            "always-base-2",
            &|_, index| inverse_of(2, index),
            "The base does not count: all inverses are those in base 2.",
        ),
        (
            "last-digit-only",
            &|base, index| (index % u64::from(base)) as f64 / f64::from(base),
            "Only the last digit counts. Go on with the quotient, `index / base`, until it is 0.",
        ),
    ];
    if let Some((base, index)) = small().find(|&(base, index)| !is_near(inverse(base, index), inverse_of(base, index)))
    {
        let rival = rivals
            .iter()
            .find(|(_, rival, _)| small().all(|(base, index)| is_near(inverse(base, index), rival(base, index))));
        let general =
            "Work this one out on paper: the digits of the index, mirrored, and each divided by its power of the base.";
        let (name, advice) = rival.map_or(("wrong-inverse", general), |(name, _, advice)| (*name, *advice));
        return Err(off(name, base, index, inverse(base, index), advice));
    }
    let large = [(1 << 30) - 1, (1 << 40) + 12_345, 0x0123_4567_89ab_cdef, u64::MAX - 1, u64::MAX];
    for (base, index) in BASES.into_iter().flat_map(|base| large.map(|index| (base, index))) {
        let got = inverse(base, index);
        if got == 1.0 {
            let advice = "The sum was rounded to 1. No point may lie on the far edge: take the smaller of your sum and the greatest \
                          f64 below 1.";
            return Err(off("rounded-to-one", base, index, got, advice));
        }
        if !is_near(got, inverse_of(base, index)) {
            let advice = "Small indices are right and large ones are not. Is something an `f32` or a `u32` that should be an `f64` or \
                          a `u64`? Does the loop end too early?";
            return Err(off("large-index", base, index, got, advice));
        }
    }
    Ok(())
}

/// An inverse that is off.
fn off(name: &'static str, base: u32, index: u64, got: f64, advice: &str) -> Diagnosis {
    let tried = format!("`radical_inverse({base}, {index})`");
    let near = |x: f64| format!("{x:.12}").trim_end_matches('0').trim_end_matches('.').to_owned();
    let expected = format!("{}, below 1", near(inverse_of(base, index)));
    Finding { tried, got: near(got), expected, advice: advice.into() }.named(name)
}

/// The points, and how fast their error falls.
fn points(point: &dyn Fn(u64) -> [f64; 2]) -> Verdict {
    let indices = || (0..2000).chain([1 << 20, (1 << 33) + 5, u64::MAX]);
    let is = |[x, y]: [u32; 2], shift: u64| {
        (0..2000).all(|index| {
            let [a, b] = point(index);
            (a - inverse_of(x, index + shift)).abs() <= ROUNDING && (b - inverse_of(y, index + shift)).abs() <= ROUNDING
        })
    };
    let wrong = |index: &u64| {
        let [x, y] = point(*index);
        !((x - inverse_of(2, *index)).abs() <= ROUNDING && (y - inverse_of(3, *index)).abs() <= ROUNDING)
    };
    let Some(index) = indices().find(wrong) else { return Ok(()) };
    let (name, advice) = if [2, 3, 5].iter().any(|&base| is([base, base], 0)) {
        ("on-the-diagonal", "x and y are the same, so that all points lie on one line of the square. y has the base 3.")
    } else if is([3, 2], 0) {
        ("axes-swapped", "x and y are swapped. These points are as good, but the task asks for base 2 along x.")
    } else if is([2, 3], 1) {
        ("next-point", "These are the right points, counted from 1. The point number 0 is (0, 0).")
    } else if [4, 8, 6].iter().any(|&base| is([2, base], 0) || is([base, 2], 0) || is([3, base], 0)) {
        ("common-divisor", "The two bases have a common divisor, so that most of the square stays empty. Take 2 and 3.")
    } else {
        ("wrong-points", "x is the radical inverse of the index in base 2, and y that of the same index in base 3.")
    };
    let told = |[x, y]: [f64; 2]| format!("({}, {})", number(x), number(y));
    let slope = |point: &dyn Fn(u64) -> [f64; 2]| {
        error_slope(point).map_or("no number".into(), |slope| format!("{slope:.2}").replace('-', "−"))
    };
    let right = |index: u64| [2, 3].map(|base| inverse_of(base, index));
    Err(Finding {
        tried: format!("`halton({index})`, and means of e^(x + y) over 16 to 4096 points"),
        got: format!("{}; the error falls with the slope {} on a log–log plot", told(point(index)), slope(point)),
        expected: format!("{}; the error falls with the slope {}", told(right(index)), slope(&right)),
        advice: advice.into(),
    }
    .named(name))
}
