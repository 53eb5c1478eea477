//! Scenes of balls and a floor, of which it is known in f64 what stands in the way of what.

use common::{Interval, Vec3};
use glam::DVec3;
use ray_casting::{hit::Hit, pictures::stage::square, ray::Ray, scene::Scene, sphere::Sphere};

use super::words;

/// Balls, on a floor at height 0 or not.
#[derive(Clone, Debug, Default)]
pub(crate) struct Blockers {
    /// Centers and radii.
    pub(crate) balls: Vec<(Vec3, f32)>,
    /// Whether there is a floor.
    pub(crate) floor: bool,
}

/// What is known about the way from a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    /// Nothing stands in it.
    Free,
    /// Something does.
    Blocked,
    /// Rounding decides.
    Unclear,
}

impl Blockers {
    /// Balls on a floor.
    pub(crate) fn on_floor(balls: &[(Vec3, f32)]) -> Self {
        Self { balls: balls.to_vec(), floor: true }
    }

    /// Balls in empty space.
    pub(crate) fn in_space(balls: &[(Vec3, f32)]) -> Self {
        Self { balls: balls.to_vec(), floor: false }
    }

    /// All of them as a scene.
    pub(crate) fn scene<M: Copy>(&self, material: M) -> Scene<M> {
        let mut scene = Scene::new();
        if let Ok(floor) = square(0.0, 100.0)
            && self.floor
        {
            scene.add("floor", floor, material);
        }
        for &(center, radius) in &self.balls {
            scene.add("ball", Sphere::new(center, radius), material);
        }
        scene
    }

    /// Where a ray hits the scene first.
    pub(crate) fn hit(&self, ray: &Ray) -> Option<Hit> {
        self.scene(()).intersect(ray, Interval::POSITIVE).map(|(hit, _)| hit)
    }

    /// The way from just above a point, with its unit normal, in the direction of a unit vector, as far as `reach`.
    pub(crate) fn way(&self, point: DVec3, normal: DVec3, direction: DVec3, reach: f64) -> Way {
        // Along the surface, its own roundness and the start's height would decide.
        // Along the floor, its edge would.
        let is_along_floor = self.floor && direction.y.abs() < 0.05;
        if direction.dot(normal).abs() < 0.02 || is_along_floor {
            return Way::Unclear;
        }
        let mut way = Way::Free;
        for &(center, radius) in &self.balls {
            let radius = f64::from(radius);
            let to_center = center.as_dvec3() - point;
            let middle = to_center.dot(direction);
            let depth = radius * radius - (to_center - direction * middle).length_squared();
            // The ball that the point lies on.
            let is_own = (to_center.length() - radius).abs() < (1e-4 * radius).max(1e-6 * center.as_dvec3().length());
            if is_own {
                let chord = 2.0 * middle;
                way = way.and(chord, reach, radius);
            } else if depth.abs() < 0.02 * radius * radius && middle > -radius && middle < reach + radius {
                return Way::Unclear;
            } else if depth > 0.0 {
                way = way.and(middle - depth.sqrt(), reach, radius).and(middle + depth.sqrt(), reach, radius);
            }
        }
        if self.floor && direction.y < 0.0 {
            way = way.and(-point.y / direction.y, reach, 1.0);
        }
        way
    }

    /// All of them in words.
    pub(crate) fn words(&self) -> String {
        let mut things: Vec<_> = self.balls.iter().map(|&(center, radius)| words::sphere(center, radius)).collect();
        if self.floor {
            things.insert(0, "the floor y = 0".into());
        }
        format!("in a scene of {}", things.join(" and "))
    }
}

impl Way {
    /// The same way with one more thing at `t`, if that lies before `reach`.
    fn and(self, t: f64, reach: f64, size: f64) -> Self {
        match self {
            Self::Free if (t - reach).abs() < 0.02 * size => Self::Unclear,
            Self::Free if t > 0.0 && t < reach => Self::Blocked,
            way => way,
        }
    }
}
