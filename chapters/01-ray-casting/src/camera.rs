//! The camera: an eye, and a window through which it looks.

use common::{
    Vec2, Vec3, float,
    knob::Values,
    picture::{FilmPoint, PITCH, YAW, ZOOM},
};

use crate::ray::Ray;

// ANCHOR: camera
/// A pinhole camera. The window stands around `lookat`, at right angles to the view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    eye: Vec3,
    lookat: Vec3,
    /// From the middle of a square window to the middle of its right edge.
    right: Vec3,
    /// From the middle of a square window to the middle of its upper edge.
    up: Vec3,
}
// ANCHOR_END: camera

/// Why there is no such camera.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CameraError {
    /// There is no direction to look in.
    #[error("the eye and the point it looks at are the same, or not numbers")]
    NoDirection,
    /// The window would be empty, turned over or infinitely large.
    #[error("a field of view of {0}° is impossible: it lies between 0° and 180°")]
    FieldOfView(f32),
}

impl Camera {
    // ANCHOR: new
    /// A camera at `eye` that looks at `lookat`, with the direction `up` upward in the picture. `field_of_view` is the
    /// full angle in degrees across the shorter side of the picture.
    ///
    /// # Errors
    /// [`CameraError`] if there is no direction to look in, or the angle is not between 0° and 180°.
    pub fn new(eye: Vec3, lookat: Vec3, up: Vec3, field_of_view: f32) -> Result<Self, CameraError> {
        let forward = (lookat - eye).try_normalize().ok_or(CameraError::NoDirection)?;
        if !(field_of_view > 0.0 && field_of_view < 180.0) {
            return Err(CameraError::FieldOfView(field_of_view));
        }
        // Right is at right angles to the view and to 'up'. Looking along 'up', any other axis will do.
        let right = forward
            .cross(up)
            .try_normalize()
            .filter(|_| forward.cross(up.normalize_or_zero()).length_squared() > 1e-6)
            .unwrap_or_else(|| forward.any_orthonormal_vector());
        // Half the window's side: tan(½ angle) times the distance.
        let half = float::tan((field_of_view / 2.0).to_radians()) * (lookat - eye).length();
        Ok(Self { eye, lookat, right: right * half, up: right.cross(forward) * half })
    }
    // ANCHOR_END: new

    // ANCHOR: ray
    /// The ray from the eye through a point of the film, its direction of unit length.
    #[must_use]
    pub fn ray(&self, point: FilmPoint) -> Ray {
        // α from −1 to 1 to the right, β from −1 to 1 upward.
        let (alpha, beta) = point.ndc().into();
        // The shorter side of the film has the field of view; the longer side sees more. So pixels are square.
        let aspect = point.aspect();
        let (wide, high) = (aspect.max(1.0), aspect.recip().max(1.0));
        let p = self.lookat + self.right * (alpha * wide) + self.up * (beta * high);
        Ray::new(self.eye, (p - self.eye).normalize())
    }
    // ANCHOR_END: ray

    /// Where a point in space is seen in the window, the inverse of [`Camera::ray`]: (0, 0) is the middle, and the
    /// shorter side of the film reaches from −1 to 1. `None` for what is not before the eye.
    #[must_use]
    pub fn project(&self, point: Vec3) -> Option<Vec2> {
        let forward = self.lookat - self.eye;
        let to_point = point - self.eye;
        // The window is at depth 1.
        let depth = to_point.dot(forward) / forward.length_squared();
        if depth <= 0.0 {
            return None;
        }
        let in_window = to_point / depth;
        let along = |side: Vec3| in_window.dot(side) / side.length_squared();
        Some(Vec2::new(along(self.right), along(self.up)))
    }

    /// Where the eye is.
    #[must_use]
    pub fn eye(&self) -> Vec3 {
        self.eye
    }

    /// A camera that starts at `eye` and is moved on a sphere around `lookat` by the knobs `yaw`, `pitch` and `zoom`.
    ///
    /// # Errors
    /// As for [`Camera::new`].
    pub fn orbited(eye: Vec3, lookat: Vec3, field_of_view: f32, values: &Values) -> Result<Self, CameraError> {
        let from = eye - lookat;
        let (yaw, pitch) = (values.number(&YAW).to_radians(), values.number(&PITCH).to_radians());
        // Direction of the eye as angles around and above the vertical.
        let around = float::atan2(from.x, from.z) + yaw;
        let quarter = std::f32::consts::FRAC_PI_2;
        let across = Vec3::new(from.x, 0.0, from.z).length();
        let above = (float::atan2(from.y, across) + pitch).clamp(-quarter, quarter);
        let (cos, sin) = (float::cos(above), float::sin(above));
        let direction = Vec3::new(cos * float::sin(around), sin, cos * float::cos(around));
        // Up along the meridian: it has a direction at the poles too.
        let up = Vec3::new(-sin * float::sin(around), cos, -sin * float::cos(around));
        let distance = from.length() / values.number(&ZOOM);
        Self::new(lookat + direction * distance, lookat, up, field_of_view)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_seen_where_its_ray_goes_through() {
        let camera = Camera::new(Vec3::new(3.0, 2.0, 7.0), Vec3::new(-1.0, 0.5, 0.0), Vec3::Y, 40.0).unwrap();
        for size in [Vec2::new(160.0, 90.0), Vec2::new(90.0, 160.0)] {
            for position in [Vec2::new(3.0, 5.0), Vec2::new(80.0, 45.0), Vec2::new(71.0, 88.0)] {
                let point = FilmPoint { position, size };
                let seen = camera.project(camera.ray(point).at(11.0)).unwrap();
                // The longer side sees more than the square.
                let expected = point.ndc() * size / size.min_element();
                assert!((seen - expected).length() < 1e-5, "{seen} {expected}");
            }
        }
        assert_eq!(camera.project(camera.eye()), None);
        assert_eq!(camera.project(Vec3::new(7.0, 3.5, 14.0)), None);
    }
}
