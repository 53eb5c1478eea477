//! What is proved: every sampling function with its density and its moments.

use std::f64::consts::PI;

use common::{Basis, Stream, Vec3};

use super::chart::{Domain, Point, of_direction, of_disc};
use crate::{
    cosine_hemisphere::{cosine_hemisphere_pdf, sample_cosine_hemisphere, sample_cosine_hemisphere_by_rejection},
    disc::{
        sample_uniform_disc_by_rejection, sample_uniform_disc_concentric, sample_uniform_disc_polar, uniform_disc_pdf,
    },
    uniform_hemisphere::{sample_uniform_hemisphere, sample_uniform_hemisphere_by_rejection, uniform_hemisphere_pdf},
    uniform_sphere::{sample_uniform_sphere, sample_uniform_sphere_by_rejection, uniform_sphere_pdf},
    unit_square::sample_unit_square,
};

/// A distribution that has to be what it is said to be.
#[derive(Clone, Copy)]
pub(super) struct Subject {
    pub(super) name: &'static str,
    pub(super) domain: Domain,
    /// Draws a sample.
    pub(super) draw: fn(&mut Stream) -> Point,
    /// The density, per unit of the domain's area.
    pub(super) pdf: fn(Point) -> f64,
    /// The mean of z.
    pub(super) mean_z: f64,
    /// The means of x², y² and z².
    pub(super) mean_squares: [f64; 3],
    /// The mean of z⁴. All squares are right where directions crowd in the corners of a cube.
    pub(super) mean_fourth: f64,
}

const SPHERE: Subject = Subject {
    name: "sphere",
    domain: Domain::Sphere,
    draw: |random| of_direction(sample_uniform_sphere(sample_unit_square(random))),
    pdf: |_| f64::from(uniform_sphere_pdf()),
    mean_z: 0.0,
    mean_squares: [1.0 / 3.0; 3],
    mean_fourth: 0.2,
};

const HEMISPHERE: Subject = Subject {
    name: "hemisphere",
    domain: Domain::Sphere,
    draw: |random| of_direction(sample_uniform_hemisphere(sample_unit_square(random))),
    pdf: |[.., z]| f64::from(uniform_hemisphere_pdf(z as f32)),
    mean_z: 0.5,
    mean_squares: [1.0 / 3.0; 3],
    mean_fourth: 0.2,
};

const COSINE: Subject = Subject {
    name: "cosine",
    domain: Domain::Sphere,
    draw: |random| of_direction(sample_cosine_hemisphere(sample_unit_square(random))),
    pdf: |[.., z]| f64::from(cosine_hemisphere_pdf(z as f32)),
    mean_z: 2.0 / 3.0,
    mean_squares: [0.25, 0.25, 0.5],
    mean_fourth: 1.0 / 3.0,
};

const DISC: Subject = Subject {
    name: "disc, polar",
    domain: Domain::Disc,
    draw: |random| of_disc(sample_uniform_disc_polar(sample_unit_square(random))),
    pdf: |_| f64::from(uniform_disc_pdf()),
    mean_z: 0.0,
    mean_squares: [0.25, 0.25, 0.0],
    mean_fourth: 0.0,
};

/// A normal along no axis, and its hemisphere's directions in the frame around it.
const NORMAL: Vec3 = Vec3::new(0.6, 0.0, -0.8);

/// All of them.
pub(super) const SUBJECTS: [Subject; 9] = [
    SPHERE,
    Subject {
        name: "sphere by rejection",
        draw: |random| of_direction(sample_uniform_sphere_by_rejection(random)),
        ..SPHERE
    },
    HEMISPHERE,
    Subject {
        name: "hemisphere by rejection",
        draw: |random| {
            of_direction(Basis::around(NORMAL).to_local(sample_uniform_hemisphere_by_rejection(NORMAL, random)))
        },
        ..HEMISPHERE
    },
    COSINE,
    Subject {
        name: "cosine by rejection",
        draw: |random| of_direction(sample_cosine_hemisphere_by_rejection(random)),
        ..COSINE
    },
    DISC,
    Subject {
        name: "disc, concentric",
        draw: |random| of_disc(sample_uniform_disc_concentric(sample_unit_square(random))),
        ..DISC
    },
    Subject { name: "disc by rejection", draw: |random| of_disc(sample_uniform_disc_by_rejection(random)), ..DISC },
];

/// The integral of the density over the domain.
pub(super) fn integral_of_density(subject: &Subject) -> f64 {
    let density = |square| (subject.pdf)(subject.domain.point_at(square));
    subject.domain.area() * super::chart::mean([0.0; 2], [1.0; 2], 200, density)
}

#[test]
fn densities_integrate_to_one() {
    for subject in SUBJECTS {
        let integral = integral_of_density(&subject);
        assert!((integral - 1.0).abs() < 1e-6, "{}: {integral}", subject.name);
    }
    // The quadrature sees the third that is missing from cos²θ/π.
    let wrong = Subject { pdf: |[.., z]| z.max(0.0) * z / PI, ..COSINE };
    assert!((integral_of_density(&wrong) - 2.0 / 3.0).abs() < 1e-4);
}
