//! The teapot: turned body and lid, swept spout and handle.

use common::{Vec2, Vec3, color::srgb};
use ray_casting::material::Phong;

use super::super::{budget::share, builder::Builder, spline::on_spline};

/// Half sections, from below to above: distance from the axis and height, in meters.
const BODY: [(f32, f32); 13] = [
    (0.0, 0.006),
    (0.05, 0.004),
    (0.082, 0.0),
    (0.09, 0.005),
    (0.084, 0.013),
    (0.104, 0.026),
    (0.138, 0.055),
    (0.154, 0.095),
    (0.144, 0.137),
    (0.112, 0.168),
    (0.083, 0.181),
    (0.08, 0.188),
    (0.072, 0.186),
];
const LID: [(f32, f32); 7] =
    [(0.078, 0.187), (0.081, 0.191), (0.075, 0.199), (0.052, 0.213), (0.028, 0.221), (0.012, 0.226), (0.011, 0.232)];
const KNOB: [(f32, f32); 6] =
    [(0.011, 0.23), (0.013, 0.235), (0.021, 0.244), (0.019, 0.254), (0.009, 0.26), (0.0, 0.261)];

/// Center lines, in meters to the side and above the ground, and the radius there.
const SPOUT: [(f32, f32, f32); 6] = [
    (0.118, 0.062, 0.04),
    (0.158, 0.074, 0.035),
    (0.188, 0.104, 0.026),
    (0.206, 0.143, 0.0195),
    (0.226, 0.176, 0.0165),
    (0.252, 0.194, 0.0155),
];
const HANDLE: [(f32, f32, f32); 7] = [
    (-0.118, 0.156, 0.011),
    (-0.162, 0.178, 0.0115),
    (-0.212, 0.172, 0.012),
    (-0.24, 0.138, 0.0125),
    (-0.232, 0.096, 0.012),
    (-0.195, 0.064, 0.0115),
    (-0.135, 0.052, 0.011),
];

/// The teapot in the middle of the field, with about so many triangles.
pub(crate) fn teapot(builder: &mut Builder, triangles: u32) {
    let wanted = builder.count() + triangles;
    builder.part("handle and knob of the teapot", Phong::of(srgb(238, 216, 176), 0.5, 60.0));
    swept(builder, &HANDLE, share(triangles, 0.16));
    turned(builder, &KNOB, share(triangles, 0.07));

    builder.part("teapot", Phong::of(srgb(206, 62, 44), 0.7, 110.0));
    swept(builder, &SPOUT, share(triangles, 0.17));
    turned(builder, &LID, share(triangles, 0.15));
    let body = builder.missing_to(wanted);
    turned(builder, &BODY, body);
}

/// A surface of revolution of about so many triangles, with the smooth curve through the given points as its section.
fn turned(builder: &mut Builder, section: &[(f32, f32)], triangles: u32) {
    // Cells are about as long as wide where there are 1.6 times as many segments as rows.
    let rows = ((triangles as f32 / 2.0 / 1.6).sqrt() as u32).max(2);
    let segments = (triangles / (2 * rows)).max(3);
    let points: Vec<Vec3> = section.iter().map(|&(x, y)| Vec3::new(x, y, 0.0)).collect();
    let profile: Vec<Vec2> = (0..=rows)
        .map(|row| on_spline(&points, row as f32 / rows as f32))
        .map(|point| Vec2::new(point.x.max(0.0), point.y))
        .collect();
    builder.turned_around(Vec3::ZERO, Vec3::Y, &profile, segments);
}

/// A tube of about so many triangles, along the smooth curve through the given points.
fn swept(builder: &mut Builder, line: &[(f32, f32, f32)], triangles: u32) {
    let sides = ((triangles as f32 / 2.0 / 2.0).sqrt() as u32).max(3);
    let pieces = (triangles / (2 * sides)).max(3);
    let points: Vec<Vec3> = line.iter().map(|&(x, y, _)| Vec3::new(x, y, 0.0)).collect();
    let radii: Vec<Vec3> = line.iter().map(|&(.., radius)| Vec3::splat(radius)).collect();
    let at = |i: u32| i as f32 / pieces as f32;
    let centers: Vec<Vec3> = (0..=pieces).map(|i| on_spline(&points, at(i))).collect();
    builder.tube(&centers, sides, |i| on_spline(&radii, i as f32 / pieces as f32).x);
}
