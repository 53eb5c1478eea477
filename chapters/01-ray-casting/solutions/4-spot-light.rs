//! # Exercise 1.4: a spot light
//!
//! A point light shines in all directions alike. A stage lamp does not: its light fills a cone, at full strength in the
//! middle, and fades toward the edge.
//!
//! The lamp has an axis, the direction in which it shines. Let θ be the angle between the axis and the way from the lamp to
//! the point that is lit. Up to the inner angle all the light arrives, beyond the outer angle none, and between them
//!
//! ```text
//! x     = (cos θ − cos outer) / (cos inner − cos outer)      from 0 at the outer to 1 at the inner angle
//! share = x² · (3 − 2x)                                      the same, but without visible edges
//! ```
//!
//! Both angles are measured from the axis; the whole cone is twice as wide. The cosine of θ is a dot product, so that no
//! arc cosine is needed. What arrives is the share times the light of a point light: intensity / distance².
//!
//! ## Your task
//!
//! Fill in `SpotLight::illuminate` below. You may change the fields and `SpotLight::new`, for instance to compute the two
//! cosines once. The book's page *Lights* and `chapters/01-ray-casting/src/light.rs` show the point light.
//!
//! - `direction` is the unit vector from the point **toward** the light, `distance` the way there in scene units.
//!   Both must be right in the dark too, where `strength` is zero.
//! - `strength` is intensity / distance² · share. The outer angle is at most 90°, so behind the lamp no light arrives.
//! - The axis given to `new` may have any length but zero. Angles come in degrees, `common::float::cos` takes radians:
//!   `angle.to_radians()`.
//! - When both angles are the same, the cone has a sharp edge: up to the angle and on the edge itself all the light
//!   arrives, beyond it none. Nothing becomes a NaN, not even on the edge.
//!
//! Why `common::float::cos` and not `f32::cos`? The latter differs in its last bits from machine to machine.
//!
//! ## When you are done
//!
//! `cargo exercise 1.4` checks your light and renders a stage under three colored lamps.

use std::process::ExitCode;

use common::{
    Rgb, Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::light::{Illumination, Light};

/// A light that shines from one point into a cone.
struct SpotLight {
    /// Where it is, in scene units.
    position: Vec3,
    // STUB: /// The direction in which it shines, of any length but zero.
    /// The direction in which it shines: a unit vector.
    // END STUB
    axis: Vec3,
    /// Radiant intensity along the axis. At distance 1 it gives an irradiance of the same number.
    intensity: Rgb,
    // STUB: /// Up to this angle from the axis all the light arrives, in degrees.
    // STUB: inner: f32,
    // STUB: /// Beyond this angle from the axis no light arrives, in degrees.
    // STUB: outer: f32,
    /// Cosine of the angle up to which all the light arrives.
    cos_inner: f32,
    /// Cosine of the angle beyond which no light arrives.
    cos_outer: f32,
    // END STUB
}

impl SpotLight {
    /// A light at `position` that shines along `axis`; `inner` and `outer` are angles from the axis in degrees.
    fn new(position: Vec3, axis: Vec3, intensity: Rgb, inner: f32, outer: f32) -> Self {
        // STUB: Self { position, axis, intensity, inner, outer }
        let [cos_inner, cos_outer] = [inner, outer].map(|angle| common::float::cos(angle.to_radians()));
        Self { position, axis: axis.normalize_or(-Vec3::Y), intensity, cos_inner, cos_outer }
        // END STUB
    }
    // STUB:

    /// The share of the light that the cone lets through at an angle from the axis with that cosine.
    fn share(&self, cosine: f32) -> f32 {
        // Inside first: with equal angles the division below is then by zero, but of a negative number, and −∞ becomes 0.
        if cosine >= self.cos_inner {
            return 1.0;
        }
        let x = ((cosine - self.cos_outer) / (self.cos_inner - self.cos_outer)).max(0.0);
        x * x * (3.0 - 2.0 * x)
    }
    // END STUB
}

impl Light for SpotLight {
    fn illuminate(&self, point: Vec3) -> Illumination {
        // STUB: // Take this line away when you start:
        // STUB: let _ = (self.position, self.axis, self.intensity, self.inner, self.outer, point);
        // STUB: Illumination { direction: Vec3::Y, distance: f32::INFINITY, strength: Rgb::ZERO }
        // As for a point light …
        let to_light = self.position - point;
        let distance_squared = to_light.length_squared();
        let distance = distance_squared.sqrt();
        let direction = to_light / distance;
        // … but only the share that the cone lets through. The light travels against `direction`.
        let share = self.share(-direction.dot(self.axis));
        Illumination { direction, distance, strength: self.intensity * share / distance_squared }
        // END STUB
    }
}

// From here on your light is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your light shows.
const PICTURE: Picture = pictures::spot_light::picture(|settings| pictures::spot_light::make(settings, SpotLight::new));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your light is right.
fn accepted() -> Verdict {
    checks::spot_light::check(SpotLight::new)
}
