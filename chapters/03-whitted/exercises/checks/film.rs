//! A soap film and the light that meets it, wave by wave: the right answer to exercise 3.5.

use std::f64::consts::PI;

use super::words;

/// A film and the light that meets it.
#[derive(Clone, Copy)]
pub(super) struct Question {
    pub(super) cosine: f64,
    pub(super) index: f64,
    pub(super) thickness: f64,
    pub(super) wavelength: f64,
}

#[allow(clippy::disallowed_methods, reason = "the platform's functions are the second opinion here")]
pub(super) fn cos(x: f64) -> f64 {
    x.cos()
}

#[allow(clippy::disallowed_methods, reason = "the platform's functions are the second opinion here")]
fn sin(x: f64) -> f64 {
    x.sin()
}

impl Question {
    pub(super) fn inside(&self) -> f64 {
        (1.0 - (1.0 - self.cosine * self.cosine) / (self.index * self.index)).sqrt()
    }

    pub(super) fn phase(&self) -> f64 {
        4.0 * PI * self.index * self.thickness * self.inside() / self.wavelength
    }

    /// Amplitudes across and along.
    pub(super) fn amplitudes(&self) -> [f64; 2] {
        self.amplitudes_by(self.inside())
    }

    /// The same for this cosine inside.
    pub(super) fn amplitudes_by(&self, i: f64) -> [f64; 2] {
        let (c, n) = (self.cosine, self.index);
        [(c - n * i) / (c + n * i), (n * c - i) / (n * c + i)]
    }

    /// The cosine inside by Snell's law turned over; no number for most angles.
    pub(super) fn reversed(&self) -> f64 {
        (1.0 - (1.0 - self.cosine * self.cosine) * self.index * self.index).sqrt()
    }

    /// The reflectance for this cosine inside.
    pub(super) fn by(&self, inside: f64) -> f64 {
        let phase = self.phase() / self.inside() * inside;
        self.amplitudes_by(inside).map(|r| airy(r * r, cos(phase))).iter().sum::<f64>() / 2.0
    }

    /// The mean over both polarizations.
    pub(super) fn mean(&self, one: impl Fn(f64) -> f64) -> f64 {
        self.amplitudes().map(one).iter().sum::<f64>() / 2.0
    }

    /// The right reflectance, wave by wave instead of by a formula.
    pub(super) fn right(&self) -> f64 {
        self.with(self.phase())
    }

    pub(super) fn with(&self, phase: f64) -> f64 {
        self.mean(|r| waves(r, phase, WAVES))
    }

    pub(super) fn words(&self) -> String {
        let Self { cosine, index, thickness, wavelength } = self;
        let [cosine, index] = [cosine, index].map(|x| words::number(*x));
        format!("`reflectance` with cos θ = {cosine}, n = {index}, d = {thickness} nm, λ = {wavelength} nm")
    }
}

/// The squared magnitude of the sum of the first reflection and of `count` later ones.
pub(super) fn waves(r: f64, phase: f64, count: u32) -> f64 {
    let (mut re, mut im) = (r, 0.0);
    let (mut size, mut angle) = ((1.0 - r * r) * r, phase);
    for _ in 0..count {
        re -= size * cos(angle);
        im -= size * sin(angle);
        size *= r * r;
        angle += phase;
    }
    re * re + im * im
}

/// By Airy's formula.
pub(super) fn airy(r2: f64, cos: f64) -> f64 {
    quotient(r2, [-1.0, -1.0], cos)
}

/// The same with these signs before the cosine, above and below.
pub(super) fn quotient(r2: f64, [above, below]: [f64; 2], cos: f64) -> f64 {
    2.0 * r2 * (1.0 + above * cos) / (1.0 + r2 * r2 + below * 2.0 * r2 * cos)
}

/// So many waves are as good as all of them.
pub(super) const WAVES: u32 = 400;
