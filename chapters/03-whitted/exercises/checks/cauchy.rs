//! Checks the first function of exercise 3.3, Cauchy's formula.

use common::exercise::{Finding, Verdict, trying};

use super::words;

/// Accept the formula, or name what is wrong with it.
pub(super) fn cauchy(answer: fn(f32, f32, f32) -> f32) -> Verdict {
    for (a, b, nanometers) in [
        (1.728, 0.01342, 550.0),
        (1.5046, 0.0042, 450.0),
        (1.458, 0.00354, 650.0),
        (2.378, 0.0121, 400.0),
        (1.6, 0.0, 500.0),
    ] {
        let tried = format!("`cauchy` with A = {a}, B = {b} µm², λ = {nanometers} nm");
        let got = f64::from(trying(|| tried.clone(), || answer(a, b, nanometers)));
        let [a, b, nm] = [a, b, nanometers].map(f64::from);
        let micro = nm / 1000.0;
        let right = a + b / (micro * micro);
        if (got - right).abs() < 1e-5 {
            continue;
        }
        let is = |x: f64| (got - x).abs() < 1e-5 * x.abs().max(1.0);
        let (name, advice) = if got.is_nan() {
            ("not-a-number", "This is no number. Was zero divided by zero?")
        } else if got == 1.0 {
            ("cauchy-not-started", "`cauchy` answers 1, which is the index of empty space.")
        } else if is(a + b / (nm * nm)) {
            (
                "nanometers",
                "This is A, and next to nothing besides. Either the second term is missing, or the number below it is far too \
                 great: B counts in µm², so that 550 nm count as 0.55.",
            )
        } else if is(a + b * 1e3 / (nm * nm)) || is(a + b / (micro * nm)) {
            ("nanometers", "The wavelength is squared after it was turned into micrometers, not before.")
        } else if is(b / (micro * micro)) {
            ("a-missing", "This is the second term alone. A is missing.")
        } else if is(a + b * 1e12 / (nm * nm)) || is(a + b * 1e18 / (nm * nm)) {
            (
                "wrong-unit",
                "The wavelength is far too small a number here. 1 µm is 1000 nm, so that 550 nm are 0.55 µm.",
            )
        } else if is(a + b / micro) {
            ("not-squared", "Divide by the square of the wavelength.")
        } else if is(a + b * micro * micro) {
            (
                "multiplied",
                "Divide B by the square of the wavelength: blue light, of short waves, is bent more than red.",
            )
        } else if is(a - b / (micro * micro)) {
            ("minus", "Add the second term: the shorter the wave, the greater the index.")
        } else if is(b + a / (micro * micro)) {
            ("swapped", "A and B have changed places.")
        } else {
            ("wrong-index", "Work this out on paper: λ in micrometers, then A + B / λ².")
        };
        let (got, expected) = (words::number(got), words::number(right));
        return Err(Finding { tried, got, expected, advice: advice.into() }.named(name));
    }
    Ok(())
}
