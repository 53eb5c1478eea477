//! A point of a surface, and all that it sees.

use common::{
    Interval, Rgb, Vec2, Vec3,
    story::{Story, Untold},
};
use ray_casting::ray::Ray;
use whitted::{branches::Branch, probe::Listener, whitted::Whitted};

use crate::cosine_hemisphere::lift;

/// A point of a surface, and the directions of its map.
pub(super) struct Point {
    /// Where rays start.
    pub(super) origin: Vec3,
    /// Right, away from the viewer and out of the surface: unit vectors at right angles.
    pub(super) right: Vec3,
    pub(super) away: Vec3,
    pub(super) normal: Vec3,
    /// The share of light that the surface scatters.
    pub(super) albedo: Rgb,
}

impl Point {
    /// The point of the scene that a ray from straight above meets.
    pub(super) fn below(scene: &Whitted, x: f32, z: f32) -> Self {
        let down = Ray::new(Vec3::new(x, 50.0, z), -Vec3::Y);
        let Some((hit, object)) = scene.scene.intersect(&down, Interval::POSITIVE) else {
            // Over the sea.
            return Self {
                origin: Vec3::new(x, 0.0, z),
                right: Vec3::X,
                away: -Vec3::Z,
                normal: Vec3::Y,
                albedo: Rgb::ZERO,
            };
        };
        let normal = hit.geometric_normal;
        // Right stays right as far as the surface allows; on a wall that faces right there is no right.
        let right = (Vec3::X - normal * normal.x).try_normalize().unwrap_or(Vec3::NEG_Y);
        let albedo = object.material.rough.map_or(Rgb::ZERO, |rough| rough.ambient);
        let origin = scene.offset.origin(&hit, normal);
        Self { origin, right, away: normal.cross(right), normal, albedo }
    }

    // ANCHOR: map
    /// The direction that a place of the unit disc stands for: the point of the hemisphere above it.
    pub(super) fn direction(&self, place: Vec2) -> Vec3 {
        let local = lift(place);
        self.right * local.x + self.away * local.y + self.normal * local.z
    }
    // ANCHOR_END: map

    /// The radiance that arrives from there.
    pub(super) fn radiance(&self, scene: &Whitted, place: Vec2, story: &mut impl Story) -> Rgb {
        let ray = Ray::new(self.origin, self.direction(place));
        scene.trace(Branch::from_camera(ray), 0, &mut Listener(story))
    }

    // ANCHOR: swatches
    /// The radiance that the point sends back to everyone, without what comes straight from the lamp: by the ambient
    /// term of chapter 1, and by summing over the disc.
    ///
    /// The disc is the hemisphere seen from above, so a part of it counts as much as its size is: the mean of the disc,
    /// times the albedo, is what a matte surface sends back.
    pub(super) fn swatches(&self, scene: &Whitted) -> [Rgb; 2] {
        const PER_AXIS: u8 = 96;
        let at = |cell: u8| (f32::from(cell) + 0.5) / f32::from(PER_AXIS) * 2.0 - 1.0;
        let places = (0..PER_AXIS).flat_map(|y| (0..PER_AXIS).map(move |x| Vec2::new(at(x), at(y))));
        let (mut sum, mut count) = (Rgb::ZERO, 0.0);
        for place in places.filter(|place| place.length_squared() < 1.0) {
            sum += self.radiance(scene, place, &mut Untold);
            count += 1.0;
        }
        [self.albedo * scene.scene.ambient, self.albedo * sum / count]
    }
    // ANCHOR_END: swatches
}
