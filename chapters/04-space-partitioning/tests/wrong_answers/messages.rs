//! What a message is like, whatever the mistake.

use common::Vec3;
use ray_casting::ray::Ray;

use crate::checks::{
    bounding_sphere::{self, Ball},
    hierarchy::{Asking, Content, Node},
    ordered_shadow_walk,
};

#[test]
fn a_message_says_what_was_tried_what_came_out_and_what_was_expected() {
    let around = |points: &[Vec3]| {
        let center = points.iter().sum::<Vec3>() / points.len() as f32;
        Ball { center, radius: points.iter().map(|p| p.distance(center)).fold(0.0, f32::max) * 1.001 }
    };
    let message = bounding_sphere::check(around, |_, _: &Ray, _| false).unwrap_err().to_string();
    let expected = "\
Tried:    a ball around the points (1, 2, 3), (1, -4, 3), (1, 0, 3)
Got:      the ball around (1, -0.6666667, 3) with radius 3.3366668
Expected: a ball that holds all points, and of radius 3.03 at most: 3 is enough around (1, -1, 3)

The mean of all points lies where most of them are, and that is not the middle. Take the center of
the smallest box around them. [mean-center]";
    assert_eq!(message, expected);
}

#[test]
fn a_walk_is_told_by_the_numbers_of_its_tests() {
    fn visit(nodes: &[Node], number: usize, range: common::Interval, ray: &mut dyn Asking) -> bool {
        ray.cross(&nodes[number].aabb, range).is_some()
            && match &nodes[number].content {
                Content::List(list) => list.iter().any(|&number| ray.test(number, range).is_some()),
                Content::Halves(halves) => halves.iter().any(|&half| visit(nodes, half, range, ray)),
            }
    }
    let check = ordered_shadow_walk::check(|nodes, range, ray| !nodes.is_empty() && visit(nodes, 0, range, ray));
    let message = check.unwrap_err().to_string();
    assert!(message.starts_with("Tried:    the ray from ("), "{message}");
    assert!(message.contains("\nGot:      tested in this order: "), "{message}");
    assert!(message.ends_with("[fixed-order]"), "{message}");
}
