//! How a point is lifted, right or with a mistake that is known by what comes out, in f64.

use glam::DVec3;

/// One corner of the triangle, seen from the point.
#[derive(Clone, Copy)]
pub(crate) struct Corner {
    pub(crate) normal: DVec3,
    pub(crate) weight: f64,
    /// The way from the point to the corner.
    pub(crate) way: DVec3,
}

impl Corner {
    /// How far the plane in the corner lies above the point.
    pub(crate) fn height(self) -> f64 {
        self.way.dot(self.normal)
    }

    /// What this corner lifts the point by, without its weight.
    fn lift(self) -> DVec3 {
        self.normal * self.height().max(0.0)
    }
}

/// What comes out, as an offset from the point: by the corners and the triangle's own unit normal.
pub(crate) type Recipe = fn([Corner; 3], DVec3) -> DVec3;

fn sum(corners: [Corner; 3], part: impl Fn(Corner) -> DVec3) -> DVec3 {
    corners.into_iter().map(part).sum()
}

/// The weighted sum of all heights above zero.
fn height(corners: [Corner; 3]) -> f64 {
    corners.into_iter().map(|c| c.weight * c.height().max(0.0)).sum()
}

pub(crate) fn right(corners: [Corner; 3], _own: DVec3) -> DVec3 {
    sum(corners, |c| c.lift() * c.weight)
}

/// The interpolated normal.
fn interpolated(corners: [Corner; 3]) -> DVec3 {
    sum(corners, |c| c.normal * c.weight).normalize()
}

/// The weights of these corners, in this order.
fn mixed(corners: [Corner; 3], order: [usize; 3]) -> DVec3 {
    let weights = order.map(|i| corners[i].weight);
    corners.into_iter().zip(weights).map(|(corner, weight)| corner.lift() * weight).sum()
}

/// Without one of the corners.
fn without(corners: [Corner; 3], left_out: usize) -> DVec3 {
    (0..3).filter(|i| *i != left_out).map(|i| corners[i].lift() * corners[i].weight).sum()
}

/// The greatest by length.
fn greatest(corners: [Corner; 3], part: impl Fn(Corner) -> DVec3) -> DVec3 {
    corners.map(part).into_iter().fold(DVec3::ZERO, |a, b| if a.length() < b.length() { b } else { a })
}

/// A mistake that is known by what comes out: name, recipes, advice.
pub(crate) type Mistake = (&'static str, &'static [Recipe], &'static str);

pub(crate) const MISTAKES: [Mistake; 18] = [
    (
        "sunk",
        &[|corners, _| sum(corners, |c| c.normal * c.weight * c.height())],
        "This point is sunk below the triangle, or lifted less than it should be: a plane that lies below the point counts with \
         0, not with a negative height. `max` sees to that.",
    ),
    (
        "wrong-sign",
        &[|corners, _| sum(corners, |c| c.normal * c.weight * (-c.height()).max(0.0))],
        "The sign of the height is wrong. It is positive where the plane lies above the point: (corner − point) · normal.",
    ),
    (
        "wrong-sign",
        &[|corners, own| -right(corners, own)],
        "The point is moved the wrong way. It must go up to the planes, along the normals.",
    ),
    (
        "wrong-sign",
        &[|corners, _| sum(corners, |c| c.normal * c.weight * c.height().min(0.0))],
        "Only planes below the point count here, and the point sinks. It is the other way round: `max`, not `min`.",
    ),
    (
        "weights-ignored",
        &[|corners, _| sum(corners, Corner::lift)],
        "The three lifts are added up without weights. The nearer the point is to a corner, the more that corner counts: \
         multiply by the weights.",
    ),
    (
        "weights-ignored",
        &[|corners, _| sum(corners, Corner::lift) / 3.0],
        "All three corners count alike. The nearer the point is to a corner, the more that corner counts: multiply by the weights.",
    ),
    (
        "triangle-normal",
        &[|corners, own| own * height(corners)],
        "The point is lifted along the triangle's own normal. For each corner, lift it along the normal of that corner.",
    ),
    (
        "interpolated-normal",
        &[|corners, _| interpolated(corners) * height(corners)],
        "The point is lifted along the interpolated normal. For each corner, lift it along the normal of that corner.",
    ),
    (
        "interpolated-normal",
        &[
            |corners, _| sum(corners, |c| c.normal * c.weight * c.way.dot(interpolated(corners)).max(0.0)),
            |corners, _| sum(corners, |c| interpolated(corners) * c.weight * c.way.dot(interpolated(corners)).max(0.0)),
        ],
        "The heights are measured along the interpolated normal. For each corner, measure along the normal of that corner.",
    ),
    (
        "order-mixed",
        &[
            |corners, _| mixed(corners, [1, 2, 0]),
            |corners, _| mixed(corners, [2, 0, 1]),
            |corners, _| mixed(corners, [2, 1, 0]),
            |corners, _| mixed(corners, [1, 0, 2]),
            |corners, _| mixed(corners, [0, 2, 1]),
        ],
        "Corners and weights do not belong together here. The first weight is that of the first corner.",
    ),
    (
        "corner-forgotten",
        &[|corners, _| without(corners, 0), |corners, _| without(corners, 1), |corners, _| without(corners, 2)],
        "Only two of the three corners count here. All three do, each with its weight.",
    ),
    (
        "greatest-only",
        &[|corners, _| greatest(corners, Corner::lift), |corners, _| greatest(corners, |c| c.lift() * c.weight)],
        "Only the greatest of the three lifts counts here. Add up all three, each with its weight.",
    ),
    (
        "wrong-factor",
        &[|corners, own| right(corners, own) * 2.0],
        "The point is lifted twice as far as it should be. Is a lift added twice?",
    ),
    (
        "wrong-factor",
        &[|corners, own| right(corners, own) / 2.0, |corners, own| right(corners, own) / 3.0],
        "The point is lifted in the right direction, but not far enough. The weights sum up to 1 already: no further division is \
         needed.",
    ),
    (
        "weights-twice",
        &[|corners, _| sum(corners, |c| c.lift() * c.weight * c.weight)],
        "The weights come in twice. Multiply each lift by its weight once.",
    ),
    (
        "step-by-step",
        &[|corners, _| {
            corners.into_iter().fold(DVec3::ZERO, |up, c| up + Corner { way: c.way - up, ..c }.lift() * c.weight)
        }],
        "These heights are measured from what has been lifted so far. Each height is that above the point itself, `point`, so that \
         the order of the corners does not matter.",
    ),
    (
        "way-normalized",
        &[|corners, _| sum(corners, |c| c.normal * c.weight * c.way.normalize_or_zero().dot(c.normal).max(0.0))],
        "Here corner − point is made a unit vector. But its length counts: the dot product with the normal is then a height in \
         scene units.",
    ),
    (
        "length-not-height",
        &[|corners, _| sum(corners, |c| c.normal * c.weight * c.way.length())],
        "Here the point is lifted by its distance from the corner. The height is the part of the way along the normal: a dot \
         product.",
    ),
];
