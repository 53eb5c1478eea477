//! The ray: a half line along which light comes to the eye.

use common::Vec3;

// ANCHOR: definition
/// The points `origin + t · direction` with `t > 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where the ray starts, in scene units.
    pub origin: Vec3,
    /// Where it goes. Camera rays have unit length, so that `t` is a distance; shapes accept any length but zero.
    pub direction: Vec3,
}
// ANCHOR_END: definition

// ANCHOR: ray
impl Ray {
    /// A ray from `origin` in the direction of `direction`.
    #[must_use]
    pub fn new(origin: Vec3, direction: Vec3) -> Self {
        Self { origin, direction }
    }

    /// The point that the ray reaches at `t`.
    #[must_use]
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + self.direction * t
    }
}
// ANCHOR_END: ray

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn at_is_linear() {
        let ray = Ray::new(Vec3::new(1.0, 2.0, 3.0), Vec3::new(0.0, 0.5, -1.0));
        assert_eq!(ray.at(0.0), ray.origin);
        assert_eq!(ray.at(4.0), Vec3::new(1.0, 4.0, -1.0));
    }
}
