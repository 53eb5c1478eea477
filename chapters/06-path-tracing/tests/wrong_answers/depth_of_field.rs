//! Wrong lenses.

use common::{Basis, Vec2, Vec3};
use ray_casting::ray::Ray;
use sampling::disc::{sample_uniform_disc_concentric, sample_uniform_disc_polar};

use crate::{
    checks::depth_of_field::{Answer, check},
    name,
};

fn in_focus(pinhole: Ray, forward: Vec3, focus: f32) -> Vec3 {
    pinhole.at(focus / pinhole.direction.dot(forward))
}

/// The ray from a place on the lens, in lens radii, to the point in focus.
fn from_place(pinhole: Ray, [right, up, forward]: [Vec3; 3], radius: f32, focus: f32, place: Vec2) -> Ray {
    let origin = pinhole.origin + (right * place.x + up * place.y) * radius;
    Ray::new(origin, (in_focus(pinhole, forward, focus) - origin).normalize())
}

fn lens_ray(pinhole: Ray, axes: [Vec3; 3], aperture: f32, focus: f32, u: Vec2) -> Ray {
    from_place(pinhole, axes, aperture / 2.0, focus, sample_uniform_disc_concentric(u))
}

fn circle_of_confusion(aperture: f32, focus: f32, depth: f32) -> f32 {
    aperture * (depth / focus - 1.0).abs()
}

const RIGHT: Answer = Answer { in_focus, lens_ray, circle_of_confusion };

/// The diagnosis of such points in focus.
fn points(in_focus: fn(Ray, Vec3, f32) -> Vec3) -> &'static str {
    name(check(Answer { in_focus, ..RIGHT }))
}

type LensRay = fn(Ray, [Vec3; 3], f32, f32, Vec2) -> Ray;

/// The diagnosis of such rays.
fn rays(lens_ray: LensRay) -> &'static str {
    name(check(Answer { lens_ray, ..RIGHT }))
}

/// The diagnosis of such circles.
fn circles(circle_of_confusion: fn(f32, f32, f32) -> f32) -> &'static str {
    name(check(Answer { circle_of_confusion, ..RIGHT }))
}

#[test]
fn all_right_ones_are_accepted() {
    let polar: LensRay = |pinhole, axes, aperture, focus, u| {
        from_place(pinhole, axes, aperture / 2.0, focus, sample_uniform_disc_polar(u))
    };
    let mirrored: LensRay = |pinhole, [right, up, forward], aperture, focus, u| {
        lens_ray(pinhole, [-up, right, forward], aperture, focus, Vec2::new(u.y, 1.0 - u.x))
    };
    // The direction as that of the pinhole, less what the origin has moved.
    let shifted: LensRay = |pinhole, axes, aperture, focus, u| {
        let [right, up, forward] = axes;
        let place = sample_uniform_disc_concentric(u) * (aperture / 2.0);
        let moved = right * place.x + up * place.y;
        let direction = pinhole.direction * (focus / pinhole.direction.dot(forward)) - moved;
        Ray::new(pinhole.origin + moved, direction.normalize())
    };
    for lens_ray in [lens_ray, polar, mirrored, shifted] {
        assert_eq!(check(Answer { lens_ray, ..RIGHT }), Ok(()));
    }
}

#[test]
fn nothing_is_not_started() {
    let nothing = Answer {
        in_focus: |pinhole, _, _| pinhole.origin,
        lens_ray: |pinhole, _, _, _, _| pinhole,
        circle_of_confusion: |_, _, _| 0.0,
    };
    assert_eq!(name(check(nothing)), "not-started");
    assert_eq!(rays(|pinhole, _, _, _, _| pinhole), "lens-ray-not-started");
    assert_eq!(circles(|_, _, _| 0.0), "circle-not-started");
}

#[test]
fn wrong_points_in_focus() {
    assert_eq!(points(|pinhole, _, focus| pinhole.at(focus)), "focus-on-sphere");
    assert_eq!(
        points(|pinhole, forward, focus| pinhole.at(focus * pinhole.direction.dot(forward))),
        "cosine-multiplied"
    );
    assert_eq!(points(|pinhole, forward, focus| pinhole.origin + forward * focus), "one-point-for-all");
    assert_eq!(
        points(|pinhole, forward, focus| pinhole.direction * (focus / pinhole.direction.dot(forward))),
        "eye-forgotten"
    );
    assert_eq!(points(|pinhole, forward, focus| in_focus(pinhole, -forward, focus)), "behind-the-camera");
    assert_eq!(points(|_, _, _| Vec3::NAN), "not-a-number");
    assert_eq!(points(|pinhole, forward, focus| in_focus(pinhole, forward, 2.0 * focus)), "beside-the-plane");
}

#[test]
fn wrong_places_on_the_lens() {
    assert_eq!(
        rays(|pinhole, [_, _, forward], aperture, focus, u| {
            let across = Basis::around(pinhole.direction);
            lens_ray(pinhole, [across.tangent, across.bitangent, forward], aperture, focus, u)
        }),
        "lens-across-the-ray"
    );
    assert_eq!(
        rays(|pinhole, [_, _, forward], aperture, focus, u| {
            lens_ray(pinhole, [Vec3::X, Vec3::Y, forward], aperture, focus, u)
        }),
        "lens-along-the-axes"
    );
    assert_eq!(
        rays(|pinhole, [right, up, forward], aperture, focus, u| {
            lens_ray(pinhole, [right, (up + forward) * std::f32::consts::FRAC_1_SQRT_2, forward], aperture, focus, u)
        }),
        "lens-leans"
    );
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| lens_ray(pinhole, axes, 2.0 * aperture, focus, u)),
        "diameter-for-radius"
    );
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| lens_ray(pinhole, axes, aperture / 2.0, focus, u)),
        "halved-twice"
    );
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| lens_ray(pinhole, axes, 1.4 * aperture, focus, u)),
        "wrong-size"
    );
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| lens_ray(pinhole, axes, 1e-7 * aperture, focus, u)),
        "lens-not-used"
    );
    // The size does not follow the aperture.
    assert_eq!(rays(|pinhole, axes, _, focus, u| lens_ray(pinhole, axes, 1.0, focus, u)), "pinhole-differs");
    let square: LensRay =
        |pinhole, axes, aperture, focus, u| from_place(pinhole, axes, aperture / 2.0, focus, u * 2.0 - 1.0);
    assert_eq!(rays(square), "square-lens");
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| from_place(pinhole, axes, aperture, focus, u * 2.0 - 1.0)),
        "square-lens"
    );
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| from_place(pinhole, axes, aperture / 2.0, focus, u)),
        "one-quarter"
    );
}

#[test]
fn wrong_distributions_over_the_lens() {
    // The polar map without its root.
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| {
            from_place(pinhole, axes, aperture / 2.0, focus, sample_uniform_disc_polar(Vec2::new(u.x * u.x, u.y)))
        }),
        "middle-crowded"
    );
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| {
            from_place(pinhole, axes, aperture / 2.0, focus, sample_uniform_disc_polar(Vec2::new(u.x.sqrt(), u.y)))
        }),
        "rim-crowded"
    );
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| {
            from_place(pinhole, axes, aperture / 2.0, focus, sample_uniform_disc_polar(Vec2::new(1.0, u.y)))
        }),
        "rim-only"
    );
    // One random number for both.
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| lens_ray(pinhole, axes, aperture, focus, Vec2::splat(u.x))),
        "on-a-line"
    );
}

/// A tenth of all angles is left out, and another tenth comes twice as often.
#[test]
fn a_part_without_points_is_seen() {
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| {
            let u = Vec2::new(u.x, if u.y > 0.9 { u.y - 0.5 } else { u.y });
            from_place(pinhole, axes, aperture / 2.0, focus, sample_uniform_disc_polar(u))
        }),
        "not-uniform"
    );
}

#[test]
fn wrong_directions() {
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| Ray {
            direction: in_focus(pinhole, axes[2], focus) - lens_ray(pinhole, axes, aperture, focus, u).origin,
            ..lens_ray(pinhole, axes, aperture, focus, u)
        }),
        "not-normalized"
    );
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| Ray {
            direction: pinhole.direction,
            ..lens_ray(pinhole, axes, aperture, focus, u)
        }),
        "parallel-rays"
    );
    // The point in focus of the moved ray.
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| {
            let Ray { origin, .. } = lens_ray(pinhole, axes, aperture, focus, u);
            let target = in_focus(Ray::new(origin, pinhole.direction), axes[2], focus);
            Ray::new(origin, (target - origin).normalize())
        }),
        "parallel-rays"
    );
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| {
            let Ray { origin, direction } = lens_ray(pinhole, axes, aperture, focus, u);
            Ray::new(origin, -direction)
        }),
        "looks-backwards"
    );
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| {
            let Ray { origin, .. } = lens_ray(pinhole, axes, aperture, focus, u);
            Ray::new(origin, (pinhole.at(focus) - origin).normalize())
        }),
        "focus-on-sphere"
    );
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| {
            let Ray { origin, .. } = lens_ray(pinhole, axes, aperture, focus, u);
            Ray::new(origin, in_focus(pinhole, axes[2], focus))
        }),
        "point-for-direction"
    );
    assert_eq!(
        rays(|pinhole, axes, aperture, focus, u| {
            let Ray { origin, .. } = lens_ray(pinhole, axes, aperture, focus, u);
            Ray::new(origin, (pinhole.origin + axes[2] * focus - origin).normalize())
        }),
        "misses-the-focus"
    );
    assert_eq!(rays(|pinhole, _, _, _, _| Ray::new(pinhole.origin, Vec3::NAN)), "not-a-number");
}

#[test]
fn wrong_circles() {
    assert_eq!(circles(|a, f, z| a * (z - f).abs() / f / 2.0), "radius");
    assert_eq!(circles(|a, f, z| a * (z - f) / f), "negative");
    assert_eq!(circles(|a, f, z| a * (f - z) / f), "negative");
    assert_eq!(circles(|a, f, z| a * (z - f).abs() / z), "divided-by-depth");
    assert_eq!(circles(|_, f, z| (z - f).abs() / f), "lens-forgotten");
    assert_eq!(circles(|a, f, z| a * (z - f).abs()), "wrong-circle");
    assert_eq!(circles(|_, _, _| f32::NAN), "wrong-circle");
}
