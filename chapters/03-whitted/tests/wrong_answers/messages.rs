//! What messages are like, whatever the mistake.

use common::{Rgb, Vec3};

use crate::checks;

#[test]
fn a_message_says_what_was_tried_what_came_out_and_what_was_expected() {
    let is_dark: fn(Vec3, f32) -> bool = |p, size| (p / size).floor().element_sum() % 2.0 == 1.0;
    let answer = checks::checkerboard::Answer { is_dark, is_dark_at: |_, _| false };
    let message = checks::checkerboard::check(answer).unwrap_err().to_string();
    let expected = "\
Tried:    `is_dark` of the point (-3.67, -4.44, -1.85) with size 1, which lies in the cube
          (-4, -5, -2)
Got:      light
Expected: dark

All cubes at negative coordinates are light. Does your code take `%` there? It keeps the sign: −3 %
2 is −1, not 1, and `rem_euclid` gives 1. Or does it make unsigned numbers of them? `as u32` turns
all that is negative into 0. [remainder-negative]";
    assert_eq!(message, expected);
}

#[test]
fn a_search_is_told_how_many_rays_it_followed() {
    let message = checks::budget::check(|world, ray, _| {
        let surface = world.follow(&ray);
        ray.share * surface.radiance + Rgb::ZERO
    });
    let message = message.unwrap_err().to_string();
    assert!(message.contains("Got:      1 ray followed\nExpected: 4 rays followed"), "{message}");
}
