//! A place on a matte surface that looks at a lamp.

use std::sync::Arc;

use common::{Interval, Vec2, Vec3};
use ray_casting::{hit::Hit, ray::Ray, scene::Scene, shape::Shape as _};
use sampling::direction_sampling::DirectionSampling;
use shadows::offset::Offset;

use super::lamp::Lamp;

/// A place on a matte surface that looks at a lamp.
pub(crate) struct Place {
    hit: Hit,
    lamp: Lamp,
    /// What may stand between.
    things: Arc<Scene<()>>,
}

impl Place {
    /// A hit that looks at a lamp, and what may stand between.
    pub(crate) fn new(hit: Hit, lamp: Lamp, things: Arc<Scene<()>>) -> Self {
        Self { hit, lamp, things }
    }

    /// The place itself.
    pub(crate) fn hit(&self) -> &Hit {
        &self.hit
    }

    /// The lamp.
    pub(crate) fn lamp(&self) -> &Lamp {
        &self.lamp
    }

    /// The unit normal of the surface.
    pub(crate) fn normal(&self) -> Vec3 {
        self.hit.shading_normal
    }

    /// The area of the lamp.
    pub(crate) fn lamp_area(&self) -> f32 {
        self.lamp.edges[0].cross(self.lamp.edges[1]).length()
    }

    /// The unit vector toward a uniform point of the lamp, from a uniform point of the unit square.
    pub(crate) fn toward_lamp(&self, u: Vec2) -> Vec3 {
        (self.lamp.at(u) - self.origin()).normalize_or(self.normal())
    }

    /// A direction above the surface that is distributed by the cosine, from a uniform point of the unit square.
    pub(crate) fn cosine_direction(&self, u: Vec2) -> Vec3 {
        DirectionSampling::CosineHemisphere.sample(self.normal(), u).direction
    }

    /// Where a ray in this direction meets the lamp; `None` if it does not, or if something stands before it.
    pub(crate) fn lamp_seen(&self, direction: Vec3) -> Option<Hit> {
        let ray = Ray::new(self.origin(), direction);
        let hit = self.lamp.quad().intersect(&ray, Interval::POSITIVE)?;
        let is_hidden = self.things.occluded(&ray, Interval::POSITIVE.up_to(hit.t));
        (!is_hidden).then_some(hit)
    }

    fn origin(&self) -> Vec3 {
        Offset::Following.origin(&self.hit, self.hit.geometric_normal)
    }
}
