//! Likely mistakes in the reflectance of a soap film, by what comes out.

use super::{
    film::{Question, WAVES, airy, cos, quotient, waves},
    words,
};

/// What was asked, and what came out.
pub(super) struct Answered {
    pub(super) question: Question,
    pub(super) got: f64,
}

pub(super) fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() < 3e-4 || (!a.is_finite() && !b.is_finite())
}

/// How many answers a mistake must explain before it is called by its name: one alone may agree by chance.
const ENOUGH: usize = 30;

/// A likely mistake: its name, what to say about it, and what comes out.
type Rival = (&'static str, &'static str, fn(&Question) -> f64);

/// The likely mistake behind wrong reflectances, the first of them `got`.
pub(super) fn named(answers: &[Answered], wrong: &Question, got: f64) -> (&'static str, String) {
    let explains = |formula: fn(&Question) -> f64| {
        is_near(got, formula(wrong)) && answers.iter().take(ENOUGH).all(|a| is_near(a.got, formula(&a.question)))
    };
    if let Some((name, advice, _)) = RIVALS.iter().find(|(.., formula)| explains(*formula)) {
        return (name, (*advice).into());
    }
    if got.is_nan() {
        return ("not-a-number", "This is no number: was a root taken of something negative?".into());
    }
    let [across, along] = wrong.amplitudes().map(words::number);
    let [inside, phase] = [wrong.inside(), wrong.phase()].map(words::number);
    let advice = format!(
        "Compare step by step: here cos θ_t is {inside}, r is {across} across and {along} along, and δ is {phase}. If all of \
         these are yours, too, the mistake is in the sum of the waves."
    );
    ("wrong-reflectance", advice)
}

const RIVALS: &[Rival] = &[
    (
        "flip-forgotten",
        "The front reflects r from outside, but −r from inside: between the first wave and the others is a minus. With it a \
         film without thickness is black, without it such a film would be bright.",
        |q| q.mean(|r| airy(r * r, -cos(q.phase()))),
    ),
    ("one-way", "The waves cross the film to and fro, twice its thickness: 4π, not 2π.", |q| q.with(q.phase() / 2.0)),
    ("index-forgotten", "In the film waves are shorter by n, so that the phase grows n times as fast.", |q| {
        q.with(q.phase() / q.index)
    }),
    ("cosine-forgotten", "The phase depends on the angle as well: δ = 4π n d cos θ_t / λ.", |q| {
        q.with(q.phase() / q.inside())
    }),
    ("cosine-outside", "The cosine in the phase is that inside the film, θ_t.", |q| {
        q.with(q.phase() / q.inside() * q.cosine)
    }),
    (
        "cosine-divides",
        "At an angle the way through the film is longer, but the first wave travels farther, too, until both come together. \
         What is left is cos θ_t as a factor.",
        |q| q.with(q.phase() / (q.inside() * q.inside())),
    ),
    ("degrees", "`common::float::cos` takes radians, which δ is in: there is nothing to convert.", |q| {
        q.with(q.phase().to_degrees())
    }),
    ("degrees", "`common::float::cos` takes radians, which δ is in: there is nothing to convert.", |q| {
        q.with(q.phase().to_radians())
    }),
    (
        "snell-reversed",
        "Snell's law is turned over: sin θ = n sin θ_t, so that the sine is smaller inside the film, and not greater.",
        |q| q.by(q.reversed()),
    ),
    ("two-waves", TWO_WAVES, |q| q.mean(|r| waves(r, q.phase(), 1))),
    ("two-waves", TWO_WAVES, |q| q.mean(|r| 2.0 * r * r * (1.0 - cos(q.phase())))),
    (
        "numerator-sign",
        "In the numerator the sign before cos δ is wrong: without thickness δ is 0, and nothing is reflected.",
        |q| q.mean(|r| quotient(r * r, [1.0, -1.0], cos(q.phase()))),
    ),
    (
        "denominator-sign",
        "In the denominator the sign before cos δ is wrong: it is the squared magnitude of 1 − r² e^(iδ).",
        |q| q.mean(|r| quotient(r * r, [-1.0, 1.0], cos(q.phase()))),
    ),
    ("no-interference", "This is the reflectance of the front alone. The other waves come on top.", |q| {
        q.mean(|r| r * r)
    }),
    (
        "no-interference",
        "Here the waves' powers are added. Add their amplitudes, with phases, and square the sum.",
        |q| q.mean(|r| 2.0 * r * r / (1.0 + r * r)),
    ),
    ("one-polarization", ONE, |q| airy(q.amplitudes()[0] * q.amplitudes()[0], cos(q.phase()))),
    ("one-polarization", ONE, |q| airy(q.amplitudes()[1] * q.amplitudes()[1], cos(q.phase()))),
    ("mean-too-early", TOO_EARLY, |q| airy(q.mean(|r| r * r), cos(q.phase()))),
    ("mean-too-early", TOO_EARLY, |q| airy(q.mean(|r| r) * q.mean(|r| r), cos(q.phase()))),
    ("sum-not-mean", "Unpolarized light is half and half: take the mean of across and along, not their sum.", |q| {
        2.0 * q.right()
    }),
    ("not-squared", "This is the magnitude of the amplitude. The reflectance is its square.", |q| {
        q.mean(|r| waves(r, q.phase(), WAVES).sqrt())
    }),
    ("amplitude-for-its-square", SQUARE, |q| q.mean(|r| airy(r.abs(), cos(q.phase())))),
    ("amplitude-for-its-square", SQUARE, |q| q.mean(|r| airy(r, cos(q.phase())))),
    ("amplitude-for-its-square", SQUARE, |q| q.mean(|r| airy(r * r, cos(q.phase())) / r)),
    ("transmitted", "This is what goes through. The reflectance is the rest.", |q| 1.0 - q.right()),
];

const TWO_WAVES: &str = "These are the first two waves only. Sum the whole series: 1 + q + q² + … = 1 / (1 − q).";
const ONE: &str = "This is one of the two polarizations. Take the mean of both.";
const TOO_EARLY: &str = "Take the mean over the two polarizations in the end: each of them interferes by itself.";
const SQUARE: &str = "Somewhere the amplitude r stands where its square r² should.";
