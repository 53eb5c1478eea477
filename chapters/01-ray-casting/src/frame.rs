//! A rigid frame: where a shape stands and how it is turned.

use common::{Mat3, Vec3, float};

/// A place and an orientation. It moves and turns, but never stretches, so that ray parameters keep their meaning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Where the local origin stands, in scene units.
    origin: Vec3,
    /// The local axes, as unit columns at right angles.
    axes: Mat3,
}

impl Frame {
    /// Standing upright at `origin`.
    #[must_use]
    pub fn at(origin: Vec3) -> Self {
        Self { origin, axes: Mat3::IDENTITY }
    }

    /// The same place, then turned about the unit vector `axis` by an angle in degrees, counter-clockwise when the
    /// axis points at the viewer. Source: Rodrigues' rotation formula.
    #[must_use]
    pub fn turned(self, axis: Vec3, degrees: f32) -> Self {
        let (sin, cos) = (float::sin(degrees.to_radians()), float::cos(degrees.to_radians()));
        let turn = |v: Vec3| v * cos + axis.cross(v) * sin + axis * axis.dot(v) * (1.0 - cos);
        let Mat3 { x_axis, y_axis, z_axis } = self.axes;
        Self { axes: Mat3::from_cols(turn(x_axis), turn(y_axis), turn(z_axis)), ..self }
    }

    // ANCHOR: to_local
    /// A point of the scene in local coordinates.
    #[must_use]
    pub fn point_to_local(&self, point: Vec3) -> Vec3 {
        self.vector_to_local(point - self.origin)
    }

    /// A direction of the scene in local coordinates.
    #[must_use]
    pub fn vector_to_local(&self, vector: Vec3) -> Vec3 {
        // The inverse of a rotation is its transpose.
        self.axes.transpose() * vector
    }
    // ANCHOR_END: to_local

    /// A local direction in the scene; normals too, since nothing is stretched.
    #[must_use]
    pub fn vector_to_world(&self, vector: Vec3) -> Vec3 {
        self.axes * vector
    }

    /// A local point in the scene.
    #[must_use]
    pub fn point_to_world(&self, point: Vec3) -> Vec3 {
        self.origin + self.vector_to_world(point)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_turn_about_y_takes_z_to_x() {
        let frame = Frame::at(Vec3::new(1.0, 2.0, 3.0)).turned(Vec3::Y, 90.0);
        assert!((frame.vector_to_world(Vec3::Z) - Vec3::X).length() < 1e-6);
        assert!((frame.point_to_world(Vec3::Z) - Vec3::new(2.0, 2.0, 3.0)).length() < 1e-6);
    }

    #[test]
    fn there_and_back() {
        let frame = Frame::at(Vec3::new(1.0, 2.0, 3.0)).turned(Vec3::Y, 30.0).turned(Vec3::X, -50.0);
        let p = Vec3::new(-4.0, 0.5, 2.0);
        assert!((frame.point_to_local(frame.point_to_world(p)) - p).length() < 1e-5);
        assert!((frame.vector_to_world(p).length() - p.length()).abs() < 1e-5);
    }
}
