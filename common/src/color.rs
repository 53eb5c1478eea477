//! Colors: linear RGB inside, sRGB only on the way out.

use glam::Vec3;

use crate::float;

/// Linear RGB (primaries and white point of sRGB), red in `x`, green in `y`, blue in `z`.
///
/// Used for radiance (any non-negative number) and for reflectances (0 to 1).
pub type Rgb = Vec3;

/// Relative luminance of linear RGB: how bright it looks. Source: ITU-R BT.709-6, section 3.2.
#[must_use]
#[inline]
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

/// The color at `share`, from 0 to 1, of the way along colors that stand at equal distances; black without any.
#[must_use]
pub fn gradient(colors: &[Rgb], share: f32) -> Rgb {
    let last = colors.len().saturating_sub(1);
    let at = share.clamp(0.0, 1.0) * last as f32;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to the last")]
    let step = (at as usize).min(last.saturating_sub(1));
    let color = |i: usize| colors.get(i).or(colors.last()).copied().unwrap_or(Rgb::ZERO);
    color(step).lerp(color(step + 1), at - step as f32)
}

/// One linear channel as the byte of a PNG: clamped to `[0, 1]`, encoded, rounded to nearest. NaN gives 0.
#[must_use]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the value is in 0 to 255.5 by then")]
pub fn to_byte(linear: f32) -> u8 {
    (srgb_encode(linear.clamp(0.0, 1.0)) * 255.0 + 0.5) as u8
}

/// [`to_byte`] for many channels at once: the same bytes, several times as fast.
///
/// The encoding grows with its argument, so each byte has a least linear value, and finding a byte among those takes no
/// power.
#[derive(Clone, Debug)]
pub struct ByteTable {
    /// For the bytes 1 to 255 the least linear value that is encoded so.
    least: [f32; 255],
}

impl ByteTable {
    /// The table, made by asking [`to_byte`].
    #[must_use]
    pub fn new() -> Self {
        let mut least = [0.0; 255];
        for (value, byte) in least.iter_mut().zip(1_u8..=255) {
            // Floats from 0 to 1 are in the order of their bits: halve the interval of bits until it is empty.
            let (mut below, mut at_least) = (0_f32.to_bits(), 1_f32.to_bits());
            while below + 1 < at_least {
                let middle = below.midpoint(at_least);
                if to_byte(f32::from_bits(middle)) < byte {
                    below = middle;
                } else {
                    at_least = middle;
                }
            }
            *value = f32::from_bits(at_least);
        }
        Self { least }
    }

    /// The same as [`to_byte`].
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "at most 255 values")]
    pub fn to_byte(&self, linear: f32) -> u8 {
        self.least.partition_point(|&least| least <= linear) as u8
    }
}

impl Default for ByteTable {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gradient_meets_its_colors_and_runs_straight_between_them() {
        let colors = [Rgb::ZERO, Rgb::ONE, Rgb::X];
        let at = |share| gradient(&colors, share);
        assert_eq!([-1.0, 0.0, 0.5, 1.0, 9.0].map(at), [Rgb::ZERO, Rgb::ZERO, Rgb::ONE, Rgb::X, Rgb::X]);
        assert_eq!(at(0.25), Rgb::splat(0.5));
        assert_eq!((gradient(&[], 0.3), gradient(&[Rgb::Y], 0.3)), (Rgb::ZERO, Rgb::Y));
    }

    #[test]
    fn the_table_gives_the_same_bytes() {
        let table = ByteTable::new();
        let mut random = crate::random::Stream::new(0, 0, 0);
        for _ in 0..100_000 {
            let linear = random.uniform() * 1.1 - 0.05;
            assert_eq!(table.to_byte(linear), to_byte(linear), "{linear}");
        }
        // On both sides of every step.
        for least in table.least {
            for linear in [least.next_down(), least, least.next_up()] {
                assert_eq!(table.to_byte(linear), to_byte(linear), "{linear}");
            }
        }
        for linear in [0.0, -0.0, 1.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN] {
            assert_eq!(table.to_byte(linear), to_byte(linear), "{linear}");
        }
    }

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
