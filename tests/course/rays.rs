//! Random rays of every kind that shapes must stand.

use common::{Interval, Stream, Vec3};
use ray_casting::ray::Ray;

use crate::exact::V;

/// A number between `low` and `high`.
pub(crate) fn between(random: &mut Stream, low: f32, high: f32) -> f32 {
    low + (high - low) * random.uniform()
}

/// A number between `low` and `high` whose logarithm is evenly distributed.
pub(crate) fn magnitude(random: &mut Stream, low: f32, high: f32) -> f32 {
    use common::float::{exp, ln};
    exp(between(random, ln(low), ln(high)))
}

/// A point in the cube from −1 to 1.
pub(crate) fn in_cube(random: &mut Stream) -> Vec3 {
    Vec3::from_array([(); 3].map(|()| between(random, -1.0, 1.0)))
}

/// A unit vector, every direction equally likely.
pub(crate) fn direction(random: &mut Stream) -> Vec3 {
    loop {
        let v = in_cube(random);
        if (1e-3..1.0).contains(&v.length_squared()) {
            return v.normalize();
        }
    }
}

/// One of `count` with equal probability.
pub(crate) fn one_of(random: &mut Stream, count: usize) -> usize {
    ((random.uniform() * count as f32) as usize).min(count - 1)
}

/// A ray from one point toward another, its direction of unit length.
pub(crate) fn aimed(origin: Vec3, at: Vec3) -> Ray {
    Ray::new(origin, (at - origin).try_normalize().unwrap_or(Vec3::X))
}

/// What the rays are aimed at.
pub(crate) struct Target<'a> {
    pub(crate) center: Vec3,
    /// Radius of a ball around all that matters.
    pub(crate) size: f32,
    /// From how many sizes away rays may come.
    pub(crate) farthest: f32,
    /// A random point of the surface and its normal.
    pub(crate) surface: &'a dyn Fn(&mut Stream) -> (V, V),
}

impl Target<'_> {
    /// A random ray, of any of the kinds in turn.
    pub(crate) fn ray(&self, i: u32, random: &mut Stream) -> Ray {
        let Self { center, size, farthest, .. } = *self;
        let near = center + in_cube(random) * 1.2 * size;
        let ray = match i % 9 {
            // Start anywhere around the shape.
            0 => aimed(center + in_cube(random) * 4.0 * size, near),
            // Start far away.
            1 => aimed(center + direction(random) * magnitude(random, 4.0, farthest) * size, near),
            // Run along an axis, with exact zeros of either sign.
            2 => {
                let mut way = Vec3::from_array([(); 3].map(|()| [0.0, -0.0][one_of(random, 2)]));
                way[one_of(random, 3)] = [1.0, -1.0][one_of(random, 2)];
                Ray::new(near - way * between(random, 0.0, 6.0) * size, way)
            }
            // Run along a plane of coordinates.
            3 => {
                let mut way = direction(random);
                way[one_of(random, 3)] = [0.0, -0.0][one_of(random, 2)];
                Ray::new(near - way * between(random, 0.0, 6.0) * size, way)
            }
            // Run nearly along an axis, down to denormal numbers.
            4 => {
                let small = |random: &mut Stream| magnitude(random, 1e-40, 1e-2) * [1.0, -1.0][one_of(random, 2)];
                let mut way = Vec3::from_array([(); 3].map(|()| small(random)));
                way[one_of(random, 3)] = [1.0, -1.0][one_of(random, 2)];
                Ray::new(near - way * between(random, 0.0, 6.0) * size, way)
            }
            // Start inside.
            5 => Ray::new(center + in_cube(random) * 0.5 * size, direction(random)),
            // Start on the surface.
            6 => Ray::new((self.surface)(random).0.to_f32(), direction(random)),
            // Aim at the surface itself, so also at its rim.
            7 => aimed(center + in_cube(random) * 4.0 * size, (self.surface)(random).0.to_f32()),
            // Graze it: pass within a thousandth of its size.
            _ => {
                let (point, normal) = (self.surface)(random);
                let aside = normal * f64::from(between(random, -1e-3, 1e-3) * size);
                let way = normal.cross(V::from(direction(random))).to_f32().try_normalize().unwrap_or(Vec3::X);
                Ray::new((point + aside).to_f32() - way * between(random, 0.0, 6.0) * size, way)
            }
        };
        // Half of the directions are not of unit length.
        let speed = if random.uniform() < 0.5 { 1.0 } else { magnitude(random, 1e-3, 1e3) };
        Ray::new(ray.origin, ray.direction * speed)
    }

    /// All that lies in front of the ray, or a part of the ray's way past the shape.
    pub(crate) fn range(&self, ray: &Ray, random: &mut Stream) -> Interval {
        if random.uniform() < 0.6 {
            return Interval::POSITIVE;
        }
        let (speed, far) = (ray.direction.length(), (ray.origin - self.center).length());
        let min = (far + between(random, -1.5, 1.0) * self.size) / speed;
        let max = min + between(random, 0.0, 3.0) * self.size / speed;
        if random.uniform() < 0.5 { Interval::new(min, max) } else { Interval::new(min, f32::INFINITY) }
    }
}
