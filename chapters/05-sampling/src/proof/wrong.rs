//! Mistakes planted on purpose: each must be caught, or the proofs prove nothing.

use common::{Stream, Vec2, Vec3, float};

use super::{
    chart::{of_direction, of_disc},
    chi_square::passes,
    moments::wrong_moment,
    subjects::{SUBJECTS, Subject, integral_of_density},
};
use crate::{
    cosine_hemisphere::lift,
    pictures::disc_samples::rootless,
    uniform_sphere::{point_in_ball, point_in_cube, sample_uniform_sphere},
    unit_square::sample_unit_square,
};

/// The right thing to compare with.
fn right(name: &str) -> Subject {
    SUBJECTS.into_iter().find(|subject| subject.name == name).unwrap()
}

/// A point of the disc with the angle right and this distance from the center.
fn at(radius: f32, u: Vec2) -> Vec2 {
    let angle = std::f32::consts::TAU * u.y;
    Vec2::new(float::cos(angle), float::sin(angle)) * radius
}

/// Mistakes in what is drawn.
fn wrong_samples() -> Vec<Subject> {
    let [sphere, hemisphere, cosine, disc] = ["sphere", "hemisphere", "cosine", "disc, polar"].map(right);
    vec![
        Subject {
            name: "a cube, not rejected",
            draw: |random| of_direction(point_in_cube(random).normalize_or(Vec3::Z)),
            ..sphere
        },
        Subject { name: "the disc without the root", draw: |random| of_disc(at_uniform_radius(random)), ..disc },
        Subject {
            name: "lifted without the root",
            draw: |random| of_direction(lift(at_uniform_radius(random))),
            ..cosine
        },
        Subject {
            name: "the angle θ uniform",
            draw: |random| {
                let u = sample_unit_square(random);
                let theta = std::f32::consts::PI * u.x;
                of_direction(at(float::sin(theta), u).extend(float::cos(theta)))
            },
            ..sphere
        },
        Subject {
            name: "normal and a point in the ball",
            draw: |random| of_direction((Vec3::Z + point_in_ball(random)).normalize_or(Vec3::Z)),
            ..cosine
        },
        Subject { name: "uniform for cosine", draw: hemisphere.draw, ..cosine },
        Subject { name: "the sphere for the hemisphere", draw: sphere.draw, ..hemisphere },
        Subject {
            name: "one number used twice",
            draw: |random| of_direction(sample_uniform_sphere(Vec2::splat(random.uniform()))),
            ..sphere
        },
    ]
}

/// What [`crate::disc::sample_uniform_disc_polar`] is without its root.
fn at_uniform_radius(random: &mut Stream) -> Vec2 {
    rootless(sample_unit_square(random))
}

/// Mistakes in the density that is claimed.
fn wrong_densities() -> Vec<Subject> {
    let [sphere, hemisphere, cosine, disc] = ["sphere", "hemisphere", "cosine", "disc, polar"].map(right);
    vec![
        Subject { name: "cosθ without 1/π", pdf: |[.., z]| z.max(0.0), ..cosine },
        Subject { name: "cosθ/2π", pdf: |[.., z]| z.max(0.0) / std::f64::consts::TAU, ..cosine },
        Subject { name: "1/4π over the hemisphere only", pdf: |[.., z]| uniform_above(z) / 2.0, ..hemisphere },
        Subject { name: "1/2π over the sphere", pdf: |_| 1.0 / std::f64::consts::TAU, ..sphere },
        Subject { name: "the disc's 1/π, twice", pdf: |_| 2.0 / std::f64::consts::PI, ..disc },
    ]
}

/// The density of the hemisphere.
fn uniform_above(z: f64) -> f64 {
    if z > 0.0 { 1.0 / std::f64::consts::TAU } else { 0.0 }
}

#[test]
fn wrong_samples_are_caught() {
    for (i, wrong) in wrong_samples().iter().enumerate() {
        assert!(!passes(wrong, i as u64), "χ² does not see: {}", wrong.name);
        assert!(wrong_moment(wrong, i as u64).is_some(), "moments do not see: {}", wrong.name);
    }
}

#[test]
fn wrong_densities_are_caught() {
    for (i, wrong) in wrong_densities().iter().enumerate() {
        assert!(!passes(wrong, i as u64), "χ² does not see: {}", wrong.name);
        assert!((integral_of_density(wrong) - 1.0).abs() > 0.4, "the integral does not see: {}", wrong.name);
    }
    // One that is normalized and still wrong, which only samples show.
    let squared = |[.., z]: [f64; 3]| 1.5 / std::f64::consts::PI * z.max(0.0) * z;
    let wrong = Subject { name: "(3/2π) cos²θ", pdf: squared, ..right("cosine") };
    assert!((integral_of_density(&wrong) - 1.0).abs() < 1e-3 && !passes(&wrong, 0));
}
