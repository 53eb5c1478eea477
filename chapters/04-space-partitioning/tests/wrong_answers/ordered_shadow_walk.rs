//! Wrong shadow walks.

use common::{
    Interval, Vec3,
    exercise::{Verdict, dice::Dice},
};
use ray_casting::ray::Ray;

use crate::{
    checks::{
        hierarchy::{Asker, Asking, Content, Node, boxes, median_tree},
        meshes::bush,
        ordered_shadow_walk::check,
    },
    name,
};

/// What goes wrong in a walk.
#[derive(Clone, Copy)]
struct Walk {
    /// The half with the greater key comes first.
    key: fn(Interval, f32) -> f32,
    /// The range that boxes are asked with.
    boxes: fn(Interval) -> Interval,
    /// The range that primitives are asked with.
    tests: fn(Interval) -> Interval,
    /// Whether a hit ends the walk.
    ends: bool,
    /// Whether both halves are visited.
    both: bool,
}

const RIGHT: Walk =
    Walk { key: |part, _| part.max - part.min, boxes: |range| range, tests: |range| range, ends: true, both: true };

impl Walk {
    fn walk(self, nodes: &[Node], range: Interval, ray: &mut dyn Asking) -> bool {
        let Some(whole) = nodes.first() else { return false };
        ray.cross(&whole.aabb, (self.boxes)(range)).is_some() && self.visit(nodes, 0, range, ray)
    }

    fn visit(self, nodes: &[Node], number: usize, range: Interval, ray: &mut dyn Asking) -> bool {
        let mut is_hit = false;
        match &nodes[number].content {
            Content::List(list) => {
                for &number in list {
                    is_hit |= ray.test(number, (self.tests)(range)).is_some();
                    if is_hit && self.ends {
                        return true;
                    }
                }
            }
            Content::Halves(halves) => {
                let mut met: Vec<_> = (0..2_u8)
                    .filter_map(|i| {
                        let half = halves[usize::from(i)];
                        let part = ray.cross(&nodes[half].aabb, (self.boxes)(range))?;
                        Some(((self.key)(part, f32::from(i)), half))
                    })
                    .collect();
                met.sort_by(|a, b| b.0.total_cmp(&a.0));
                met.truncate(if self.both { 2 } else { 1 });
                for (_, half) in met {
                    is_hit |= self.visit(nodes, half, range, ray);
                    if is_hit && self.ends {
                        return true;
                    }
                }
            }
        }
        is_hit
    }
}

fn verdict(walk: Walk) -> Verdict {
    check(move |nodes, range, ray| walk.walk(nodes, range, ray))
}

fn diagnosis(walk: Walk) -> &'static str {
    name(verdict(walk))
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(verdict(RIGHT), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(name(check(|_, _, _| false)), "not-started");
}

#[test]
fn wrong_orders() {
    let by = |key| diagnosis(Walk { key, ..RIGHT });
    assert_eq!(by(|part, _| part.min - part.max), "shorter-first");
    assert_eq!(by(|part, _| -part.min), "near-first");
    assert_eq!(by(|part, _| part.min), "far-first");
    assert_eq!(by(|_, i| -i), "fixed-order");
    assert_eq!(by(|_, i| i), "fixed-order");
    assert_eq!(by(|part, _| part.max), "wrong-order");
}

#[test]
fn wrong_ranges() {
    let whole = |_| Interval::new(-1e9, 1e9);
    assert_eq!(diagnosis(Walk { tests: whole, ..RIGHT }), "beyond-the-light");
    assert_eq!(diagnosis(Walk { tests: |range| Interval::new(0.0, range.max), ..RIGHT }), "range-min-ignored");
    assert_eq!(diagnosis(Walk { boxes: whole, ..RIGHT }), "box-beyond-the-light");
    assert_eq!(diagnosis(Walk { boxes: |_| Interval::POSITIVE, ..RIGHT }), "boxes-ignored");
    assert_eq!(diagnosis(Walk { tests: |range| Interval::new(range.min, range.max * 0.5), ..RIGHT }), "missed");
}

#[test]
fn wrong_ends() {
    assert_eq!(diagnosis(Walk { ends: false, ..RIGHT }), "goes-on");
    assert_eq!(diagnosis(Walk { both: false, ..RIGHT }), "missed");
    assert_eq!(
        name(check(|nodes, range, ray| nodes.first().is_some_and(|n| ray.cross(&n.aabb, range).is_some()))),
        "phantom"
    );
    // Every list, box or not.
    let all = |nodes: &[Node], range: Interval, ray: &mut dyn Asking| {
        nodes.iter().any(|node| match &node.content {
            Content::List(list) => list.iter().any(|&number| ray.test(number, range).is_some()),
            Content::Halves(_) => false,
        })
    };
    assert_eq!(name(check(all)), "boxes-ignored");
    // The box of the whole is not asked about.
    let no_root =
        |nodes: &[Node], range: Interval, ray: &mut dyn Asking| !nodes.is_empty() && RIGHT.visit(nodes, 0, range, ray);
    assert_eq!(name(check(no_root)), "boxes-ignored");
}

#[test]
fn the_longer_way_first_saves_a_sixth_of_the_tests_in_a_bush() {
    let triangles = bush(2000);
    let nodes = median_tree(&boxes(&triangles), 4);
    let mut dice = Dice::new(446);
    let [mut by_length, mut by_distance] = [0; 2];
    for _ in 0..2000 {
        // From the floor and from inside of the bush toward the sun.
        let origin = dice.point(2.0) * Vec3::new(1.0, 0.5, 1.0) + Vec3::Y;
        let ray = Ray::new(origin, Vec3::new(-0.75, 0.6, 0.25));
        for (walk, sum) in [(RIGHT, &mut by_length), (Walk { key: |part, _| -part.min, ..RIGHT }, &mut by_distance)] {
            let mut asker = Asker::new(&triangles, &ray);
            walk.walk(&nodes, Interval::POSITIVE, &mut asker);
            *sum += asker.tests.len();
        }
    }
    assert!(by_length * 6 < by_distance * 5, "{by_length} {by_distance}");
}
