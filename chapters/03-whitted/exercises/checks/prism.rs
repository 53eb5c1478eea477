//! A ray that meets dispersing glass, and what becomes of it: the right answer to exercise 3.3.

use common::{
    Rgb, Vec3,
    exercise::{Finding, Verdict, dice::Dice, trying},
};
use ray_casting::{
    hit::{Hit, Side},
    ray::Ray,
};
use whitted::branches::Branch;

use super::{dispersion::Answer, words};

/// Dense flint glass.
pub(super) const FLINT: Rgb = Rgb::new(1.7598, 1.7724, 1.7943);
/// No real glass: indices far apart, so that everything shows.
pub(super) const WIDE: Rgb = Rgb::new(1.4, 1.6, 1.9);
/// Angles in degrees beyond the critical angle of blue only (31.8°), and of blue and green (38.7°), in that glass.
pub(super) const PARTLY: [f64; 2] = [35.0, 42.0];

/// A ray that meets a surface.
pub(super) struct Question {
    pub(super) ray: Ray,
    pub(super) hit: Hit,
    pub(super) index: Rgb,
}

impl Question {
    /// At an angle in degrees from the normal.
    #[allow(clippy::disallowed_methods, clippy::cast_possible_truncation, reason = "nearly the angle is near enough")]
    pub(super) fn new(degrees: f64, side: Side, index: Rgb) -> Self {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let direction = Vec3::new(sin as f32, -cos as f32, 0.0);
        Self::of(direction, Vec3::new(1.0, 2.0, 3.0), Vec3::Y, side, index)
    }

    pub(super) fn random(dice: &mut Dice, side: Side, index: Rgb) -> Self {
        let normal = dice.direction().normalize();
        let direction = dice.direction().normalize();
        let direction = if direction.dot(normal) > 0.0 { -direction } else { direction };
        Self::of(direction, dice.point(5.0), normal, side, index)
    }

    /// `normal` faces the ray.
    pub(super) fn of(direction: Vec3, position: Vec3, normal: Vec3, side: Side, index: Rgb) -> Self {
        let ray = Ray::new(position - 2.0 * direction, direction);
        let outward = if side == Side::Inside { -normal } else { normal };
        Self { ray, hit: Hit { side, ..Hit::new(&ray, 2.0, outward) }, index }
    }

    /// The same with another outward normal for shading.
    pub(super) fn shaded_with(self, outward: Vec3) -> Self {
        Self { hit: self.hit.shaded_with(outward), ..self }
    }

    /// The same, shaded with the surface's own normal: what a student has in mind who mistakes one for the other.
    pub(super) fn flat(&self) -> Self {
        let hit = Hit { shading_normal: self.hit.geometric_normal, ..self.hit };
        Self { ray: self.ray, hit, index: self.index }
    }

    /// The index behind divided by that before, for a channel.
    pub(super) fn relative(&self, channel: usize) -> f64 {
        let n = f64::from(self.index[channel]);
        if self.hit.side == Side::Inside { 1.0 / n } else { n }
    }

    pub(super) fn cosine(&self) -> f64 {
        -self.ray.direction.as_dvec3().dot(self.hit.shading_normal.as_dvec3())
    }

    /// The square of the cosine behind the surface; negative beyond the critical angle.
    pub(super) fn behind(&self, n: f64) -> f64 {
        1.0 - (1.0 - self.cosine() * self.cosine()) / (n * n)
    }

    /// Whether rounding decides nothing, away from the critical angles and from the surface itself, and each ray goes to
    /// its own side of the surface.
    pub(super) fn is_fair(&self) -> bool {
        let normal = self.hit.geometric_normal;
        let goes_behind = |d: Vec3| d.dot(normal) < -0.02;
        let flat = self.flat();
        [self, &flat].iter().all(|q| q.cosine() > 0.05 && (0..3).all(|c| q.behind(q.relative(c)).abs() > 0.02))
            && self.mirrored().dot(normal) > 0.02
            && (0..3).filter_map(|c| self.refracted(self.relative(c))).all(goes_behind)
    }

    /// The mirror direction.
    pub(super) fn mirrored(&self) -> Vec3 {
        let (d, n) = (self.ray.direction, self.hit.shading_normal);
        d - 2.0 * n * d.dot(n)
    }

    /// Fresnel's reflectance, as the mean of the squares of two ratios.
    pub(super) fn reflectance(&self, n: f64) -> f64 {
        let (before, behind) = (self.cosine(), self.behind(n));
        if behind < 0.0 {
            return 1.0;
        }
        let behind = behind.sqrt();
        let along = (n * before - behind) / (n * before + behind);
        let across = (before - n * behind) / (before + n * behind);
        (along * along + across * across) / 2.0
    }

    /// The refracted direction.
    #[expect(clippy::cast_possible_truncation, reason = "to be compared with f32")]
    pub(super) fn refracted(&self, n: f64) -> Option<Vec3> {
        let behind = self.behind(n);
        let (d, normal) = (self.ray.direction.as_dvec3(), self.hit.shading_normal.as_dvec3());
        // The part along the surface shrinks by n, the rest follows from the length.
        let along = (d + normal * self.cosine()) / n;
        let v = along - normal * behind.max(0.0).sqrt();
        (behind >= 0.0).then(|| Vec3::new(v.x as f32, v.y as f32, v.z as f32))
    }

    pub(super) fn ask(&self, answer: &Answer) -> [Option<Branch>; 4] {
        trying(|| self.words(), || (answer.branches)(&self.ray, &self.hit, self.index))
    }

    pub(super) fn words(&self) -> String {
        let shading = self.hit.shading_normal;
        let is_bent = shading != self.hit.geometric_normal;
        let shading = if is_bent { format!(", shading normal {}", words::triple(shading)) } else { String::new() };
        format!(
            "`branches` of a ray with direction {} and {}{shading}, with the indices {}",
            words::triple(self.ray.direction),
            words::hit(&self.hit),
            words::triple(self.index)
        )
    }

    pub(super) fn finding(
        &self,
        got: impl Into<String>,
        expected: impl Into<String>,
        name: &'static str,
        advice: &str,
    ) -> Verdict {
        let (tried, got, expected) = (self.words(), got.into(), expected.into());
        Err(Finding { tried, got, expected, advice: advice.into() }.named(name))
    }
}
