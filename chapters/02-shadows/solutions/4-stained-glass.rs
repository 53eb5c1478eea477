//! # Exercise 2.4: stained glass
//!
//! So far whatever stands in the way of the light blocks it, and a church window casts the shadow of a brick wall. But
//! glass lets light through, and colors it. Of each color a pane passes a certain share, its transmittance: red glass
//! perhaps (0.8, 0.1, 0.1). Of what one pane has left over, the next one passes its share again:
//!
//! ```text
//! what arrives = transmittance of the first · transmittance of the second · …      channel by channel
//! ```
//!
//! A product does not ask for the order. So the panes need not be found from the nearest to the farthest: it is enough to
//! find all of them. What is opaque is glass with the transmittance 0.
//!
//! The panes here are so thin that light goes straight on. (How light is bent in thick glass, chapter 3 tells.) Every time
//! the light passes through a surface it counts: the wall of a hollow glass ball twice, once in and once out.
//!
//! To find the hit after a hit there are two ways. You can start a new ray behind the surface: then it needs an offset
//! again, and what stands closer than that is lost. Or you keep the ray and move the beginning of the range to the hit.
//! The range is open, and the same ray meets the same surface at the same `t`, to the last bit: so it counts once, and
//! nothing behind it is lost.
//!
//! ## Your task
//!
//! Fill in `light_through` below. What stands there is how chapter 2 does it: all or nothing. The scene's materials are
//! transmittances, `object.material`, and `scene.objects` is the list of all things.
//!
//! - The answer is the product of the transmittances of all surfaces between the hit and the light, one factor for each
//!   time that the shadow ray meets a surface. If there are none it is 1 in all channels. `light.strength` is not in it.
//! - What is behind the point or beyond the light does not count. The sun is infinitely far away.
//! - An opaque thing, before, between or behind panes, makes it exactly 0.
//! - One object may be hit many times: a ball, or a whole window. Every pane counts, and none of them counts twice.
//! - Two objects may lie in the very same place. Both count. (How do you ask for the second, after the first?)
//! - There may be thousands of panes, and they may be so close together that their `t` differ in the last digits only. No
//!   fixed limit, and nothing that you add to `t`.
//! - However little light is left, it counts.
//! - Your loop must end, also with clear glass, of transmittance 1, and also when the light stands in the point itself:
//!   then `direction` is a NaN, `distance` is 0, and nothing is in between.
//! - The ray starts above the surface as in `is_in_shadow`: on the side of the geometric normal, by an offset that follows
//!   the numbers, such as `Offset::Following`. A pane may lie 0.00005 scene units above the point.
//!
//! ## When you are done
//!
//! `cargo exercise 2.4` checks your function and lets the sun shine through a stained glass window.

use std::process::ExitCode;

use common::{
    Interval, Rgb,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::{hit::Hit, light::Illumination, ray::Ray, scene::Scene};
use shadows::offset::Offset;

/// The share of the light that arrives at `hit`, 0 to 1 for each channel. The material of each object in the scene is its
/// transmittance.
fn light_through(scene: &Scene<Rgb>, hit: &Hit, light: &Illumination) -> Rgb {
    // STUB: let _ = (Interval::POSITIVE, Ray::new); // you will need these
    // STUB: let is_in_shadow = shadows::shadow_ray::is_in_shadow(scene, hit, light, Offset::Following);
    // STUB: if is_in_shadow { Rgb::ZERO } else { Rgb::ONE }
    let ray = Ray::new(Offset::Following.origin(hit, hit.geometric_normal), light.direction);
    let mut arrives = Rgb::ONE;
    // The order does not matter, so ask one object after the other: none can hide another.
    for object in &scene.objects {
        let mut range = Interval::POSITIVE.up_to(light.distance);
        while let Some(hit) = object.shape.intersect(&ray, range) {
            arrives *= object.material;
            if arrives == Rgb::ZERO {
                return Rgb::ZERO;
            }
            // Go on behind this hit. The range is open, so it cannot come back.
            range.min = hit.t;
        }
    }
    arrives
    // END STUB
}

// From here on your function is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What comes through your glass.
const PICTURE: Picture =
    pictures::stained_glass::picture(|settings| pictures::stained_glass::make(settings, light_through));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your function is right.
fn accepted() -> Verdict {
    checks::stained_glass::check(light_through)
}
