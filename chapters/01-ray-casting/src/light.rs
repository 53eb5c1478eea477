//! Abstract lights: they give light, but cannot be seen.

use common::{Rgb, Vec3};

// ANCHOR: light
/// A source without size: it lights every point from one direction.
pub trait Light: Send + Sync {
    /// What arrives at `point` if nothing is in the way.
    fn illuminate(&self, point: Vec3) -> Illumination;
}

/// The light that arrives at a point from one source.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Illumination {
    /// Unit vector from the point toward the light.
    pub direction: Vec3,
    /// Distance to the light in scene units; infinite for a directional light.
    pub distance: f32,
    /// Irradiance on a surface at the point that faces the light: linear RGB, power per area.
    pub strength: Rgb,
}
// ANCHOR_END: light

// ANCHOR: directional
/// A light so far away that its rays are parallel and equally strong everywhere, like the sun.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionalLight {
    /// Unit vector toward the light.
    direction: Vec3,
    /// Irradiance on a surface facing it.
    strength: Rgb,
}

impl DirectionalLight {
    /// A light that shines from the direction `toward` (of any length but zero) with the given irradiance.
    #[must_use]
    pub fn new(toward: Vec3, strength: Rgb) -> Self {
        Self { direction: toward.normalize_or(Vec3::Y), strength }
    }
}

impl Light for DirectionalLight {
    fn illuminate(&self, _point: Vec3) -> Illumination {
        Illumination { direction: self.direction, distance: f32::INFINITY, strength: self.strength }
    }
}
// ANCHOR_END: directional

// ANCHOR: point
/// A light that shines equally in all directions from one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// Where it is, in scene units.
    pub position: Vec3,
    /// Radiant intensity: power per solid angle. At distance 1 it gives an irradiance of the same number.
    pub intensity: Rgb,
}

impl Light for PointLight {
    fn illuminate(&self, point: Vec3) -> Illumination {
        let to_light = self.position - point;
        // The same power spreads over a sphere whose area grows with the square of the distance.
        let distance_squared = to_light.length_squared();
        let distance = distance_squared.sqrt();
        Illumination { direction: to_light / distance, distance, strength: self.intensity / distance_squared }
    }
}
// ANCHOR_END: point

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directional_light_is_the_same_everywhere() {
        let sun = DirectionalLight::new(Vec3::new(0.0, 2.0, 0.0), Rgb::ONE);
        assert_eq!(sun.illuminate(Vec3::ZERO), sun.illuminate(Vec3::splat(1e6)));
        assert_eq!(sun.illuminate(Vec3::ZERO).direction, Vec3::Y);
    }

    #[test]
    fn point_light_falls_with_the_square_of_the_distance() {
        let lamp = PointLight { position: Vec3::new(0.0, 3.0, 0.0), intensity: Rgb::new(9.0, 18.0, 36.0) };
        let far = lamp.illuminate(Vec3::ZERO);
        assert_eq!((far.direction, far.distance, far.strength), (Vec3::Y, 3.0, Rgb::new(1.0, 2.0, 4.0)));
        // Whatever the distance, a sphere around the lamp catches the same power, 4π times the intensity.
        for distance in [0.1_f32, 1.0, 7.0, 1000.0] {
            let here = lamp.illuminate(lamp.position + Vec3::new(0.6, 0.0, 0.8) * distance);
            let caught = here.strength.x * distance * distance;
            assert!((caught - 9.0).abs() < 1e-3, "{caught} at {distance}");
        }
    }
}
