//! The material of chapter 3: rough, reflective and refractive are three properties that add up.

use common::Rgb;
use ray_casting::{hit::Side, material::Phong};

use crate::fresnel;

// ANCHOR: material
/// What a surface is made of. The three properties are independent of each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Scatters light in all directions, as in chapter 1.
    pub rough: Option<Phong>,
    /// Sends a share of the light on in the mirror direction.
    pub reflective: bool,
    /// Lets the rest of the light through.
    pub refractive: bool,
    /// `n`: refractive index of what lies inside, divided by that of what lies outside, for red, green and blue.
    pub index: Rgb,
    /// `κ`: extinction coefficient of what lies inside; zero but for metals.
    pub extinction: Rgb,
}
// ANCHOR_END: material

/// Which formula says how much is reflected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fresnel {
    /// Fresnel's equations.
    Exact,
    /// Schlick's approximation.
    Approximate,
}

impl Material {
    // ANCHOR: kinds
    /// A rough surface that neither mirrors nor lets light through.
    #[must_use]
    pub fn rough(phong: Phong) -> Self {
        Self { rough: Some(phong), reflective: false, refractive: false, index: Rgb::ONE, extinction: Rgb::ZERO }
    }

    /// A polished metal with refractive index `n` and extinction coefficient `κ`.
    #[must_use]
    pub const fn metal(index: Rgb, extinction: Rgb) -> Self {
        Self { rough: None, reflective: true, refractive: false, index, extinction }
    }

    /// A clear medium with the given index, relative to what is around it.
    #[must_use]
    pub const fn glass(index: f32) -> Self {
        Self { rough: None, reflective: true, refractive: true, index: Rgb::splat(index), extinction: Rgb::ZERO }
    }

    /// A rough surface under a clear smooth coat, like porcelain.
    #[must_use]
    pub fn coated(phong: Phong, index: f32) -> Self {
        Self { rough: Some(phong), refractive: false, ..Self::glass(index) }
    }
    // ANCHOR_END: kinds

    // ANCHOR: metals
    /// Gold, by its `n` and `κ` for red, green and blue light.
    pub const GOLD: Self = Self::metal(Rgb::new(0.17, 0.35, 1.5), Rgb::new(3.1, 2.7, 1.9));
    /// Silver.
    pub const SILVER: Self = Self::metal(Rgb::new(0.14, 0.16, 0.13), Rgb::new(4.1, 2.3, 3.1));
    /// Copper.
    pub const COPPER: Self = Self::metal(Rgb::new(0.2, 1.1, 1.2), Rgb::new(3.6, 2.6, 2.3));
    // ANCHOR_END: metals

    // ANCHOR: relative
    /// The index behind the surface divided by the index before it, for a ray that meets it from `side`.
    ///
    /// What lets no light through has no inside to come from: both sides are the same.
    #[must_use]
    pub fn relative_index(&self, side: Side) -> Rgb {
        match side {
            Side::Inside if self.refractive => self.index.recip(),
            _ => self.index,
        }
    }
    // ANCHOR_END: relative

    // ANCHOR: reflectance
    /// `F`: the share of light that is reflected, for each color channel, if the angle between ray and normal has this
    /// cosine.
    #[must_use]
    pub fn reflectance(&self, cosine: f32, side: Side, fresnel: Fresnel) -> Rgb {
        let [n, kappa] = [self.relative_index(side), self.extinction].map(|v| v.to_array());
        let share = |i: usize| match fresnel {
            Fresnel::Exact => fresnel::exact(cosine, n[i], kappa[i]),
            Fresnel::Approximate => {
                let cosine = if self.refractive { cosine_in_thinner(cosine, n[i]) } else { cosine };
                fresnel::approximate(cosine, fresnel::at_normal_incidence(n[i], kappa[i]))
            }
        };
        Rgb::new(share(0), share(1), share(2))
    }
    // ANCHOR_END: reflectance
}

// ANCHOR: thinner
/// The cosine on the side with the smaller index: that of the incoming ray, or that of the refracted one if it leaves a
/// denser medium (`n < 1`). Zero beyond the critical angle.
fn cosine_in_thinner(cosine: f32, n: f32) -> f32 {
    if n >= 1.0 { cosine } else { (1.0 - (1.0 - cosine * cosine) / (n * n)).max(0.0).sqrt() }
}
// ANCHOR_END: thinner

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_side_decides_for_glass_but_not_for_metal() {
        let glass = Material::glass(1.5);
        assert_eq!(glass.relative_index(Side::Outside), Rgb::splat(1.5));
        assert_eq!(glass.relative_index(Side::Inside), Rgb::splat(1.0 / 1.5));
        let [outside, inside] =
            [Side::Outside, Side::Inside].map(|s| Material::GOLD.reflectance(0.5, s, Fresnel::Exact));
        assert_eq!(outside, inside);
        // Gold is gold: red comes back, blue less.
        assert!(outside.x > 0.9 && outside.z < 0.6, "{outside}");
    }

    #[test]
    fn both_formulas_know_total_reflection() {
        for fresnel in [Fresnel::Exact, Fresnel::Approximate] {
            assert!((Material::glass(1.5).reflectance(0.5, Side::Inside, fresnel) - Rgb::ONE).length() < 1e-6);
        }
    }
}
