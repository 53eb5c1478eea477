//! A camera with a lens, in f64.

use common::{
    Vec3,
    exercise::words::{number, triple},
};
use glam::{DVec2, DVec3};
use ray_casting::ray::Ray;

/// A camera with a lens.
#[derive(Clone, Copy)]
pub(super) struct Lens {
    pub(super) eye: Vec3,
    /// Right, up and forward: unit vectors at right angles to each other.
    pub(super) axes: [Vec3; 3],
    pub(super) aperture: f32,
    pub(super) focus: f32,
}

impl Lens {
    /// A lens at `eye` that looks at `lookat`, with the y axis upward.
    pub(super) fn looking(eye: [f32; 3], lookat: [f32; 3], aperture: f32, focus: f32) -> Self {
        let eye = Vec3::from_array(eye);
        let forward = (Vec3::from_array(lookat) - eye).normalize();
        let right = forward.cross(Vec3::Y).normalize();
        Self { eye, axes: [right, right.cross(forward), forward], aperture, focus }
    }

    pub(super) fn radius(&self) -> f64 {
        f64::from(self.aperture) / 2.0
    }

    fn forward(&self) -> DVec3 {
        self.axes[2].as_dvec3()
    }

    /// The pinhole's ray through the point of a window at distance 1 that lies so far to the right and upward.
    pub(super) fn pinhole(&self, [across, high]: [f32; 2]) -> Ray {
        let [right, up, forward] = self.axes;
        Ray::new(self.eye, (forward + right * across + up * high).normalize())
    }

    /// The point in focus of a pinhole's ray.
    pub(super) fn in_focus(&self, pinhole: Ray) -> DVec3 {
        self.at_depth(pinhole, f64::from(self.focus))
    }

    /// Where a ray from the lens reaches this depth.
    pub(super) fn at_depth(&self, ray: Ray, depth: f64) -> DVec3 {
        let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
        let start = (origin - self.eye.as_dvec3()).dot(self.forward());
        origin + direction * ((depth - start) / direction.dot(self.forward()))
    }

    /// How far a point lies from the eye to the right and upward.
    pub(super) fn beside(&self, point: DVec3) -> DVec2 {
        let from_eye = point - self.eye.as_dvec3();
        DVec2::new(from_eye.dot(self.axes[0].as_dvec3()), from_eye.dot(self.axes[1].as_dvec3()))
    }

    /// How far a point lies before the eye.
    pub(super) fn depth(&self, point: DVec3) -> f64 {
        (point - self.eye.as_dvec3()).dot(self.forward())
    }

    /// What rounding may do to a position.
    pub(super) fn slack(&self) -> f64 {
        1e-5 * f64::from(self.focus + self.aperture + self.eye.length())
    }

    pub(super) fn words(&self) -> String {
        let [right, up, forward] = self.axes.map(triple);
        let [aperture, focus] = [self.aperture, self.focus].map(|x| number(x.into()));
        format!("right {right}, up {up}, forward {forward}, aperture {aperture}, focus {focus}")
    }
}
