//! # Exercise 6.2: a lamp with a size
//!
//! A lamp without size is asked at every hit. A lamp with a size can be asked, too: draw a point on it, and look whether it is seen.
//!
//! Which density has this choice? All points of the lamp are equally likely, so per area it is 1 / A. But light is summed over
//! directions. Seen from a hit at distance d, a small piece dA of the lamp covers the solid angle dω = dA cosθ' / d², where θ' is the
//! angle between the line of sight and the normal **of the lamp**. So the density per steradian is
//!
//! ```text
//! p = d² / (A cosθ')
//! ```
//!
//! and one sample of the light that a matte surface sends on is `k_d L cosθ / p`, or 0 where the point is not seen. Here θ is the
//! angle at the surface.
//!
//! Now the lamp may be found in two ways: it is asked, and the path may hit it by chance. Its light must count once. So it does
//! **not** count where a path hits the lamp after a diffuse step, because the last hit has asked it. It **does** count where nobody
//! has asked: on a camera ray, and after a mirror step.
//!
//! ## Your task
//!
//! Fill in the three functions below. The lamp is flat, has four corners, and glows on both sides:
//!
//! ```text
//! struct Lamp { corner: Vec3, edges: [Vec3; 2], radiance: Rgb }
//! struct LampSample { direction: Vec3, distance: f32, density: f32 }
//! ```
//!
//! Its points are `corner + x · edges[0] + y · edges[1]`, with x and y from 0 to 1. The cross product of the two edges is a normal of
//! the lamp, and its length is the area A. The edges need not meet at a right angle.
//!
//! - `sample_lamp` makes of a uniform point `u` of the unit square a uniform point of the lamp, and tells how it is seen `from`
//!   another point: the unit vector toward it, its distance, and the density per steradian. The lamp glows on both sides, so cosθ'
//!   is never negative. Where there is no density, because `from` lies in the plane of the lamp, `density` is 0, and no number is NaN.
//! - `lamp_light` is one sample of the lamp's light that a matte surface sends on from a hit. Draw a point with
//!   `sample_unit_square(random)`, and look at it from `hit.position`. `world.lamp` is the lamp. `world.sees(hit, &sample)` sends a
//!   shadow ray. `material.diffuse` is k_d, the albedo divided by π already, and `hit.shading_normal` the normal. A lamp below the
//!   surface gives no light, nor does a sample with the density 0.
//! - `radiance` is one sample of what comes back along a ray. Its loop is that of the path tracer, and is there already. It finds
//!   the lamp by chance alone. Let it ask the lamp at every hit, too, and count nothing twice. Ask before the step: `world.step`
//!   plays roulette, and where it ends the path with `None`, the hit was lit all the same. `surface.is_lamp` says whether the lamp
//!   was hit. Other things may glow as well; nobody asks them, so their light always counts. `kind` is `Kind::Diffuse` or
//!   `Kind::Mirror`: the kind of the step that leads on from this hit. The next hit has to know it.
//!
//! ## When you are done
//!
//! `cargo exercise 6.2` checks your lamp and renders a stage in its light. With the lamp found by chance it would be much noisier.

use std::process::ExitCode;

use common::{
    Rgb, Stream, Vec2, Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};
use path_tracing::{material::Material, roulette::Kind};
use ray_casting::{hit::Hit, ray::Ray};
use sampling::unit_square::sample_unit_square;

use checks::{
    lamp::{Lamp, LampSample},
    lamp_world::LampWorld,
};

/// A random point of the lamp, as it is seen `from` somewhere.
fn sample_lamp(lamp: &Lamp, from: Vec3, u: Vec2) -> LampSample {
    let _ = (lamp, from, u); // take this line away when you start
    LampSample { direction: Vec3::Y, distance: 1.0, density: 0.0 }
}

/// One sample of the light of the lamp that a surface sends on from a hit.
fn lamp_light(world: &LampWorld, material: &Material, hit: &Hit, random: &mut Stream) -> Rgb {
    let _ = (world, material, hit); // take this line away when you start
    let _ = sample_unit_square(random); // a random point of the unit square
    Rgb::ZERO
}

/// One sample of the radiance that comes back along a ray.
fn radiance(world: &LampWorld, ray: Ray, random: &mut Stream) -> Rgb {
    let (mut ray, mut radiance, mut throughput) = (ray, Rgb::ZERO, Rgb::ONE);
    for _ in 0..LampWorld::MOST_BOUNCES {
        let Some((hit, surface)) = world.intersect(&ray) else {
            return radiance + throughput * world.sky(ray.direction);
        };
        // Add what the surface itself sends out.
        radiance += throughput * surface.material.emission;
        // Take a step on.
        let Some((step, kind)) = world.step(&surface.material, &hit, -ray.direction, random) else { break };
        let _ = kind == Kind::Diffuse; // the kind of this step
        throughput *= step.weight;
        ray = world.next_ray(&hit, &step);
    }
    radiance
}

// From here on your lamp is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

use checks::area_light::Answer;

/// What you have written.
const ANSWER: Answer = Answer { sample_lamp, lamp_light, radiance };

/// What your lamp looks like.
const PICTURE: Picture = pictures::area_light::picture(|settings| pictures::area_light::make(settings, radiance));

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your lamp is right.
fn accepted() -> Verdict {
    checks::area_light::check(ANSWER)
}
