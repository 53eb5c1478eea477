//! What a message is like, whatever the mistake.

use common::Rgb;
use ray_casting::{hit::Hit, light::Illumination, scene::Scene};
use shadows::{offset::Offset, shadow_ray::is_in_shadow};

use crate::checks;

#[test]
fn a_message_says_what_was_tried_what_came_out_and_what_was_expected() {
    // Right for one pane and for opaque things, but every pane is red.
    let red = |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
        let is_lit = !is_in_shadow(scene, hit, light, Offset::Following);
        if is_lit { Rgb::ONE } else { Rgb::new(0.8, 0.3, 0.1) }
    };
    let message = checks::stained_glass::check(red).unwrap_err().to_string();
    let expected = "\
Tried:    the hit at (0.1, 0, 0.2) with normal (0, 1, 0) on an opaque floor at y = 0, light in
          direction (0.6, 0.8, 0) at distance 10, a level pane of transmittance (0.4, 0.9, 0.3) at y
          = 2, a level pane of transmittance (0.2, 0.5, 0.7) at y = 2.5 and y = 1.5 and y = 2.8, a
          level pane of transmittance (0.8, 0.3, 0.1) at y = 1, a level pane of transmittance
          (0.6, 0.4, 0.8) at y = 3, a level pane of transmittance (0.9, 0.2, 0.4) at y = 9, a level
          pane of transmittance (0.7, 0.6, 0.2) at y = -1
Got:      (0.8, 0.3, 0.1)
Expected: (0.001536, 0.0135, 0.008232)

Only the nearest pane counts here. Go on behind it, until nothing is hit any more. [nearest-only]";
    assert_eq!(message, expected);
}
