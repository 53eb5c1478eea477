//! # Exercise 2.3: soft shadows
//!
//! The lights of these chapters have no size, and so a point sees them or does not: shadows have edges like cut with a
//! knife. A real lamp has a surface. Between light and shadow there are points that see a part of it: the penumbra.
//!
//! Our lamp is a flat panel, a parallelogram with a frosted front. It has a corner and two edges that start there, and
//! every bit of its front looks equally bright from all sides: it sends the same radiance L in all directions. To find out
//! what arrives at a point, take n·n small parts of the panel and let one place in each stand for all of it:
//!
//! ```text
//! place      = corner + u·edges[0] + v·edges[1],   u = (column + jitter.x) / n,   v = (row + jitter.y) / n
//! irradiance = mean of   L · A · (N·ω)⁺ · (M·−ω)⁺ / distance²   where the place is seen, and 0 where it is hidden
//! ```
//!
//! A is the area of the panel. ω is the unit vector toward the place. N is the normal of the lit surface, M that of the
//! panel's front. So each place is a little point light, with one more cosine than the point light of chapter 1: a panel
//! that is seen from the side looks smaller, and gives less light. The mean goes over all n·n places,
//! the hidden ones too.
//!
//! Places in the middle of the parts would do, but then the penumbra is a staircase of n·n steps. So every place is shaken
//! within its part by random numbers, other ones for each pixel, which turns the steps into fine noise. (Chapter 5 shows
//! why that gives the right mean.) Your function never throws dice itself: the numbers are handed to it.
//!
//! ## Your task
//!
//! Fill in `Panel::light` below. The book's page *Direct light* and `chapters/02-shadows/src/shadow_ray.rs` show much of
//! what you need. `is_in_shadow` takes an `Illumination`, which is what one place gives.
//!
//! - `jitter` has n·n entries from (0, 0) to below (1, 1). That of the part in column c and row r is `jitter[r * n + c]`.
//!   n is from 1 to 255.
//! - `visible` is the share of the n·n places from which light arrives: those that lie above the horizon, N·ω > 0, turn
//!   their front to the point, M·−ω > 0, and have nothing in the way.
//! - What lies beyond the place on the panel casts no shadow.
//! - ω and the distance are measured from `hit.position` to the place. (Only the shadow ray starts a little above.)
//! - N is `hit.shading_normal`, since brightness is computed with that. Shadow rays start on the side to which the
//!   geometric normal points, by an offset that follows the numbers: `is_in_shadow` with `Offset::Following` does. No
//!   fixed offset will do: the panel lights things as small as a grain of dust, and things 100,000 scene units away.
//! - The front is the side to which `edges[0] × edges[1]` points. That vector is at right angles to the panel, and its
//!   length is the area. So it is A·M, and you need no more than that.
//! - A panel whose edges are parallel has no area. From it no light arrives, and neither does a NaN.
//! - The panel is no object of the scene. It hides nothing.
//!
//! ## When you are done
//!
//! `cargo exercise 2.3` checks your function and renders slender columns beside a shining panel.

use std::process::ExitCode;

use common::{
    Rgb, Vec2, Vec3,
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::{hit::Hit, light::Illumination, scene::Scene};
use shadows::{offset::Offset, shadow_ray::is_in_shadow};

/// A lamp with a surface: a parallelogram that shines on one side.
struct Panel {
    /// One corner, in scene units.
    corner: Vec3,
    /// From there to both neighboring corners. The front is where their cross product points to.
    edges: [Vec3; 2],
    /// The radiance of the front, the same in all directions.
    radiance: Rgb,
}

/// What arrives from a panel.
struct Arrival {
    /// The share of the panel that is seen, 0 to 1.
    visible: f32,
    /// The irradiance on the surface: linear RGB, power per area.
    irradiance: Rgb,
}

impl Panel {
    /// What arrives at `hit` from n·n places on the panel, each shaken within its part by its entry of `jitter`.
    fn light<M>(&self, scene: &Scene<M>, hit: &Hit, n: u16, jitter: &[Vec2]) -> Arrival {
        // Take these two lines away when you start:
        let _ = (self.corner, self.edges, self.radiance, scene, hit, n, jitter, Offset::Following);
        let _ = |light: &Illumination| is_in_shadow(scene, hit, light, Offset::Following);
        Arrival { visible: 0.0, irradiance: Rgb::ZERO }
    }
}

// From here on your panel is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your panel lights.
const PICTURE: Picture = pictures::soft_shadows::picture(|settings| pictures::soft_shadows::make(settings, light));

/// Your panel as a function: from corner and edges, radiance, scene, hit, n and jitter to the share that is seen and the
/// irradiance.
fn light<M>(
    [corner, first, second]: [Vec3; 3],
    radiance: Rgb,
    scene: &Scene<M>,
    hit: &Hit,
    n: u16,
    jitter: &[Vec2],
) -> (f32, Rgb) {
    let Arrival { visible, irradiance } =
        Panel { corner, edges: [first, second], radiance }.light(scene, hit, n, jitter);
    (visible, irradiance)
}

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your panel is right.
fn accepted() -> Verdict {
    checks::soft_shadows::check(light)
}
