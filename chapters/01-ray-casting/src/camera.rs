//! The camera: an eye, and a window through which it looks.

use common::{
    Vec3, float,
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
