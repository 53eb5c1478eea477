//! The branches: the rays that a smooth surface sends on.

use common::{Interval, Rgb};
use ray_casting::{hit::Hit, ray::Ray};
use shadows::offset::Offset;

use crate::{
    material::{Fresnel, Material},
    probe::Kind,
    reflection::reflect,
    refraction::refract,
};

// ANCHOR: branch
/// A ray that carries light to a point of a smooth surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Branch {
    /// Why it is followed.
    pub kind: Kind,
    /// The ray, of unit direction.
    pub ray: Ray,
    /// Where hits count.
    pub range: Interval,
    /// Which share of its radiance goes on toward the viewer.
    pub share: Rgb,
}
// ANCHOR_END: branch

impl Branch {
    /// A ray from the eye: the root of the tree.
    #[must_use]
    pub fn from_camera(ray: Ray) -> Self {
        Self { kind: Kind::Camera, ray, range: Interval::POSITIVE, share: Rgb::ONE }
    }
}

// ANCHOR: branches
/// The rays of `F(V·N) L(R) + (1 − F(V·N)) L(T)` for a ray that hits a surface: the reflected and the refracted one.
#[must_use]
pub fn branches(ray: &Ray, hit: &Hit, material: &Material, fresnel: Fresnel, offset: Offset) -> [Option<Branch>; 2] {
    if !material.reflective && !material.refractive {
        return [None, None];
    }
    let normal = hit.shading_normal;
    let cosine = -ray.direction.dot(normal);
    let index = material.relative_index(hit.side);
    // Between equal media there is no border: the ray goes straight on.
    if material.refractive && index == Rgb::ONE {
        let range = Interval::new(hit.t, f32::INFINITY);
        return [None, Some(Branch { kind: Kind::Refracted, ray: *ray, range, share: Rgb::ONE })];
    }
    // Bend the ray; where that is impossible, everything is reflected.
    let refracted = if material.refractive { refract(ray.direction, normal, index.x) } else { None };
    let is_total = material.refractive && refracted.is_none();
    let reflectance = if is_total { Rgb::ONE } else { material.reflectance(cosine, hit.side, fresnel) };
    // The reflected ray starts before the surface, the refracted one behind it.
    let branch = |kind, side, direction, share| {
        let ray = Ray::new(offset.origin(hit, side * hit.geometric_normal), direction);
        Branch { kind, ray, range: Interval::POSITIVE, share }
    };
    let reflected = material.reflective.then(|| reflect(ray.direction, normal));
    [
        reflected.map(|direction| branch(Kind::Reflected, 1.0, direction, reflectance)),
        refracted.map(|direction| branch(Kind::Refracted, -1.0, direction, Rgb::ONE - reflectance)),
    ]
}
// ANCHOR_END: branches
