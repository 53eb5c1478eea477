//! Colors: linear RGB inside, sRGB only on the way out.

use glam::Vec3;

use crate::float;

/// Linear RGB (primaries and white point of sRGB), red in `x`, green in `y`, blue in `z`.
///
/// Used for radiance (any non-negative number) and for reflectances (0 to 1).
pub type Rgb = Vec3;

/// Relative luminance of linear RGB: how bright it looks. Source: ITU-R BT.709-6, section 3.2.
#[must_use]
pub fn luminance(color: Rgb) -> f32 {
    color.dot(Vec3::new(0.2126, 0.7152, 0.0722))
}

// ANCHOR: srgb_encode
/// Encode one linear channel for a screen, both in `[0, 1]`.
///
/// Source: IEC 61966-2-1 (sRGB). A straight line near black, then a power curve.
#[must_use]
pub fn srgb_encode(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * float::pow(linear, 1.0 / 2.4) - 0.055 }
}
// ANCHOR_END: srgb_encode

/// The inverse of [`srgb_encode`].
#[must_use]
pub fn srgb_decode(encoded: f32) -> f32 {
    if encoded <= 0.040_45 { encoded / 12.92 } else { float::pow((encoded + 0.055) / 1.055, 2.4) }
}

/// A linear color from the sRGB numbers 0 to 255 of a color picker.
#[must_use]
pub fn srgb(red: u8, green: u8, blue: u8) -> Rgb {
    Rgb::from_array([red, green, blue].map(|c| srgb_decode(f32::from(c) / 255.0)))
}

/// One linear channel as the byte of a PNG: clamped to `[0, 1]`, encoded, rounded to nearest. NaN gives 0.
#[must_use]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the value is in 0 to 255.5 by then")]
pub fn to_byte(linear: f32) -> u8 {
    (srgb_encode(linear.clamp(0.0, 1.0)) * 255.0 + 0.5) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_fixed_points_and_round_trip() {
        // Values from the sRGB standard's own formula: 50 % gray on screen is 21.4 % of the light.
        assert!((srgb_decode(0.5) - 0.214_041).abs() < 1e-6);
        assert!((srgb_encode(0.214_041) - 0.5).abs() < 1e-6);
        for byte in 0..=255_u8 {
            assert_eq!(to_byte(srgb(byte, 0, 0).x), byte);
        }
    }

    #[test]
    fn bytes_clamp() {
        assert_eq!([-1.0, 0.0, 1.0, 7.0, f32::INFINITY, f32::NAN].map(to_byte), [0, 0, 255, 255, 255, 0]);
    }

    #[test]
    fn white_has_luminance_one() {
        assert!((luminance(Rgb::ONE) - 1.0).abs() < 1e-6);
        assert!(luminance(Rgb::Y) > luminance(Rgb::X) && luminance(Rgb::X) > luminance(Rgb::Z));
    }
}
