//! An orthonormal basis around a unit vector.

use glam::Vec3;

/// Three unit vectors at right angles, right-handed: `tangent × bitangent = normal`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis {
    /// First vector across the normal.
    pub tangent: Vec3,
    /// Second vector across the normal.
    pub bitangent: Vec3,
    /// The vector that the basis was built around.
    pub normal: Vec3,
}

impl Basis {
    /// A basis whose third vector is the unit vector `normal`.
    ///
    /// It has no special direction at which it fails, unlike `normal × (fixed axis)`.
    /// Source: Duff et al., *Building an Orthonormal Basis, Revisited*, JCGT 6(1), 2017, listing 3.
    #[must_use]
    pub fn around(normal: Vec3) -> Self {
        let Vec3 { x, y, z } = normal;
        let sign = 1.0_f32.copysign(z);
        let a = -1.0 / (sign + z);
        let b = x * y * a;
        Self {
            tangent: Vec3::new(1.0 + sign * x * x * a, sign * b, -sign * x),
            bitangent: Vec3::new(b, sign + y * y * a, -y),
            normal,
        }
    }

    /// From coordinates in this basis to world coordinates.
    #[must_use]
    pub fn to_world(&self, local: Vec3) -> Vec3 {
        self.tangent * local.x + self.bitangent * local.y + self.normal * local.z
    }

    /// From world coordinates to coordinates in this basis.
    #[must_use]
    pub fn to_local(&self, world: Vec3) -> Vec3 {
        Vec3::new(world.dot(self.tangent), world.dot(self.bitangent), world.dot(self.normal))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Stream;

    /// How far the three vectors are from orthonormal and right-handed, in f64.
    fn error(normal: Vec3) -> f64 {
        let Basis { tangent: t, bitangent: b, normal: n } = Basis::around(normal);
        let [t, b, n] = [t, b, n].map(|v| v.as_dvec3());
        let lengths = [t, b, n].map(|v| (v.length() - 1.0).abs());
        let angles = [t.dot(b), b.dot(n), n.dot(t)].map(f64::abs);
        let handed = (t.cross(b) - n).length();
        lengths.into_iter().chain(angles).fold(handed, f64::max)
    }

    #[test]
    fn orthonormal_for_random_normals() {
        let mut random = Stream::new(1, 0, 0);
        for _ in 0..100_000 {
            let v = Vec3::from_array([(); 3].map(|()| 2.0 * random.uniform() - 1.0));
            if v.length_squared() > 1e-6 {
                assert!(error(v.normalize()) < 5e-7, "{v}");
            }
        }
    }

    #[test]
    fn orthonormal_on_and_around_the_axes() {
        for axis in [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Y, -Vec3::Z] {
            assert!(error(axis) < 1e-9, "{axis}");
            for i in 0..3 {
                for next in [f32::next_up, f32::next_down] {
                    let mut near = axis;
                    near[i] = next(near[i]);
                    assert!(error(near) < 5e-7, "{near:?}");
                }
            }
        }
    }

    #[test]
    fn there_and_back() {
        let basis = Basis::around(Vec3::new(0.6, 0.0, -0.8));
        let v = Vec3::new(0.3, -2.0, 5.0);
        assert!((basis.to_world(basis.to_local(v)) - v).length() < 1e-5);
    }
}
