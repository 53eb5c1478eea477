//! The material of chapter 6: matte, mirroring and glowing are three properties that add up.

use std::f32::consts::PI;

use common::Rgb;
use ray_casting::{hit::Side, material::Phong};
use whitted::material::{Fresnel, Material as Smooth};

// ANCHOR: material
/// What a surface is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// `k_d`: the BRDF of the matte part, albedo/π in 1/sr; from 0 to 1/π.
    pub diffuse: Rgb,
    /// The polished part, by its `n` and `κ`. Only what it reflects counts: nothing is transparent.
    pub mirror: Option<Smooth>,
    /// The radiance that the surface sends out by itself, on both sides and in all directions.
    pub emission: Rgb,
}
// ANCHOR_END: material

impl Material {
    /// Reflects nothing and does not glow.
    pub const BLACK: Self = Self { diffuse: Rgb::ZERO, mirror: None, emission: Rgb::ZERO };
    /// A gold mirror, by the `n` and `κ` of chapter 3.
    pub const GOLD: Self = Self::mirror(Smooth::GOLD);
    /// A silver mirror.
    pub const SILVER: Self = Self::mirror(Smooth::SILVER);
    /// A copper mirror.
    pub const COPPER: Self = Self::mirror(Smooth::COPPER);

    // ANCHOR: kinds
    /// Scatters the share `albedo` of all light that it catches, evenly to all sides.
    #[must_use]
    pub fn matte(albedo: Rgb) -> Self {
        Self { diffuse: albedo / PI, ..Self::BLACK }
    }

    /// Only mirrors.
    #[must_use]
    pub const fn mirror(metal: Smooth) -> Self {
        Self { mirror: Some(metal), ..Self::BLACK }
    }

    /// Matte under a clear smooth coat with refractive index `index`, like porcelain.
    #[must_use]
    pub fn coated(albedo: Rgb, index: f32) -> Self {
        Self { mirror: Some(Smooth::glass(index)), ..Self::matte(albedo) }
    }

    /// Glows with the radiance `emission`, and reflects nothing.
    #[must_use]
    pub fn glowing(emission: Rgb) -> Self {
        Self { emission, ..Self::BLACK }
    }
    // ANCHOR_END: kinds

    /// The share of the light from all sides that the matte part sends on: `k_d π`.
    #[must_use]
    #[inline]
    pub fn albedo(&self) -> Rgb {
        self.diffuse * PI
    }

    // ANCHOR: reflectance
    /// `F`: the share of the light from the mirror direction that the polished part sends on, for each color channel,
    /// if the angle between ray and normal has this cosine.
    #[must_use]
    #[inline]
    pub fn reflectance(&self, cosine: f32, fresnel: Fresnel) -> Rgb {
        // What lets no light through has no inside to come from.
        self.mirror.map_or(Rgb::ZERO, |smooth| smooth.reflectance(cosine, Side::Outside, fresnel))
    }
    // ANCHOR_END: reflectance
}

/// Of Phong's material the matte part. His highlight is no mirror, and creates energy: it stays behind.
impl From<Phong> for Material {
    fn from(phong: Phong) -> Self {
        Self { diffuse: phong.diffuse, ..Self::BLACK }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn properties_add_up() {
        let porcelain = Material::coated(Rgb::splat(0.5), 1.5);
        assert!((porcelain.albedo() - 0.5).length() < 1e-6);
        assert!((porcelain.reflectance(1.0, Fresnel::Exact) - 0.04).length() < 1e-6);
        assert_eq!(Material::matte(Rgb::ONE).reflectance(0.3, Fresnel::Exact), Rgb::ZERO);
        assert_eq!(Material::GOLD.albedo(), Rgb::ZERO);
    }
}
