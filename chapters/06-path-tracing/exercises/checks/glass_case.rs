//! A ray that hits glass at some angle, and what optics say of it, in f64.

use common::{Basis, Vec3, float};
use ray_casting::{
    hit::{Hit, Side},
    ray::Ray,
};

use super::words::{number, triple};

/// A ray that hits glass.
pub(crate) struct Case {
    pub(crate) index: f32,
    pub(crate) ray: Ray,
    pub(crate) hit: Hit,
}

impl Case {
    /// The ray that comes from a side, at an angle to the normal in degrees.
    pub(crate) fn at(index: f32, side: Side, degrees: f32) -> Self {
        let normal = Vec3::new(0.36, 0.48, 0.8);
        let across = Basis::around(normal).to_world(Vec3::new(0.6, 0.8, 0.0));
        let angle = degrees.to_radians();
        let direction = (across * float::sin(angle) - normal * float::cos(angle)).normalize();
        let ray = Ray::new(Vec3::new(0.5, 1.0, -2.0) - direction * 3.0, direction);
        let outward = if side == Side::Outside { normal } else { -normal };
        Self { index, ray, hit: Hit::new(&ray, 3.0, outward) }
    }

    /// The index behind the surface divided by that before it.
    pub(crate) fn ratio(&self) -> f64 {
        let index = f64::from(self.index);
        if self.hit.side == Side::Outside { index } else { index.recip() }
    }

    /// The cosine between ray and normal.
    pub(crate) fn cosine(&self) -> f64 {
        -self.ray.direction.as_dvec3().dot(self.hit.shading_normal.as_dvec3())
    }

    /// Where a mirror would send the ray.
    pub(crate) fn reflected(&self) -> Vec3 {
        let normal = self.hit.shading_normal.as_dvec3();
        (self.ray.direction.as_dvec3() + 2.0 * self.cosine() * normal).as_vec3()
    }

    /// Where Snell's law sends the ray, if anywhere, with a ratio of indices.
    pub(crate) fn refracted_by(&self, ratio: f64) -> Option<Vec3> {
        let (normal, direction) = (self.hit.shading_normal.as_dvec3(), self.ray.direction.as_dvec3());
        // The part along the surface is divided by the ratio; the rest has the length that makes a unit vector.
        let along = (direction + self.cosine() * normal) / ratio;
        let depth = 1.0 - along.length_squared();
        (depth >= 0.0).then(|| (along - normal * depth.sqrt()).as_vec3())
    }

    /// Where Snell's law sends the ray, if anywhere.
    pub(crate) fn refracted(&self) -> Option<Vec3> {
        self.refracted_by(self.ratio())
    }

    /// Fresnel's share of what is reflected, with a ratio of indices.
    pub(crate) fn reflectance_by(&self, ratio: f64) -> f64 {
        let before = self.cosine();
        let behind = 1.0 - (1.0 - before * before) / (ratio * ratio);
        if behind < 0.0 {
            return 1.0;
        }
        let behind = behind.sqrt();
        let across = (before - ratio * behind) / (before + ratio * behind);
        let along = (ratio * before - behind) / (ratio * before + behind);
        (across * across + along * along) / 2.0
    }

    /// Fresnel's share of what is reflected.
    pub(crate) fn reflectance(&self) -> f64 {
        self.reflectance_by(self.ratio())
    }

    /// Schlick's approximation, by some cosine.
    pub(crate) fn approximate(&self, cosine: f64) -> f64 {
        let f0 = ((self.ratio() - 1.0) / (self.ratio() + 1.0)) * ((self.ratio() - 1.0) / (self.ratio() + 1.0));
        let away = 1.0 - cosine;
        f0 + (1.0 - f0) * away * away * away * away * away
    }

    /// The question in words.
    pub(crate) fn words(&self) -> String {
        let (direction, normal) = (triple(self.ray.direction), triple(self.hit.shading_normal));
        let cosine = number(self.cosine());
        let (index, side) = (self.index, self.hit.side);
        format!(
            "`glass_step` with index {index} from Side::{side:?}, direction {direction}, normal {normal}, cosine {cosine}"
        )
    }
}
