//! Wrong Halton points.

use common::Stream;

use crate::{
    checks::{
        discrepancy::{error_slope, inverse_of},
        halton_points::{Answer, check},
    },
    name,
};

/// The digits of an index, the last one first.
fn digits(base: u32, index: u64) -> Vec<u64> {
    let quotients = std::iter::successors(Some(index), |i| Some(i / u64::from(base)));
    quotients.take_while(|i| *i > 0).map(|i| i % u64::from(base)).collect()
}

/// A number from its digits behind the point.
fn behind_the_point(base: u32, digits: &[u64]) -> f64 {
    digits.iter().rev().fold(0.0, |sum, digit| (sum + *digit as f64) / f64::from(base))
}

fn radical_inverse(base: u32, index: u64) -> f64 {
    behind_the_point(base, &digits(base, index)).min(1.0 - f64::EPSILON / 2.0)
}

fn halton(index: u64) -> [f64; 2] {
    [radical_inverse(2, index), radical_inverse(3, index)]
}

const RIGHT: Answer = Answer { radical_inverse, halton };

/// The diagnosis of such inverses.
fn inverses(radical_inverse: fn(u32, u64) -> f64) -> &'static str {
    name(check(Answer { radical_inverse, ..RIGHT }))
}

/// The diagnosis of such points.
fn points(halton: fn(u64) -> [f64; 2]) -> &'static str {
    name(check(Answer { halton, ..RIGHT }))
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(check(RIGHT), Ok(()));
    assert_eq!(check(Answer { radical_inverse: inverse_of, ..RIGHT }), Ok(()));
}

/// From the task, and by hand.
#[test]
fn inverses_are_those_on_paper() {
    for (base, index, expected) in [
        (10, 123, 0.321),
        (2, 0, 0.0),
        (2, 1, 0.5),
        (2, 6, 0.375),
        (3, 5, 7.0 / 9.0),
        (2, u64::MAX, 1.0 - f64::EPSILON / 2.0),
    ] {
        assert_eq!(inverse_of(base, index), expected, "{index} in base {base}");
    }
    // The first 2ⁿ of base 2 are all multiples of 2⁻ⁿ, each once.
    let mut first: Vec<f64> = (0..64).map(|index| inverse_of(2, index) * 64.0).collect();
    first.sort_by(f64::total_cmp);
    assert!(first.iter().zip(0_u8..).all(|(x, i)| *x == f64::from(i)));
}

/// What the task says of errors: nearly like 1/M, and like 1/√M.
#[test]
fn errors_fall_nearly_like_the_inverse_count() {
    let slope = error_slope(&halton).unwrap();
    assert!((-1.1..-0.85).contains(&slope), "{slope}");
    let random = |index: u64| {
        let mut random = Stream::new(1, index, 0);
        [(); 2].map(|()| f64::from(random.uniform()))
    };
    let slope = error_slope(&random).unwrap();
    assert!((-0.6..-0.4).contains(&slope), "{slope}");
    // On the diagonal, more points do not help.
    let slope = error_slope(&|index| [radical_inverse(2, index); 2]).unwrap();
    assert!(slope > -0.05, "{slope}");
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(name(check(Answer { radical_inverse: |_, _| 0.0, halton: |_| [0.0; 2] })), "not-started");
    assert_eq!(points(|_| [0.0; 2]), "halton-not-started");
}

#[test]
fn wrong_inverses() {
    assert_eq!(
        inverses(|base, index| {
            let mut digits = digits(base, index);
            digits.reverse();
            behind_the_point(base, &digits)
        }),
        "not-mirrored"
    );
    assert_eq!(
        inverses(|base, index| digits(base, index).iter().fold(0.0, |sum, d| sum * f64::from(base) + *d as f64)),
        "no-point"
    );
    assert_eq!(inverses(|base, index| radical_inverse(base, index) * f64::from(base)), "one-place-late");
    assert_eq!(inverses(|base, index| radical_inverse(base, index) / f64::from(base)), "one-place-early");
    assert_eq!(inverses(|base, index| radical_inverse(base, index.saturating_add(1))), "next-index");
    assert_eq!(inverses(|_, index| radical_inverse(2, index)), "always-base-2");
    assert_eq!(inverses(|base, index| (index % u64::from(base)) as f64 / f64::from(base)), "last-digit-only");
    assert_eq!(inverses(|base, index| 1.0 - radical_inverse(base, index)), "wrong-inverse");
    assert_eq!(inverses(|_, _| f64::NAN), "wrong-inverse");
    assert_eq!(inverses(|base, index| behind_the_point(base, &digits(base, index))), "rounded-to-one");
}

#[test]
fn wrong_for_large_indices() {
    assert_eq!(inverses(|base, index| radical_inverse(base, index & 0xffff_ffff)), "large-index");
    assert_eq!(
        inverses(|base, index| if index < 300 {
            radical_inverse(base, index)
        } else {
            f64::from(radical_inverse(base, index) as f32 - f32::EPSILON)
        }),
        "large-index"
    );
    assert_eq!(
        inverses(|base, index| {
            let digits = digits(base, index);
            behind_the_point(base, &digits[..digits.len().min(10)])
        }),
        "large-index"
    );
}

#[test]
fn wrong_points() {
    assert_eq!(points(|index| [radical_inverse(2, index); 2]), "on-the-diagonal");
    assert_eq!(points(|index| [radical_inverse(3, index), radical_inverse(2, index)]), "axes-swapped");
    assert_eq!(points(|index| [2, 3].map(|base| radical_inverse(base, index.saturating_add(1)))), "next-point");
    assert_eq!(points(|index| [2, 4].map(|base| radical_inverse(base, index))), "common-divisor");
    assert_eq!(points(|index| [radical_inverse(2, index), radical_inverse(3, index + 7)]), "wrong-points");
    assert_eq!(points(|index| [2, 5].map(|base| radical_inverse(base, index))), "wrong-points");
    // Right for small indices only.
    assert_eq!(points(|index| [2, 3].map(|base| radical_inverse(base, index & 0xffff_ffff))), "wrong-points");
}

#[test]
fn a_message_tells_the_slope() {
    let message = check(Answer { halton: |index| [radical_inverse(2, index); 2], ..RIGHT }).unwrap_err().to_string();
    assert!(message.contains("`halton(1)`, and means of e^(x + y) over 16 to 4096 points"), "{message}");
    assert!(message.contains("(0.5, 0.5); the error falls with the slope"), "{message}");
    assert!(message.contains("(0.5, 0.333333); the error falls with the slope −0."), "{message}");
}
