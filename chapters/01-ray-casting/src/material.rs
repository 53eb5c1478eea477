//! The material of chapter 1: Phong's, in Blinn's form.

use common::{Rgb, Vec3, float};

// ANCHOR: phong
/// A rough, somewhat shiny surface. All three colours are linear RGB and say how much of the light comes back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong {
    /// `k_a`: share of the ambient light.
    pub ambient: Rgb,
    /// `k_d`: share of a light that is scattered equally in all directions.
    pub diffuse: Rgb,
    /// `k_s`: strength of the highlight.
    pub specular: Rgb,
    /// Exponent of the highlight: the greater, the smaller and sharper it is.
    pub shininess: f32,
}
// ANCHOR_END: phong

impl Phong {
    /// A surface of one colour, with the same ambient share and a white highlight of strength `specular`.
    #[must_use]
    pub fn of(color: Rgb, specular: f32, shininess: f32) -> Self {
        Self { ambient: color, diffuse: color, specular: Rgb::splat(specular), shininess }
    }

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
        let expected = 0.5 * f64::from(5.0_f32).to_radians().cos().powi(8);
        assert!((f64::from(beside.x) - expected).abs() < 1e-6);
    }

    #[test]
    fn opposite_directions_have_no_halfway_vector() {
        assert_eq!(WHITE.specular_term(Vec3::X, Vec3::Z, -Vec3::X), Rgb::ZERO);
    }
}
