//! Surroundings worth a mirror: an evening sky over the sea.

use common::{Rgb, Vec3, float};
use ray_casting::background::Background;

use crate::fresnel;

// ANCHOR: sky
/// The sky after a warm day, with a low sun and streaks of cloud, and the sea that mirrors it.
pub(super) struct Evening {
    /// Unit vector toward the sun.
    pub(super) sun: Vec3,
}

impl Background for Evening {
    fn radiance(&self, direction: Vec3) -> Rgb {
        let direction = direction.normalize();
        if direction.y >= 0.0 { self.sky(direction) } else { self.sea(direction) }
    }
}

impl Evening {
    /// What comes from above the horizon.
    fn sky(&self, direction: Vec3) -> Rgb {
        // How near the sun is: 1 in its direction, 0 opposite.
        let near = direction.dot(self.sun) / 2.0 + 0.5;
        let height = direction.y;
        // From the horizon up: warm, rosy, violet.
        let horizon = Rgb::new(0.60, 0.30, 0.24).lerp(Rgb::new(1.0, 0.60, 0.20), near);
        let middle = Rgb::new(0.055, 0.075, 0.22).lerp(Rgb::new(0.66, 0.36, 0.24), near * near);
        let zenith = Rgb::new(0.055, 0.06, 0.17);
        let clear = horizon.lerp(middle, smooth(-0.04, 0.14, height)).lerp(zenith, smooth(0.10, 0.8, height));
        // Clouds glow toward the sun and are dusky elsewhere.
        let glowing = Rgb::new(0.42, 0.17, 0.20).lerp(Rgb::new(1.1, 0.66, 0.30), near * near);
        let cloudy = clear.lerp(glowing, clouds(direction));
        // The sun, with a halo.
        let halo = float::pow(near, 60.0);
        let disc = smooth(0.9975, 0.9987, direction.dot(self.sun));
        cloudy + Rgb::new(0.55, 0.30, 0.10) * halo + Rgb::new(14.0, 10.0, 6.0) * disc
    }
    // ANCHOR_END: sky

    /// What comes from below: the mirrored sky, the more the flatter the view, over deep water.
    fn sea(&self, direction: Vec3) -> Rgb {
        let depth = -direction.y;
        // Waves tilt the mirror, far ones less to be seen.
        let across = direction * (1.0 / (depth + 0.02));
        let wave =
            float::sin(across.x * 3.0 + 2.0 * float::sin(across.z * 1.7)) * float::sin(across.z * 9.0 + across.x);
        let mirrored = direction.with_y(depth * (1.0 + 0.35 * wave)).normalize();
        let share = 0.75 * fresnel::approximate(depth, 0.02);
        Rgb::new(0.012, 0.035, 0.055).lerp(self.sky(mirrored), share)
    }
}

/// How much cloud there is in a direction above the horizon, from 0 to 1.
fn clouds(direction: Vec3) -> f32 {
    // Where the view meets a layer of cloud; far streaks lie close together.
    let across = direction * (1.0 / (direction.y + 0.12));
    let (x, z) = (across.x + 0.3 * across.z, across.z);
    // Waves of several lengths, each bent by the one before.
    let long = float::sin(0.55 * x + 1.3 * z + 0.7);
    let medium = float::sin(1.1 * x - 2.9 * z + 2.0 * long);
    let short = float::sin(3.1 * x + 6.3 * z + 2.4 * medium);
    let streaks = smooth(-0.2, 1.3, long + 0.7 * medium + 0.35 * short);
    // Few overhead.
    streaks * (1.0 - 0.8 * smooth(0.4, 0.9, direction.y))
}

/// From 0 below `start` to 1 above `end`, without a kink.
fn smooth(start: f32, end: f32, x: f32) -> f32 {
    let t = ((x - start) / (end - start)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
