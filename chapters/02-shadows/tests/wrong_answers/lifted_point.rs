//! Wrong ways to lift a point.

use common::Vec3;

use crate::{checks::lifted_point::check, name};

/// The lift by one corner: by its normal, its weight, and the height of its plane above the point.
type Part = fn(Vec3, f32, f32) -> Vec3;

fn by_corner(part: Part) -> impl Fn(Vec3, [Vec3; 3], [Vec3; 3], [f32; 3]) -> Vec3 {
    move |point, corners, normals, weights| {
        let lift = |i: usize| part(normals[i], weights[i], (corners[i] - point).dot(normals[i]));
        point + (0..3).map(lift).sum::<Vec3>()
    }
}

fn diagnosis(lifted: impl Fn(Vec3, [Vec3; 3], [Vec3; 3], [f32; 3]) -> Vec3) -> &'static str {
    name(check(lifted))
}

const RIGHT: Part = |normal, weight, height| normal * weight * height.max(0.0);

#[test]
fn right_ones_are_accepted() {
    assert_eq!(check(by_corner(RIGHT)), Ok(()));
    // As the mean of three points, each a projection onto a plane.
    let projected = |point: Vec3, corners: [Vec3; 3], normals: [Vec3; 3], weights: [f32; 3]| {
        let onto = |i: usize| {
            let from_corner = point - corners[i];
            corners[i] + from_corner - normals[i] * from_corner.dot(normals[i]).min(0.0)
        };
        onto(0) * weights[0] + onto(1) * weights[1] + onto(2) * weights[2]
    };
    assert_eq!(check(projected), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(diagnosis(|point, _, _, _| point), "not-started");
}

#[test]
fn wrong_heights() {
    assert_eq!(diagnosis(by_corner(|normal, weight, height| normal * weight * height)), "sunk");
    assert_eq!(diagnosis(by_corner(|normal, weight, height| normal * weight * height.abs())), "sunk");
    assert_eq!(diagnosis(by_corner(|normal, weight, height| -normal * weight * height.max(0.0))), "wrong-sign");
    assert_eq!(diagnosis(by_corner(|normal, weight, height| normal * weight * (-height).max(0.0))), "wrong-sign");
    assert_eq!(diagnosis(by_corner(|normal, weight, height| normal * weight * height.min(0.0))), "wrong-sign");
    assert_eq!(diagnosis(by_corner(|normal, weight, height| normal * weight * height.clamp(0.0, 10.0))), "fixed-size");
    let tiny_is_zero: Part = |normal, weight, height| if height > 1e-2 { normal * weight * height } else { Vec3::ZERO };
    assert_eq!(diagnosis(by_corner(tiny_is_zero)), "fixed-size");
    assert_eq!(
        diagnosis(by_corner(|normal, weight, height| normal * weight * height.max(0.0).sqrt().sqrt())),
        "wrong-lift"
    );
}

#[test]
fn wrong_weights() {
    assert_eq!(diagnosis(by_corner(|normal, _, height| normal * height.max(0.0))), "weights-ignored");
    assert_eq!(diagnosis(by_corner(|normal, _, height| normal * height.max(0.0) / 3.0)), "weights-ignored");
    let mixed = |point, corners, normals, [a, b, c]: [f32; 3]| by_corner(RIGHT)(point, corners, normals, [b, c, a]);
    assert_eq!(diagnosis(mixed), "order-mixed");
    assert_eq!(
        diagnosis(by_corner(|normal, weight, height| normal * weight * weight * height.max(0.0))),
        "weights-twice"
    );
    // A sum of three points.
    let three =
        |point: Vec3, corners, normals, weights| point * 2.0 + by_corner(RIGHT)(point, corners, normals, weights);
    assert_eq!(diagnosis(three), "wrong-lift");
    let offset = |point: Vec3, corners, normals, weights| by_corner(RIGHT)(point, corners, normals, weights) - point;
    assert_eq!(diagnosis(offset), "offset-not-point");
    let nan = |point: Vec3, corners, normals, weights: [f32; 3]| {
        by_corner(RIGHT)(point, corners, normals, weights.map(|w| w * w / w))
    };
    assert_eq!(diagnosis(nan), "not-a-number");
}

#[test]
fn wrong_normals() {
    let along = |normal: fn([Vec3; 3], [Vec3; 3], [f32; 3]) -> Vec3| {
        diagnosis(move |point, corners, normals, weights| {
            let height = |i: usize| weights[i] * (corners[i] - point).dot(normals[i]).max(0.0);
            point + normal(corners, normals, weights) * (0..3).map(height).sum::<f32>()
        })
    };
    assert_eq!(along(|[a, b, c], _, _| (b - a).cross(c - a).normalize()), "triangle-normal");
    assert_eq!(along(|_, [a, b, c], [u, v, w]| (a * u + b * v + c * w).normalize()), "interpolated-normal");
}

#[test]
fn heights_above_what_is_lifted_already() {
    let step_by_step = |point: Vec3, corners: [Vec3; 3], normals: [Vec3; 3], weights: [f32; 3]| {
        (0..3).fold(point, |p, i| p + RIGHT(normals[i], weights[i], (corners[i] - p).dot(normals[i])))
    };
    assert_eq!(diagnosis(step_by_step), "step-by-step");
}

#[test]
fn heights_of_another_kind() {
    let by = |height: fn(Vec3, [Vec3; 3], [Vec3; 3], usize) -> f32| {
        diagnosis(move |point, corners, normals, weights| {
            let lift = |i: usize| normals[i] * weights[i] * height(point, corners, normals, i).max(0.0);
            point + (0..3).map(lift).sum::<Vec3>()
        })
    };
    // Along the triangle's own normal all heights are 0. That is no stub.
    let flat: fn(Vec3, [Vec3; 3], [Vec3; 3], usize) -> f32 = |point, corners, _, i| {
        let [a, b, c] = corners;
        (corners[i] - point).dot((b - a).cross(c - a).normalize())
    };
    assert_eq!(by(flat), "no-height");
    assert_eq!(by(|point, corners, normals, i| (corners[i] - point).normalize().dot(normals[i])), "way-normalized");
    assert_eq!(by(|point, corners, _, i| (corners[i] - point).length()), "length-not-height");
    assert_eq!(by(|point, corners, normals, i| (point - corners[i]).dot(normals[i])), "wrong-sign");
    assert_eq!(by(|point, corners, normals, i| 2.0 * (corners[i] - point).dot(normals[i])), "wrong-factor");
    assert_eq!(by(|point, corners, normals, i| 0.5 * (corners[i] - point).dot(normals[i])), "wrong-factor");
    let message = check(by_corner(|normal, weight, height| normal * weight * (height.max(0.0) + 1.0))).unwrap_err();
    assert!(message.to_string().contains("with the heights "), "{message}");
}

#[test]
fn not_all_corners() {
    let without = |left_out: usize| {
        diagnosis(move |point, corners, normals, mut weights| {
            weights[left_out] = 0.0;
            by_corner(RIGHT)(point, corners, normals, weights)
        })
    };
    assert_eq!([0, 1, 2].map(without), ["corner-forgotten"; 3]);
    let greatest = |point: Vec3, corners: [Vec3; 3], normals: [Vec3; 3], _: [f32; 3]| {
        let lift = |i: usize| normals[i] * (corners[i] - point).dot(normals[i]).max(0.0);
        point + [0, 1, 2].map(lift).into_iter().max_by(|a, b| a.length().total_cmp(&b.length())).unwrap_or_default()
    };
    assert_eq!(diagnosis(greatest), "greatest-only");
    for order in [[1, 2, 0], [2, 0, 1], [2, 1, 0], [1, 0, 2], [0, 2, 1]] {
        let mixed = move |point, corners, normals, weights: [f32; 3]| {
            by_corner(RIGHT)(point, corners, normals, order.map(|i| weights[i]))
        };
        assert_eq!(diagnosis(mixed), "order-mixed");
    }
}
