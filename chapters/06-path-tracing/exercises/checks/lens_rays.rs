//! Rays from a lens: whether they start all over the lens, and meet in the point in focus.

use common::{
    Stream, Vec2,
    exercise::{
        Diagnosis, Finding, Verdict, trying,
        words::{number, rounded, triple},
    },
};
use glam::{DVec2, DVec3};
use ray_casting::ray::Ray;
use sampling::unit_square::sample_unit_square;

use super::{
    depth_of_field::{Answer, PLACES, lenses},
    lens::Lens,
    lens_mistakes::{self as mistakes, Mistake},
};

/// Rays of each pixel.
pub(super) const RAYS: usize = 4000;

/// The rays of one pixel.
pub(super) struct Pixel<'a> {
    lens: &'a Lens,
    pinhole: Ray,
    pub(super) rays: Vec<(Vec2, Ray)>,
}

/// Accept rays from a lens, or name what is wrong with them.
pub(super) fn check(answer: &Answer) -> Verdict {
    for (i, lens) in (0..).zip(lenses()) {
        for (j, place) in (0..).zip(PLACES) {
            let mut random = Stream::new(63, i, j);
            let pixel = Pixel::of(answer, &lens, lens.pinhole(place), &mut random);
            if i == 0 && j == 0 && pixel.rays.iter().all(|(_, ray)| *ray == pixel.pinhole) {
                let message = "`in_focus` is right. Now for `lens_ray`, which returns the pinhole's own ray.";
                return Err(Diagnosis::new("lens-ray-not-started", message));
            }
            pixel.rays.iter().try_for_each(|(u, ray)| pixel.starts_in_the_lens_plane(*u, *ray))?;
            pixel.reaches_over_the_lens()?;
            pixel.rays.iter().try_for_each(|(u, ray)| pixel.meets_the_point_in_focus(*u, *ray))?;
            pixel.fills_the_lens_evenly()?;
            let closed = Lens { aperture: 0.0, ..lens };
            let pixel = Pixel::of(answer, &closed, closed.pinhole(place), &mut random);
            pixel.rays.iter().try_for_each(|(u, ray)| pixel.is_the_pinhole(*u, *ray))?;
        }
    }
    Ok(())
}

impl<'a> Pixel<'a> {
    /// The student's rays.
    fn of(answer: &Answer, lens: &'a Lens, pinhole: Ray, random: &mut Stream) -> Self {
        let mut pixel = Self { lens, pinhole, rays: Vec::new() };
        let last = 1.0 - f32::EPSILON / 2.0;
        let special = [[0.5, 0.5], [0.0, 0.0], [last, 0.0], [0.0, last], [last, last]].map(Vec2::from_array);
        let count = if lens.aperture > 0.0 { RAYS } else { 100 };
        let drawn = (0..count).map(|_| sample_unit_square(random));
        let ray = |u: Vec2| (answer.lens_ray)(pinhole, lens.axes, lens.aperture, lens.focus, u);
        let rays = special.into_iter().chain(drawn).map(|u| (u, trying(|| pixel.tried(u), || ray(u)))).collect();
        pixel.rays = rays;
        pixel
    }

    fn tried(&self, u: Vec2) -> String {
        self.tried_with(&format!("u = ({}, {})", u.x, u.y))
    }

    /// What is tried, with these points.
    pub(super) fn tried_with(&self, points: &str) -> String {
        let [origin, direction] = [self.pinhole.origin, self.pinhole.direction].map(triple);
        let lens = self.lens.words();
        format!("`lens_ray` of the ray from {origin} in direction {direction}, with {lens}, {points}")
    }

    fn wrong(&self, u: Vec2, got: String, expected: String, (name, advice): Mistake) -> Diagnosis {
        Finding { tried: self.tried(u), got, expected, advice: advice.into() }.named(name)
    }

    /// A ray that starts where it may.
    fn starts_in_the_lens_plane(&self, u: Vec2, ray: Ray) -> Verdict {
        let [origin, direction] = [ray.origin, ray.direction].map(|v| v.as_dvec3());
        let got = format!("a ray from {} in direction {}", rounded(origin), rounded(direction));
        if !(origin.is_finite() && direction.is_finite()) {
            return Err(self.wrong(u, got, "numbers".into(), mistakes::NOT_A_NUMBER));
        }
        if self.lens.depth(origin).abs() <= self.lens.slack() {
            return Ok(());
        }
        let from_eye = |ray: &Ray| ray.origin.as_dvec3() - self.lens.eye.as_dvec3();
        let across = |axis: DVec3| self.rays.iter().all(|(_, ray)| from_eye(ray).dot(axis).abs() <= self.lens.slack());
        let mistake = if across(self.pinhole.direction.as_dvec3()) {
            mistakes::ACROSS_THE_RAY
        } else if [DVec3::X, DVec3::Y, DVec3::Z].into_iter().any(across) {
            mistakes::ALONG_THE_AXES
        } else {
            mistakes::LEANS
        };
        let expected = format!("an origin at depth 0; this one is at depth {}", number(self.lens.depth(origin)));
        Err(self.wrong(u, got, expected, mistake))
    }

    /// Origins on the lens, seen from its middle, in lens radii.
    pub(super) fn origins(&self) -> impl Iterator<Item = DVec2> {
        self.rays.iter().map(|(_, ray)| self.lens.beside(ray.origin.as_dvec3()) / self.lens.radius())
    }

    /// A lens of the right size and shape.
    fn reaches_over_the_lens(&self) -> Verdict {
        let reach = self.origins().map(DVec2::length).fold(0.0, f64::max);
        let side = self.origins().map(|place| place.abs().max_element()).fold(0.0, f64::max);
        // Whatever may come of 4000 points.
        let is = |x: f64, size: f64| (x / size - 1.0).abs() < 0.03;
        let slack = self.lens.slack() / self.lens.radius();
        if reach <= 1.0 + slack && reach > 0.97 {
            return Ok(());
        }
        let is_square = reach > 1.2 * side;
        let one_sided = self.origins().all(|place| place.min_element() >= -slack);
        let mistake = if reach <= slack {
            mistakes::NOT_USED
        } else if one_sided {
            mistakes::ONE_QUARTER
        } else if is_square {
            mistakes::SQUARE
        } else if is(reach, 2.0) {
            mistakes::DIAMETER_FOR_RADIUS
        } else if is(reach, 0.5) {
            mistakes::HALVED_TWICE
        } else {
            mistakes::WRONG_SIZE
        };
        let far = |(_, ray): &&(Vec2, Ray)| self.lens.beside(ray.origin.as_dvec3()).length();
        let u = self.rays.iter().max_by(|a, b| far(a).total_cmp(&far(b))).map_or(Vec2::ZERO, |(u, _)| *u);
        let got =
            format!("an origin that lies {} from the eye; no other is farther", number(reach * self.lens.radius()));
        let expected = format!("origins all over a disc with the radius {}", number(self.lens.radius()));
        Err(self.wrong(u, got, expected, mistake))
    }

    /// A ray that goes where it should.
    fn meets_the_point_in_focus(&self, u: Vec2, ray: Ray) -> Verdict {
        let lens = self.lens;
        let [origin, direction] = [ray.origin, ray.direction].map(|v| v.as_dvec3());
        let meets = |target: DVec3| {
            let to_target = target - origin;
            let miss = to_target.cross(direction.normalize_or_zero()).length();
            miss <= lens.slack() && to_target.dot(direction) > 0.0
        };
        let target = lens.in_focus(self.pinhole);
        let pinhole = self.pinhole.direction.as_dvec3();
        let is_toward = |v: DVec3| direction.normalize_or_zero().distance(v) < 1e-5;
        let mistake = if meets(target) {
            if (direction.length() - 1.0).abs() <= 1e-5 {
                return Ok(());
            }
            mistakes::NOT_NORMALIZED
        } else if meets(2.0 * origin - target) {
            mistakes::LOOKS_BACKWARDS
        } else if is_toward(pinhole) {
            mistakes::PARALLEL
        } else if meets(lens.eye.as_dvec3() + pinhole * f64::from(lens.focus)) {
            mistakes::ON_SPHERE
        } else if direction.distance(target) < lens.slack() {
            mistakes::POINT_FOR_DIRECTION
        } else {
            mistakes::MISSES
        };
        let at = lens.at_depth(ray, f64::from(lens.focus));
        let told =
            |direction: DVec3| format!("direction {}, of length {}", rounded(direction), number(direction.length()));
        let got = format!("{}; at the plane of focus the ray is at {}", told(direction), rounded(at));
        let expected = format!("{}, toward {}", told((target - origin).normalize()), rounded(target));
        Err(self.wrong(u, got, expected, mistake))
    }

    /// Without an aperture: the pinhole's ray.
    fn is_the_pinhole(&self, u: Vec2, ray: Ray) -> Verdict {
        let off = |a: common::Vec3, b: common::Vec3| f64::from(a.distance(b));
        // The direction is that to a point, which has been rounded.
        let slack = self.lens.slack() / f64::from(self.lens.focus);
        if off(ray.origin, self.pinhole.origin) <= self.lens.slack()
            && off(ray.direction, self.pinhole.direction) <= slack
        {
            return Ok(());
        }
        let told = |ray: Ray| {
            format!("a ray from {} in direction {}", rounded(ray.origin.as_dvec3()), rounded(ray.direction.as_dvec3()))
        };
        Err(self.wrong(u, told(ray), told(self.pinhole), mistakes::PINHOLE_DIFFERS))
    }
}
