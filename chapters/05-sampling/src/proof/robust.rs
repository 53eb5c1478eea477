//! Whatever the numbers, nothing panics; and whatever the normal, the frame holds.

use common::{Basis, Stream, Vec2, Vec3};

use super::subjects::SUBJECTS;
use crate::{
    direction_sampling::DirectionSampling,
    disc::{invert_uniform_disc_concentric_sample, invert_uniform_disc_polar_sample},
    uniform_sphere::invert_uniform_sphere_sample,
    unit_square::sample_unit_square,
};

const ODD: [f32; 9] = [0.0, -0.0, 1.0, -1.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN_POSITIVE];

#[test]
fn odd_numbers_do_no_harm() {
    for x in ODD {
        for y in ODD {
            for way in DirectionSampling::ALL {
                let sample = way.sample(Vec3::new(x, y, 1.0), Vec2::new(x, y));
                assert!(sample.density.weight() >= 0.0);
                assert!(way.pdf(x) >= 0.0);
            }
            let _ = invert_uniform_disc_concentric_sample(Vec2::new(x, y));
            let _ = invert_uniform_disc_polar_sample(Vec2::new(x, y));
            let _ = invert_uniform_sphere_sample(Vec3::new(x, y, x));
        }
    }
}

/// The corners of the square, of all that a stream can draw, and its center.
#[test]
fn corners_become_unit_vectors() {
    let last = 1.0 - f32::EPSILON / 2.0;
    for u in [[0.0, 0.0], [0.0, last], [last, 0.0], [last, last], [0.5, 0.5]].map(Vec2::from_array) {
        for way in DirectionSampling::ALL {
            let sample = way.sample(Vec3::Z, u);
            assert!((sample.direction.length() - 1.0).abs() < 3e-7, "{way:?} {u}: {}", sample.direction);
            assert!(way == DirectionSampling::UniformSphere || sample.direction.z >= 0.0);
        }
    }
}

/// The mean cosine to any normal is that of the closed form.
#[test]
fn the_frame_holds_for_every_normal() {
    let axes = [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Y, -Vec3::Z, Vec3::new(0.6, 0.0, -0.8)];
    for (i, normal) in axes.into_iter().enumerate() {
        for (way, expected) in DirectionSampling::ALL.into_iter().zip([0.0, 0.5, 2.0 / 3.0]) {
            let mut random = Stream::new(9, i as u64, 0);
            let estimate = crate::estimate::monte_carlo(20_000, &mut random, |random| {
                let sample = way.sample(normal, sample_unit_square(random));
                let cos_theta = normal.dot(sample.direction);
                let pdf = sample.density.per_steradian().unwrap();
                assert!((pdf - way.pdf(cos_theta)).abs() < 1e-5);
                f64::from(cos_theta)
            });
            let off = (estimate.mean() - expected).abs();
            assert!(off < estimate.three_sigma() * 4.0 / 3.0, "{way:?} around {normal}: {}", estimate.mean());
        }
    }
}

/// What `N × (1, 0, 0)` makes of a normal: a tangent without a length where N lies along x. The frame of
/// [`Basis::around`] has no such place.
#[test]
fn a_tangent_from_a_fixed_axis_fails_along_that_axis() {
    let tangent = |normal: Vec3| normal.cross(Vec3::X).normalize();
    assert!(tangent(Vec3::Y).is_finite() && tangent(Vec3::new(0.6, 0.0, 0.8)).is_finite());
    for normal in [Vec3::X, -Vec3::X] {
        assert!(tangent(normal).is_nan());
        assert!((Basis::around(normal).tangent.length() - 1.0).abs() < 1e-6);
    }
}

#[test]
fn the_same_stream_draws_the_same_samples() {
    for subject in SUBJECTS {
        let draw = || (subject.draw)(&mut Stream::new(1, 2, 3));
        assert_eq!(draw(), draw(), "{}", subject.name);
    }
}
