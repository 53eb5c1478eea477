//! Wrong points of a triangle.

use common::{Vec2, Vec3};

use crate::{
    checks::triangle_points::{Answer, check},
    name,
};

/// The point with these weights of the second and the third corner.
fn at([r1, r2, r3]: [Vec3; 3], beta: f32, gamma: f32) -> Vec3 {
    r1 * (1.0 - beta - gamma) + r2 * beta + r3 * gamma
}

fn folded(corners: [Vec3; 3], u: Vec2) -> Vec3 {
    if u.x + u.y > 1.0 { at(corners, 1.0 - u.x, 1.0 - u.y) } else { at(corners, u.x, u.y) }
}

fn cross([r1, r2, r3]: [Vec3; 3]) -> Vec3 {
    (r2 - r1).cross(r3 - r1)
}

fn triangle_pdf(corners: [Vec3; 3]) -> f32 {
    let area = cross(corners).length() / 2.0;
    if area > 0.0 { area.recip() } else { 0.0 }
}

const RIGHT: Answer = Answer { sample_triangle: folded, triangle_pdf };

/// The diagnosis of such points.
fn points(sample_triangle: fn([Vec3; 3], Vec2) -> Vec3) -> &'static str {
    name(check(Answer { sample_triangle, ..RIGHT }))
}

/// The diagnosis of such a density.
fn pdf(triangle_pdf: fn([Vec3; 3]) -> f32) -> &'static str {
    name(check(Answer { triangle_pdf, ..RIGHT }))
}

#[test]
fn all_right_ones_are_accepted() {
    let root: fn([Vec3; 3], Vec2) -> Vec3 = |corners, u| at(corners, u.x.sqrt() * (1.0 - u.y), u.x.sqrt() * u.y);
    let other_root: fn([Vec3; 3], Vec2) -> Vec3 = |corners, u| at(corners, 1.0 - u.y.sqrt(), u.y.sqrt() * u.x);
    // Heitz's map keeps neighbors together.
    let halved: fn([Vec3; 3], Vec2) -> Vec3 = |corners, u| {
        if u.y > u.x { at(corners, u.x / 2.0, u.y - u.x / 2.0) } else { at(corners, u.x - u.y / 2.0, u.y / 2.0) }
    };
    for sample_triangle in [folded, root, other_root, halved] {
        assert_eq!(check(Answer { sample_triangle, ..RIGHT }), Ok(()));
    }
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(name(check(Answer { sample_triangle: |corners, _| corners[0], triangle_pdf: |_| 0.0 })), "not-started");
    assert_eq!(pdf(|_| 0.0), "pdf-not-started");
}

#[test]
fn wrong_points() {
    // Without the root, whichever weight comes first.
    assert_eq!(points(|corners, u| at(corners, (1.0 - u.x) * u.y, (1.0 - u.x) * (1.0 - u.y))), "corner-crowded");
    assert_eq!(points(|corners, u| at(corners, u.x, (1.0 - u.x) * u.y)), "corner-crowded");
    assert_eq!(points(|corners, u| at(corners, (1.0 - u.x) * u.y, u.x)), "corner-crowded");
    // The root, but of the wrong side: corner r1 is crowded all the more.
    assert_eq!(
        points(|corners, u| at(corners, (1.0 - u.x.sqrt()) * u.y, (1.0 - u.x.sqrt()) * (1.0 - u.y))),
        "corner-crowded"
    );
    assert_eq!(points(|corners, u| at(corners, u.x, u.y)), "outside");
    assert_eq!(points(|corners, u| at(corners, u.x.sqrt(), u.x.sqrt() * u.y)), "outside");
    assert_eq!(points(|[r1, r2, r3], u| r1 + r2 * u.x + r3 * u.y), "not-in-the-plane");
    assert_eq!(points(|_, _| Vec3::NAN), "not-in-the-plane");
    assert_eq!(points(|corners, u| at(corners, u.x / 2.0, u.x / 2.0)), "on-a-line");
    assert_eq!(points(|corners, u| folded(corners, Vec2::splat(u.x))), "on-a-line");
    // Beyond the triangle, pulled back to the edge.
    assert_eq!(
        points(|corners, u| {
            let u = u / (u.x + u.y).max(1.0);
            at(corners, u.x, u.y)
        }),
        "edge-crowded"
    );
    // Weights divided by their sum: the middle is crowded.
    assert_eq!(
        points(|corners, u| {
            let sum = (u.x + u.y + (u.x + u.y).fract()).max(1e-9);
            at(corners, u.x / sum, u.y / sum)
        }),
        "not-uniform"
    );
    // All of them drawn a little to the middle.
    assert_eq!(
        points(|corners, u| {
            let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
            folded(corners, u).lerp(middle, 0.1)
        }),
        "not-uniform"
    );
}

#[test]
fn wrong_densities() {
    assert_eq!(pdf(|corners| cross(corners).length().max(1e-9).recip()), "half-forgotten");
    assert_eq!(pdf(|corners| cross(corners).length() / 2.0), "area-not-inverse");
    assert_eq!(pdf(|corners| cross(corners).length()), "area-not-inverse");
    // The area of the shadow on the plane z = 0.
    assert_eq!(pdf(|corners| 2.0 / cross(corners).z.abs().max(1e-6)), "wrong-pdf");
    assert_eq!(pdf(|_| 1.0), "wrong-pdf");
    assert_eq!(pdf(|_| f32::NAN), "wrong-pdf");
    assert_eq!(pdf(|corners| 2.0 / cross(corners).length()), "no-area");
}

#[test]
fn a_crowded_corner_is_told_in_plain_words() {
    let sample_triangle: fn([Vec3; 3], Vec2) -> Vec3 =
        |corners, u| at(corners, (1.0 - u.x) * u.y, (1.0 - u.x) * (1.0 - u.y));
    let message = check(Answer { sample_triangle, ..RIGHT }).unwrap_err().to_string();
    assert!(message.contains("times as many points near the corner r1 as there should be"), "{message}");
    assert!(message.contains("A corner gets too many points: did you forget the square root?"), "{message}");
    let sample_triangle: fn([Vec3; 3], Vec2) -> Vec3 =
        |corners, u| at(corners, (1.0 - u.x.sqrt()) * u.y, (1.0 - u.x.sqrt()) * (1.0 - u.y));
    let message = check(Answer { sample_triangle, ..RIGHT }).unwrap_err().to_string();
    assert!(message.contains("so that α = 1 − √u.x"), "{message}");
}
