//! The business card: a whole ray tracer that is small enough to be printed on one.
//!
//! Source: Heckbert, *A Minimal Ray Tracer*, Graphics Gems IV, 1994. This is a readable program of our own that computes the
//! same picture, number for number, and so in f64 as the card does.

use std::io::{self, Write};

use common::float;
use glam::DVec3;

// ANCHOR: scene
/// All there is: spheres, and some of them shine.
struct Sphere {
    center: DVec3,
    radius: f64,
    color: DVec3,
    /// Share of the light from shining spheres that is scattered.
    diffuse: f64,
    /// Share of the light from the mirror direction.
    reflected: f64,
    /// Share of the light from the refracted direction.
    transmitted: f64,
    /// How strongly it shines itself.
    emitted: f64,
    /// Refractive index.
    index: f64,
}

/// Light that comes from everywhere.
const AMBIENT: DVec3 = DVec3::splat(0.02);
/// A glass ball before two colored ones, and two great lamps outside the picture.
#[rustfmt::skip]
const SPHERES: [Sphere; 5] = [
    sphere([ 0.0,  6.0,  0.5], 0.9, [1.0, 1.0, 1.0], [0.05, 0.2, 0.85, 0.0 ], 1.7),
    sphere([-1.0,  8.0, -0.5], 1.0, [1.0, 0.5, 0.2], [0.7,  0.3, 0.0,  0.05], 1.2),
    sphere([ 1.0,  8.0, -0.5], 1.0, [0.1, 0.8, 0.8], [0.3,  0.7, 0.0,  0.0 ], 1.2),
    sphere([ 3.0, -6.0, 15.0], 7.0, [1.0, 0.8, 1.0], [0.0,  0.0, 0.0,  0.6 ], 1.5),
    sphere([-3.0, -3.0, 12.0], 5.0, [0.8, 1.0, 1.0], [0.0,  0.0, 0.0,  0.5 ], 1.5),
];
// ANCHOR_END: scene

/// One row of the table.
const fn sphere(center: [f64; 3], radius: f64, color: [f64; 3], shares: [f64; 4], index: f64) -> Sphere {
    let (center, color) = (DVec3::from_array(center), DVec3::from_array(color));
    let [diffuse, reflected, transmitted, emitted] = shares;
    Sphere { center, radius, color, diffuse, reflected, transmitted, emitted, index }
}

// ANCHOR: intersect
/// The nearest sphere along a ray of unit direction, and how far away it is.
fn intersect(origin: DVec3, direction: DVec3) -> Option<(f64, &'static Sphere)> {
    /// Hits nearer than this do not count: the card's cure against acne.
    const NEAREST: f64 = 1e-7;
    let distance = |sphere: &Sphere| {
        let to_center = sphere.center - origin;
        let middle = direction.dot(to_center);
        let half_chord2 = middle * middle - to_center.dot(to_center) + sphere.radius * sphere.radius;
        let half_chord = (half_chord2 > 0.0).then(|| half_chord2.sqrt())?;
        [middle - half_chord, middle + half_chord].into_iter().find(|&t| t > NEAREST)
    };
    let hits = SPHERES.iter().filter_map(|sphere| Some((distance(sphere)?, sphere)));
    hits.min_by(|(a, _), (b, _)| a.total_cmp(b))
}
// ANCHOR_END: intersect

// ANCHOR: trace
/// The light that comes along a ray which may hit `levels` surfaces.
fn trace(levels: u32, origin: DVec3, direction: DVec3) -> DVec3 {
    let Some(levels) = levels.checked_sub(1) else { return DVec3::ZERO };
    let Some((distance, sphere)) = intersect(origin, direction) else { return AMBIENT };
    let point = origin + direction * distance;
    // Turn the normal to face the ray; eta is the index before the surface divided by the index behind it.
    let outward = (point - sphere.center).normalize();
    let is_outside = direction.dot(outward) < 0.0;
    let (normal, eta) = if is_outside { (outward, 1.0 / sphere.index) } else { (-outward, sphere.index) };
    let cosine = -direction.dot(normal);
    // Add each shining sphere whose center is seen from here.
    let mut light = AMBIENT;
    for lamp in &SPHERES {
        let to_lamp = (lamp.center - point).normalize();
        let strength = lamp.emitted * normal.dot(to_lamp);
        let is_seen = || intersect(point, to_lamp).is_some_and(|(_, nearest)| std::ptr::eq(nearest, lamp));
        if strength > 0.0 && is_seen() {
            light += strength * lamp.color;
        }
    }
    // Follow the reflected ray, and the refracted one if there is one.
    let reflected = trace(levels, point, direction + 2.0 * cosine * normal);
    let cosine2_behind = 1.0 - eta * eta * (1.0 - cosine * cosine);
    let transmitted = if cosine2_behind > 0.0 {
        trace(levels, point, eta * direction + (eta * cosine - cosine2_behind.sqrt()) * normal)
    } else {
        DVec3::ZERO
    };
    sphere.emitted * sphere.color
        + sphere.diffuse * light * sphere.color
        + sphere.reflected * reflected
        + sphere.transmitted * transmitted
}
// ANCHOR_END: trace

// ANCHOR: print
/// Width and height of the card's picture, in pixels.
pub const SIDE: u32 = 32;
/// How many surfaces a ray of the card may hit.
pub const LEVELS: u32 = 3;
/// Half of the card's field of view, 25°, in radians.
const HALF_FIELD_OF_VIEW: f64 = 12.5 * std::f64::consts::PI / 180.0;

/// The color at a point of the card's picture, given in its pixels from the upper left one. The eye looks along y.
#[must_use]
pub fn color(column: f64, row: f64, levels: u32) -> DVec3 {
    let half = f64::from(SIDE) / 2.0;
    let through = DVec3::new(column - half, half / float::tan_f64(HALF_FIELD_OF_VIEW), half - row);
    trace(levels, DVec3::ZERO, through.normalize())
}

/// Write the card's picture as a plain PPM file: one line of three numbers for each pixel, row by row from the top.
///
/// # Errors
/// Those of `out`.
pub fn print(out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "P3\n{SIDE} {SIDE}\n255")?;
    for pixel in 0..SIDE * SIDE {
        let [red, green, blue] = (255.0 * color(f64::from(pixel % SIDE), f64::from(pixel / SIDE), LEVELS)).to_array();
        writeln!(out, "{red:.0} {green:.0} {blue:.0}")?;
    }
    Ok(())
}
// ANCHOR_END: print
