//! The ways to choose a direction at a matte surface.

use common::{Basis, Vec2, Vec3};

use crate::{
    cosine_hemisphere::{cosine_hemisphere_pdf, sample_cosine_hemisphere},
    direction_sample::{Density, DirectionSample},
    uniform_hemisphere::{sample_uniform_hemisphere, uniform_hemisphere_pdf},
    uniform_sphere::{sample_uniform_sphere, uniform_sphere_pdf},
};

// ANCHOR: direction_sampling
/// A way to choose a direction at a matte surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DirectionSampling {
    /// Any direction, even into the surface, with density 1/(4π).
    UniformSphere,
    /// Any direction out of the surface, with density 1/(2π).
    UniformHemisphere,
    /// Any direction out of the surface, with density cosθ/π.
    CosineHemisphere,
}

impl DirectionSampling {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::UniformSphere, Self::UniformHemisphere, Self::CosineHemisphere];

    /// A direction at a surface with the unit normal `normal`, from a point `u` of the unit square.
    #[must_use]
    #[inline]
    pub fn sample(self, normal: Vec3, u: Vec2) -> DirectionSample {
        let local = match self {
            Self::UniformSphere => sample_uniform_sphere(u),
            Self::UniformHemisphere => sample_uniform_hemisphere(u),
            Self::CosineHemisphere => sample_cosine_hemisphere(u),
        };
        let direction = Basis::around(normal).to_world(local);
        DirectionSample { direction, density: Density::SolidAngle(self.pdf(local.z)) }
    }

    /// The density, per steradian, of a direction whose angle to the normal has the cosine `cos_theta`.
    #[must_use]
    #[inline]
    pub fn pdf(self, cos_theta: f32) -> f32 {
        match self {
            Self::UniformSphere => uniform_sphere_pdf(),
            Self::UniformHemisphere => uniform_hemisphere_pdf(cos_theta),
            Self::CosineHemisphere => cosine_hemisphere_pdf(cos_theta),
        }
    }
}
// ANCHOR_END: direction_sampling

impl DirectionSampling {
    /// What to call it.
    #[must_use]
    pub fn name(self) -> &'static str {
        ["uniform-sphere", "uniform-hemisphere", "cosine-hemisphere"][self as usize]
    }
}
