//! The material of chapter 1: Phong's, in Blinn's form.

use std::f32::consts::PI;

use common::{Rgb, Vec3, float};

// ANCHOR: phong
/// A rough, somewhat shiny surface, in linear RGB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong {
    /// `k_a`: share of the ambient light that comes back, 0 to 1.
    pub ambient: Rgb,
    /// `k_d`: radiance toward every viewer, for each unit of irradiance; in 1/sr, from 0 to 1/π.
    pub diffuse: Rgb,
    /// `k_s`: the same for the viewer who looks into the middle of the highlight, in 1/sr.
    pub specular: Rgb,
    /// Exponent of the highlight: the greater, the smaller and sharper it is.
    pub shininess: f32,
}
// ANCHOR_END: phong

impl Phong {
    // ANCHOR: of
    /// A surface that scatters the share `albedo` of all light that it catches, with a white highlight. Its `gloss` says
    /// how bright the highlight is, compared with the same light on white chalk.
    #[must_use]
    pub fn of(albedo: Rgb, gloss: f32, shininess: f32) -> Self {
        Self { ambient: albedo, diffuse: albedo / PI, specular: Rgb::splat(gloss / PI), shininess }
    }
    // ANCHOR_END: of

    // ANCHOR: terms
    /// `k_d (L·N)⁺` for the unit vectors `to_light` (L) and `normal` (N).
    #[must_use]
    pub fn diffuse_term(&self, to_light: Vec3, normal: Vec3) -> Rgb {
        self.diffuse * to_light.dot(normal).max(0.0)
    }

    /// `k_s ((H·N)⁺)^shininess`, with `H` halfway between the directions to the light and to the viewer.
    ///
    /// Source: Blinn, *Models of Light Reflection for Computer Synthesized Pictures*, SIGGRAPH 1977.
    #[must_use]
    pub fn specular_term(&self, to_light: Vec3, normal: Vec3, to_viewer: Vec3) -> Rgb {
        let halfway = (to_light + to_viewer).normalize_or_zero();
        self.specular * float::pow(halfway.dot(normal).max(0.0), self.shininess)
    }
    // ANCHOR_END: terms
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHITE: Phong =
        Phong { ambient: Rgb::ONE, diffuse: Rgb::new(0.2, 0.4, 0.8), specular: Rgb::splat(0.5), shininess: 8.0 };

    /// A unit vector at an angle in degrees from z toward x.
    fn at(degrees: f32) -> Vec3 {
        Vec3::new(float::sin(degrees.to_radians()), 0.0, float::cos(degrees.to_radians()))
    }

    #[test]
    fn diffuse_follows_the_cosine_and_ends_at_the_horizon() {
        assert_eq!(WHITE.diffuse_term(Vec3::Z, Vec3::Z), WHITE.diffuse);
        assert!((WHITE.diffuse_term(at(60.0), Vec3::Z) - WHITE.diffuse / 2.0).length() < 1e-6);
        assert_eq!(WHITE.diffuse_term(at(91.0), Vec3::Z), Rgb::ZERO);
    }

    #[test]
    fn specular_is_greatest_in_the_mirror_direction() {
        // Light at 30° on one side, viewer at 30° on the other: H = N.
        let peak = WHITE.specular_term(at(30.0), Vec3::Z, at(-30.0));
        assert!((peak - WHITE.specular).length() < 1e-6);
        // Viewer at 10° more: H leans by 5°.
        let beside = WHITE.specular_term(at(30.0), Vec3::Z, at(-40.0));
        // cos⁸ 5° = 0.969 960.
        assert!((beside.x - 0.5 * 0.969_960).abs() < 1e-6, "{}", beside.x);
    }

    #[test]
    fn opposite_directions_have_no_halfway_vector() {
        assert_eq!(WHITE.specular_term(Vec3::X, Vec3::Z, -Vec3::X), Rgb::ZERO);
    }
}
