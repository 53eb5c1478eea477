//! What a message is like, whatever the mistake.

use common::{Interval, Vec3};
use ray_casting::{hit::Hit, ray::Ray};

use crate::{Answer, checks};

#[test]
fn a_message_says_what_was_tried_what_came_out_and_what_was_expected() {
    let floor = |_: Vec3, n: Vec3| {
        Answer(move |ray: &Ray, range: Interval| {
            let t = -ray.origin.dot(n) / ray.direction.dot(n);
            range.contains(t).then(|| Hit::new(ray, t, n))
        })
    };
    let message = checks::plane::check(floor).unwrap_err().to_string();
    let expected = "\
Tried:    the ray from (0, 3, 0) in direction (0, -1, 0), range 0 < t < ∞, at the plane through
          (0, 1, 0) with normal (0, 1, 0)
Got:      a hit at t = 3, position (0, 0, 0), normal (0, 1, 0), Side::Outside
Expected: a hit at t = 2 (the plane), normal (0, 1, 0), Side::Outside

This plane does not go through the origin of space. Does your formula use its `point`? [point-ignored]";
    assert_eq!(message, expected);
}
