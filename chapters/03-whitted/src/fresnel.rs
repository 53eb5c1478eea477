//! Fresnel's equations: which share of the light a smooth surface reflects.

// ANCHOR: exact
/// The share of unpolarized light that a smooth surface reflects, when light comes in at an angle with this cosine.
///
/// `n` is the refractive index of the medium behind the surface divided by that of the medium before it, `kappa` the
/// extinction coefficient behind it: zero for glass and water, above zero for metals. Beyond the critical angle
/// everything is reflected: 1.
///
/// Source: Born, Wolf, *Principles of Optics*, chapter 14 (optics of metals).
#[must_use]
pub fn exact(cosine: f32, n: f32, kappa: f32) -> f32 {
    if cosine <= 0.0 {
        return 1.0;
    }
    let sine2 = 1.0 - cosine * cosine;
    // The index is the complex number n + iκ. Times the cosine behind the surface it is a + ib = √((n + iκ)² − sin² θ).
    let (a, b) = complex_sqrt(n * n - kappa * kappa - sine2, 2.0 * n * kappa);
    let b2 = b * b;
    // Light that swings along the surface.
    let across = (square(cosine - a) + b2) / (square(cosine + a) + b2);
    // Light that swings in the plane of the ray and the normal.
    let along = across * (square(a * cosine - sine2) + b2 * cosine * cosine)
        / (square(a * cosine + sine2) + b2 * cosine * cosine);
    // Unpolarized light is half and half.
    (across + along) / 2.0
}

/// Real and imaginary part of `√(re + i im)` for `im ≥ 0`, both at least zero.
fn complex_sqrt(re: f32, im: f32) -> (f32, f32) {
    // The greater part of the two has no cancellation; the other one follows from 2ab = im.
    let greater = ((re.abs() + (re * re + im * im).sqrt()) / 2.0).sqrt();
    let smaller = if greater > 0.0 { im / (2.0 * greater) } else { 0.0 };
    if re >= 0.0 { (greater, smaller) } else { (smaller, greater) }
}
// ANCHOR_END: exact

// ANCHOR: approximation
/// The share that is reflected of light that falls in along the normal: `((n − 1)² + κ²) / ((n + 1)² + κ²)`.
#[must_use]
pub fn at_normal_incidence(n: f32, kappa: f32) -> f32 {
    (square(n - 1.0) + kappa * kappa) / (square(n + 1.0) + kappa * kappa)
}

/// `F0 + (1 − F0)(1 − cos θ)⁵`, which is near Fresnel's equations and needs no square root. At a border of glass and
/// air θ is the angle in the air, whichever way the light goes.
///
/// Source: Schlick, *An Inexpensive BRDF Model for Physically-based Rendering*, Computer Graphics Forum 13(3), 1994.
#[must_use]
pub fn approximate(cosine: f32, f0: f32) -> f32 {
    let away = (1.0 - cosine).clamp(0.0, 1.0);
    f0 + (1.0 - f0) * square(square(away)) * away
}
// ANCHOR_END: approximation

fn square(x: f32) -> f32 {
    x * x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        // Glass along the normal: (0.5/2.5)² = 4 %. At Brewster's angle, tan θ = 1.5, half of ((n²−1)/(n²+1))².
        assert!((exact(1.0, 1.5, 0.0) - 0.04).abs() < 1e-7);
        let brewster = 1.0 / (1.0_f32 + 2.25).sqrt();
        assert!((exact(brewster, 1.5, 0.0) - 0.5 * square(1.25 / 3.25)).abs() < 1e-6);
        assert_eq!(exact(0.0, 1.5, 0.0), 1.0);
        // From inside, beyond the critical angle of 41.8°.
        assert!((exact(0.7, 1.0 / 1.5, 0.0) - 1.0).abs() < 1e-6);
        assert_eq!(at_normal_incidence(1.5, 0.0), 0.04);
        assert_eq!((approximate(1.0, 0.04), approximate(0.0, 0.04)), (0.04, 1.0));
    }
}
