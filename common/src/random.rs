//! Random numbers: a stream of its own for every pixel and sample.

use rand::{Rng as _, SeedableRng as _};
use rand_pcg::Pcg32;

/// A stream of random numbers that depends on (seed, pixel, sample) and on nothing else.
///
/// So a picture does not depend on how many threads computed it, nor in which order.
#[derive(Clone, Debug)]
pub struct Stream(Pcg32);

impl Stream {
    /// The stream of one sample of one pixel.
    ///
    /// The three numbers are hashed, because streams of neighboring generator states look alike: they draw
    /// visible streaks over a picture.
    #[must_use]
    #[inline]
    pub fn new(seed: u64, pixel: u64, sample: u64) -> Self {
        let hash = mix(mix(mix(seed).wrapping_add(pixel)).wrapping_add(sample));
        Self(Pcg32::seed_from_u64(hash))
    }

    /// A number of the uniform distribution over `[0, 1)`: a multiple of 2⁻²⁴, the finest step that f32 has near 1.
    #[inline]
    pub fn uniform(&mut self) -> f32 {
        const STEP: f32 = 1.0 / (1 << 24) as f32;
        #[expect(clippy::cast_precision_loss, reason = "24 bits fit an f32 exactly")]
        let numerator = (self.0.next_u32() >> 8) as f32;
        numerator * STEP
    }
}

/// The output function of SplitMix64: every input bit changes about half of the output bits.
///
/// Source: Steele, Lea, Flood, *Fast Splittable Pseudorandom Number Generators*, OOPSLA 2014, figure 16.
fn mix(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn same_address_same_numbers() {
        let draw = |seed, pixel, sample| Stream::new(seed, pixel, sample).uniform().to_bits();
        assert_eq!(draw(1, 2, 3), draw(1, 2, 3));
        assert_ne!(draw(1, 2, 3), draw(2, 2, 3));
        assert_ne!(draw(1, 2, 3), draw(1, 3, 3));
        assert_ne!(draw(1, 2, 3), draw(1, 2, 4));
        // Pinned: another generator or hash would change every picture that uses chance.
        assert_eq!(draw(1, 2, 3), 0x3f52_ec0d, "{:#x}", draw(1, 2, 3));
    }
    /// χ² of 256 bins over first numbers of neighboring pixels: 255 ± 22.6 expected, five sigma allowed.
    #[test]
    fn first_numbers_of_neighbors_are_uniform_and_uncorrelated() {
        const COUNT: u64 = 256 * 1000;
        let mut bins = [0_u32; 256];
        let (mut previous, mut product) = (0.0, 0.0);
        for pixel in 0..COUNT {
            let u = f64::from(Stream::new(7, pixel, 0).uniform());
            assert!((0.0..1.0).contains(&u));
            bins[(u * 256.0) as usize] += 1;
            product += (u - 0.5) * previous;
            previous = u - 0.5;
        }
        let chi_square: f64 = bins.iter().map(|&n| (f64::from(n) - 1000.0) * (f64::from(n) - 1000.0) / 1000.0).sum();
        assert!((chi_square - 255.0).abs() < 5.0 * 22.6, "{chi_square}");
        // The correlation of independent numbers has standard deviation 1/√n.
        let correlation = product / COUNT as f64 * 12.0;
        assert!(correlation.abs() < 5.0 / (COUNT as f64).sqrt(), "{correlation}");
    }
}
