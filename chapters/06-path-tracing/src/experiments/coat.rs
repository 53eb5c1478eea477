//! A closed ball with a matte wall under a smooth clear coat, in closed form.

use whitted::fresnel;

/// The share `F` that a coat of this index mirrors.
#[must_use]
pub fn reflectance(index: f32, cosine: f64) -> f64 {
    #[expect(clippy::cast_possible_truncation, reason = "Fresnel's equations are computed in f32")]
    let cosine = cosine as f32;
    fresnel::exact(cosine, index, 0.0).into()
}

/// `G = ∫ 2 cosθ sinθ / (1 − F) dθ`: what the matte part gets from all mirrorings of the light 1 that it sends out itself.
#[must_use]
pub fn gathered(index: f32) -> f64 {
    const STEPS: u32 = 100_000;
    let integrand = |cosine: f64| 2.0 * cosine / (1.0 - reflectance(index, cosine));
    (0..STEPS).map(|i| integrand((f64::from(i) + 0.5) / f64::from(STEPS))).sum::<f64>() / f64::from(STEPS)
}
