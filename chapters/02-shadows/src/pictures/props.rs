//! Things and means that several pictures share.

use common::{
    Interval, Rgb, Stream, Vec3,
    picture::{FilmPoint, Integrator},
    story::{Story, triple},
};
use ray_casting::{light::PointLight, local_illumination::tell_ray, ray::Ray};

use crate::direct_light::DirectLight;

/// A glowing line that only the camera sees: it neither lights anything nor casts a shadow.
pub(super) struct Mark {
    pub from: Vec3,
    pub to: Vec3,
    /// Radius of the bright middle, in scene units.
    pub radius: f32,
    /// Radiance in the middle.
    pub radiance: Rgb,
}

impl Mark {
    /// A point of light where a lamp is, which itself cannot be seen.
    pub(super) fn of(lamp: &PointLight, radius: f32) -> Self {
        /// How many times as bright as white the mark is, so that it looks like a flame.
        const BRIGHTNESS: f32 = 4.0;
        let radiance = lamp.intensity / lamp.intensity.max_element() * BRIGHTNESS;
        Self { from: lamp.position, to: lamp.position, radius, radiance }
    }

    /// What a ray sees of the mark, as far as it lies in front of what the ray hits.
    fn glow(&self, ray: &Ray, in_front: Interval) -> Rgb {
        // Where line and ray come nearest to each other, as a share of the line.
        let across = |v: Vec3| v - ray.direction * v.dot(ray.direction);
        let (start, line) = (self.from - ray.origin, self.to - self.from);
        let (a, b) = (across(start), across(line));
        let share = (-a.dot(b) / b.dot(b).max(f32::MIN_POSITIVE)).clamp(0.0, 1.0);
        let place = start + line * share;
        if !in_front.contains(place.dot(ray.direction)) {
            return Rgb::ZERO;
        }
        // Bright in the middle; outside it fades with the fourth power of the distance.
        let off = across(place).length_squared() / (self.radius * self.radius);
        self.radiance / (1.0 + off * off)
    }
}

/// A picture with marks in it.
pub(super) struct Glowing {
    pub direct: DirectLight,
    pub marks: Vec<Mark>,
}

impl Integrator for Glowing {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = self.direct.camera.ray(point);
        tell_ray(story, &ray);
        let radiance = self.direct.trace(&ray, story);
        let hit = self.direct.scene.intersect(&ray, Interval::POSITIVE);
        let in_front = Interval::POSITIVE.up_to(hit.map_or(f32::INFINITY, |(hit, _)| hit.t));
        let glow: Rgb = self.marks.iter().map(|mark| mark.glow(&ray, in_front)).sum();
        story.tell(|| format!("the marks of lamps and lines add {}", triple(glow)));
        radiance + glow
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mark_is_brightest_in_its_middle_and_hidden_by_what_is_in_front() {
        let mark = Mark { from: Vec3::X, to: -Vec3::X, radius: 0.1, radiance: Rgb::ONE };
        let glow =
            |x: f32, y: f32, end| mark.glow(&Ray::new(Vec3::new(x, y, 5.0), -Vec3::Z), Interval::POSITIVE.up_to(end));
        assert_eq!(glow(0.3, 0.0, f32::INFINITY), Rgb::ONE);
        assert!((glow(0.3, 0.1, f32::INFINITY) - Rgb::splat(0.5)).length() < 1e-5);
        // The line ends at x = 1.
        assert!((glow(1.1, 0.0, f32::INFINITY) - Rgb::splat(0.5)).length() < 1e-5);
        assert_eq!(glow(0.3, 0.0, 4.0), Rgb::ZERO);
    }
}
