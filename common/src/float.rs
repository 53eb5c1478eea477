//! Transcendental functions with the same bits on every machine.
//!
//! IEEE 754 fixes `+ − × ÷ sqrt` to the last bit, but not `sin`, `cos`, `powf` and their kin: the standard library
//! hands those to the platform. These come from the crate `libm`, which is plain Rust and so the same everywhere.
//! The lint `clippy::disallowed_methods` keeps the others out (see `clippy.toml`).

/// Sine of an angle in radians.
#[must_use]
pub fn sin(radians: f32) -> f32 {
    libm::sinf(radians)
}

/// Cosine of an angle in radians.
#[must_use]
pub fn cos(radians: f32) -> f32 {
    libm::cosf(radians)
}

/// Sine and cosine of an angle in radians, together: the same bits in less time.
#[must_use]
#[inline]
pub fn sin_cos(radians: f32) -> (f32, f32) {
    libm::sincosf(radians)
}

/// Tangent of an angle in radians.
#[must_use]
pub fn tan(radians: f32) -> f32 {
    libm::tanf(radians)
}

/// Tangent of an angle in radians, in double precision.
#[must_use]
pub fn tan_f64(radians: f64) -> f64 {
    libm::tan(radians)
}

/// Sine of an angle in radians, in double precision.
#[must_use]
pub fn sin_f64(radians: f64) -> f64 {
    libm::sin(radians)
}

/// Cosine of an angle in radians, in double precision.
#[must_use]
pub fn cos_f64(radians: f64) -> f64 {
    libm::cos(radians)
}

/// e to the power of `x`, in double precision.
#[must_use]
pub fn exp_f64(x: f64) -> f64 {
    libm::exp(x)
}

/// Natural logarithm of `x`, in double precision.
#[must_use]
pub fn ln_f64(x: f64) -> f64 {
    libm::log(x)
}

/// The angle in radians, in `[0, π]`, whose cosine is `x`; NaN outside `[-1, 1]`.
#[must_use]
pub fn acos(x: f32) -> f32 {
    libm::acosf(x)
}

/// The angle in radians, in `(-π, π]`, of the point (`x`, `y`).
#[must_use]
pub fn atan2(y: f32, x: f32) -> f32 {
    libm::atan2f(y, x)
}

/// `base` to the power of `exponent`.
#[must_use]
pub fn pow(base: f32, exponent: f32) -> f32 {
    libm::powf(base, exponent)
}

/// e to the power of `x`.
#[must_use]
pub fn exp(x: f32) -> f32 {
    libm::expf(x)
}

/// Natural logarithm of `x`.
#[must_use]
pub fn ln(x: f32) -> f32 {
    libm::logf(x)
}

/// 2 to the power of `x`.
#[must_use]
pub fn exp2(x: f32) -> f32 {
    libm::exp2f(x)
}

/// Cube root of `x`, of either sign.
#[must_use]
pub fn cbrt(x: f32) -> f32 {
    libm::cbrtf(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The hexadecimal bits were computed once on x86-64; any machine that disagrees breaks the snapshots.
    #[test]
    fn bits_are_pinned() {
        let x = 0.7_f32;
        let bits = [sin(x), cos(x), tan(x), acos(x), atan2(x, -2.0), pow(x, 2.2), exp(x), ln(x), exp2(x), cbrt(x)]
            .map(f32::to_bits);
        assert_eq!(
            bits,
            [
                0x3f24_eb73,
                0x3f43_ccb3,
                0x3f57_a036,
                0x3f4b_9f42,
                0x4033_83c6,
                0x3ee9_9b5c,
                0x4000_e153,
                0xbeb6_9e1a,
                0x3fcf_efc6,
                0x3f63_4dad
            ],
            "{bits:#x?}"
        );
    }

    #[test]
    fn sine_and_cosine_together_have_the_bits_of_each_alone() {
        for x in (0..=u32::MAX).step_by(65_537).map(f32::from_bits).filter(|x| x.is_finite()) {
            let ((together_sin, together_cos), alone) = (sin_cos(x), [sin(x), cos(x)].map(f32::to_bits));
            assert_eq!([together_sin, together_cos].map(f32::to_bits), alone, "{x}");
        }
    }

    #[test]
    #[allow(clippy::disallowed_methods, reason = "the platform's functions are the second opinion here")]
    fn agrees_with_the_platform() {
        for i in -100..=100_i16 {
            let x = f32::from(i) / 13.0;
            let pairs = [(sin(x), x.sin()), (cos(x), x.cos()), (exp(x), x.exp()), (cbrt(x), x.cbrt())];
            for (ours, theirs) in pairs {
                assert!(
                    (ours - theirs).abs() <= 2.0 * f32::EPSILON * theirs.abs().max(1.0),
                    "x = {x}: {ours} {theirs}"
                );
            }
        }
    }
}
