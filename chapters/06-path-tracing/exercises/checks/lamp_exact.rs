//! The light of a lamp in f64, on paper and by summing up.

use common::Vec3;
use glam::DVec3;

use super::lamp::Lamp;

/// The irradiance that a lamp of radiance 1 gives to a point with this normal, if nothing is in the way.
///
/// Lambert's formula for a polygon: half the sum, over its edges, of the angle under which an edge is seen, times the cosine
/// between the normal and that of the plane through edge and point. What lies below the horizon is cut away first.
///
/// Source: Lambert, *Photometria*, 1760.
pub(crate) fn irradiance(lamp: &Lamp, point: Vec3, normal: Vec3) -> f64 {
    let ([a, b], corner) = (lamp.edges, lamp.corner - point);
    let corners = [corner, corner + a, corner + a + b, corner + b].map(|corner| corner.as_dvec3());
    let normal = normal.as_dvec3();
    let polygon = above_horizon(&corners, normal);
    let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
    let sum: f64 = edges.map(|(from, to)| angle(*from, *to) * from.cross(*to).normalize_or_zero().dot(normal)).sum();
    sum.abs() / 2.0
}

/// The part of a polygon that lies on the side of the origin to which the normal points.
fn above_horizon(corners: &[DVec3], normal: DVec3) -> Vec<DVec3> {
    let mut polygon = Vec::new();
    for (i, &from) in corners.iter().enumerate() {
        let to = corners[(i + 1) % corners.len()];
        let [below, above] = [from, to].map(|corner| corner.dot(normal));
        if below > 0.0 {
            polygon.push(from);
        }
        if (below > 0.0) != (above > 0.0) {
            polygon.push(from + (to - from) * (below / (below - above)));
        }
    }
    polygon
}

#[allow(clippy::disallowed_methods, reason = "the platform's functions are the second opinion here")]
fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// One point of a lamp as it is seen from another point.
pub(crate) struct Seen {
    /// The unit vector toward it.
    pub(crate) toward: DVec3,
    /// The cosine at the surface, negative below the horizon.
    pub(crate) cosine: f64,
    /// The cosine at the lamp, not negative.
    pub(crate) cosine_there: f64,
    /// The distance squared.
    pub(crate) distance2: f64,
    /// The area of the lamp.
    pub(crate) area: f64,
}

impl Seen {
    /// How a point of the lamp is seen.
    pub(crate) fn of(lamp: &Lamp, there: DVec3, point: Vec3, normal: Vec3) -> Self {
        let cross = lamp.edges[0].as_dvec3().cross(lamp.edges[1].as_dvec3());
        let offset = there - point.as_dvec3();
        let toward = offset.normalize_or_zero();
        let cosine_there = cross.normalize_or_zero().dot(toward).abs();
        let cosine = normal.as_dvec3().dot(toward);
        Self { toward, cosine, cosine_there, distance2: offset.length_squared(), area: cross.length() }
    }

    /// The density of its direction per steradian, if all points of the lamp are equally likely.
    pub(crate) fn density(&self) -> f64 {
        self.distance2 / (self.area * self.cosine_there)
    }
}

/// The mean of some quantity over all points of a lamp, by the midpoints of many small pieces.
pub(crate) fn mean(lamp: &Lamp, point: Vec3, normal: Vec3, quantity: impl Fn(&Seen) -> f64) -> f64 {
    const PIECES: u32 = 200;
    let ([a, b], corner) = (lamp.edges.map(|edge| edge.as_dvec3()), lamp.corner.as_dvec3());
    let at = |i: u32| (f64::from(i) + 0.5) / f64::from(PIECES);
    let places = (0..PIECES).flat_map(|i| (0..PIECES).map(move |j| [at(i), at(j)]));
    let sum: f64 = places.map(|[x, y]| quantity(&Seen::of(lamp, corner + a * x + b * y, point, normal))).sum();
    sum / f64::from(PIECES * PIECES)
}
