//! Russian roulette: chance chooses the kind of reflection, and the end of the path.

use common::{Rgb, Stream, color::luminance};

// ANCHOR: chances
/// How likely each kind of reflection is. With the rest of the probability the path ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chances {
    /// `s_d`: of a diffuse reflection, 0 to 1.
    pub diffuse: f32,
    /// `s_m`: of a mirror reflection, 0 to 1. The sum of both is at most 1.
    pub mirror: f32,
}

/// A kind of reflection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Into any direction above the surface.
    Diffuse,
    /// Into the mirror direction.
    Mirror,
}

impl Chances {
    /// `s_d = luminance(k_d π)` and `s_m = luminance(F)`, from the albedo `k_d π` and the reflectance `F`.
    ///
    /// A coated surface can have a sum above 1, when seen at a flat angle. Both are scaled down then: the expected value
    /// stays the same, as the result is divided by whatever the probability was.
    #[must_use]
    #[inline]
    pub fn of(albedo: Rgb, reflectance: Rgb) -> Self {
        let [diffuse, mirror] = [albedo, reflectance].map(luminance);
        let sum = (diffuse + mirror).max(1.0);
        Self { diffuse: diffuse / sum, mirror: mirror / sum }
    }

    /// The same without an end: in the same proportion, and with the sum 1. A black surface ends every path.
    #[must_use]
    #[inline]
    pub fn without_end(self) -> Self {
        let sum = self.diffuse + self.mirror;
        if sum > 0.0 {
            let diffuse = self.diffuse / sum;
            Self { diffuse, mirror: 1.0 - diffuse }
        } else {
            self
        }
    }

    /// Draw a kind of reflection, with its probability; `None` ends the path.
    ///
    /// Where there is no choice no random number is drawn.
    #[inline]
    pub fn choose(self, random: &mut Stream) -> Option<(Kind, f32)> {
        let u = if self.diffuse >= 1.0 { 0.0 } else { random.uniform() };
        if u < self.diffuse {
            Some((Kind::Diffuse, self.diffuse))
        } else if u < self.diffuse + self.mirror {
            Some((Kind::Mirror, self.mirror))
        } else {
            None
        }
    }
}
// ANCHOR_END: chances

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sum_is_at_most_one() {
        let gray = |d, m| Chances::of(Rgb::splat(d), Rgb::splat(m));
        let close = |a: Chances, [d, m]: [f32; 2]| (a.diffuse - d).abs() < 1e-6 && (a.mirror - m).abs() < 1e-6;
        assert!(close(gray(0.5, 0.25), [0.5, 0.25]));
        assert!(close(gray(0.9, 0.9), [0.5, 0.5]));
        assert!(close(gray(0.5, 0.25).without_end(), [2.0 / 3.0, 1.0 / 3.0]));
        assert_eq!(gray(0.0, 0.0).without_end(), Chances { diffuse: 0.0, mirror: 0.0 });
    }

    #[test]
    fn each_kind_comes_as_often_as_it_should() {
        let chances = Chances { diffuse: 0.5, mirror: 0.2 };
        let mut random = Stream::new(1, 0, 0);
        let mut counts = [0_i32; 3];
        for _ in 0..100_000 {
            let drawn = chances.choose(&mut random);
            counts[match drawn {
                Some((Kind::Diffuse, p)) => usize::from(p != 0.5) * 9,
                Some((Kind::Mirror, p)) => 1 + usize::from(p != 0.2) * 9,
                None => 2,
            }] += 1;
        }
        // Standard deviations are below 160.
        for (count, expected) in counts.into_iter().zip([50_000, 20_000, 30_000]) {
            assert!((count - expected).abs() < 600, "{counts:?}");
        }
    }

    #[test]
    fn without_end_nothing_ends() {
        let mut random = Stream::new(2, 0, 0);
        for i in 0..1000_u16 {
            let chances = Chances::of(Rgb::splat(f32::from(i) / 999.0), Rgb::splat(0.01)).without_end();
            assert!((0..100).all(|_| chances.choose(&mut random).is_some()), "{chances:?}");
        }
    }
}
