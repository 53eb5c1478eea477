//! Every closed form and its inverse lead there and back.

use common::{Vec2, Vec3};
use proptest::{prelude::*, test_runner::TestCaseError};

use crate::{
    cosine_hemisphere::{invert_cosine_hemisphere_sample, sample_cosine_hemisphere},
    disc::{
        invert_uniform_disc_concentric_sample, invert_uniform_disc_polar_sample, sample_uniform_disc_concentric,
        sample_uniform_disc_polar,
    },
    uniform_hemisphere::{invert_uniform_hemisphere_sample, sample_uniform_hemisphere},
    uniform_sphere::{invert_uniform_sphere_sample, sample_uniform_sphere},
};

/// What a stream can draw: multiples of 2⁻²⁴ from 0 to below 1.
fn uniform() -> impl Strategy<Value = f32> {
    prop_oneof![8 => 0_u32..1 << 24, 1 => 0_u32..8, 1 => (1 << 24) - 8..1_u32 << 24]
        .prop_map(|i| i as f32 / 16_777_216.0)
}

fn square() -> impl Strategy<Value = Vec2> {
    [uniform(), uniform()].prop_map(Vec2::from_array)
}

/// Two numbers of `[0, 1)` are near each other; so are the ends, where the second one is an angle.
fn near(u: Vec2, back: Vec2, tolerance: f32, is_angle: bool) -> Result<(), TestCaseError> {
    let x = (u.x - back.x).abs();
    let y = (u.y - back.y).abs();
    let y = if is_angle { y.min(1.0 - y) } else { y };
    prop_assert!(x <= tolerance && y <= tolerance, "{u} became {back}");
    let inside = |v: f32| (0.0..1.0).contains(&v);
    prop_assert!(inside(back.x) && inside(back.y), "{back} is outside");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    #[test]
    fn sphere(u in square()) {
        // The pole has every angle.
        prop_assume!(u.x > 0.0);
        near(u, invert_uniform_sphere_sample(sample_uniform_sphere(u)), 3e-7, true)?;
    }

    #[test]
    fn hemisphere(u in square()) {
        prop_assume!(u.x > 0.0);
        near(u, invert_uniform_hemisphere_sample(sample_uniform_hemisphere(u)), 3e-7, true)?;
    }

    #[test]
    fn polar_disc(u in square()) {
        prop_assume!(u.x > 0.0);
        near(u, invert_uniform_disc_polar_sample(sample_uniform_disc_polar(u)), 3e-7, true)?;
    }

    #[test]
    fn concentric_disc(u in square()) {
        near(u, invert_uniform_disc_concentric_sample(sample_uniform_disc_concentric(u)), 3e-7, false)?;
    }

    #[test]
    fn cosine_hemisphere(u in square()) {
        near(u, invert_cosine_hemisphere_sample(sample_cosine_hemisphere(u)), 3e-7, false)?;
    }

    /// From a direction to the square and back.
    #[test]
    fn directions(x in -1.0_f32..1.0, y in -1.0_f32..1.0, z in -1.0_f32..1.0) {
        let direction = Vec3::new(x, y, z);
        prop_assume!(direction.length() > 1e-3);
        let direction = direction.normalize();
        let back = sample_uniform_sphere(invert_uniform_sphere_sample(direction));
        // Near the poles a small step of the height is a large step of the radius.
        prop_assert!((back - direction).length() < 5e-4, "{direction} became {back}");
        let upward = direction.with_z(direction.z.abs());
        let back = sample_uniform_hemisphere(invert_uniform_hemisphere_sample(upward));
        prop_assert!((back - upward).length() < 5e-4, "{upward} became {back}");
        let back = sample_cosine_hemisphere(invert_cosine_hemisphere_sample(upward));
        prop_assert!((back - upward).length() < 2e-3, "{upward} became {back}");
    }
}
