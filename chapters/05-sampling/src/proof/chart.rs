//! Maps that keep areas in proportion, between the unit square and where samples lie. They are written here once more,
//! in double precision, so that what is proved does not rest on itself.

use std::f64::consts::{PI, TAU};

use common::{Vec2, Vec3, float};

/// A point of the sphere or of the disc (then z is 0).
pub(super) type Point = [f64; 3];

/// Where samples lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Domain {
    /// All unit vectors: 4π steradians.
    Sphere,
    /// The unit disc: area π.
    Disc,
}

impl Domain {
    /// Its area.
    pub(super) fn area(self) -> f64 {
        match self {
            Domain::Sphere => 4.0 * PI,
            Domain::Disc => PI,
        }
    }

    /// Where in the unit square a sample belongs.
    pub(super) fn square_of(self, [x, y, z]: Point) -> [f64; 2] {
        let turn = f64::from(float::atan2(y as f32, x as f32)) / TAU;
        let along = match self {
            // Slices of a sphere of equal height have equal area.
            Domain::Sphere => (z + 1.0) / 2.0,
            Domain::Disc => x * x + y * y,
        };
        [along, turn - turn.floor()]
    }

    /// What belongs to a point of the unit square.
    pub(super) fn point_at(self, [along, turn]: [f64; 2]) -> Point {
        let (cos, sin) = (float::cos_f64(turn * TAU), float::sin_f64(turn * TAU));
        let (radius, z) = match self {
            Domain::Sphere => {
                let z = 2.0 * along - 1.0;
                ((1.0 - z * z).max(0.0).sqrt(), z)
            }
            Domain::Disc => (along.sqrt(), 0.0),
        };
        [radius * cos, radius * sin, z]
    }
}

/// A direction as a point.
pub(super) fn of_direction(direction: Vec3) -> Point {
    direction.to_array().map(f64::from)
}

/// A point of the disc as a point.
pub(super) fn of_disc(point: Vec2) -> Point {
    of_direction(point.extend(0.0))
}

/// The mean of a function over a rectangle of the unit square, by the midpoints of `pieces` × `pieces` cells.
pub(super) fn mean(low: [f64; 2], size: [f64; 2], pieces: u32, function: impl Fn([f64; 2]) -> f64) -> f64 {
    let at = |axis: usize, i: u32| low[axis] + size[axis] * (f64::from(i) + 0.5) / f64::from(pieces);
    let row = |i: u32| (0..pieces).map(|j| function([at(0, i), at(1, j)])).sum::<f64>();
    (0..pieces).map(row).sum::<f64>() / f64::from(pieces * pieces)
}

#[test]
fn there_and_back() {
    for domain in [Domain::Sphere, Domain::Disc] {
        for square in [[0.3, 0.2], [0.9, 0.99], [0.01, 0.5]] {
            let back = domain.square_of(domain.point_at(square));
            assert!((0..2).all(|i| (back[i] - square[i]).abs() < 1e-6), "{square:?} {back:?}");
        }
    }
}
