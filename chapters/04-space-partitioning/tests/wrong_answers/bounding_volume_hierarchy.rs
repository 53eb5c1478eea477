//! Wrong bounding volume hierarchies.

use common::{Interval, Vec3, exercise::Verdict};
use ray_casting::aabb::Aabb;
use space_partitioning::query::Found;

use crate::{
    checks::{
        bounding_volume_hierarchy::check,
        hierarchy::{Asking, Content, Node, around, median_tree},
        walks::{NearestHit, Order},
    },
    name,
};

type Build = fn(&[Aabb]) -> Vec<Node>;
type Nearest = fn(&[Node], Interval, &mut dyn Asking) -> Option<Found>;

const BUILD: Build = |boxes| median_tree(boxes, 8);
const NEAREST: Nearest = |nodes, range, ray| NearestHit::RIGHT.walk(nodes, range, ray);

fn by_build(build: Build) -> &'static str {
    name(check(build, NEAREST))
}

fn by_walk(walk: NearestHit) -> &'static str {
    name(check(BUILD, |nodes, range, ray| walk.walk(nodes, range, ray)))
}

#[test]
fn right_ones_are_accepted() {
    let verdict: Verdict = check(BUILD, NEAREST);
    assert_eq!(verdict, Ok(()));
    assert_eq!(check(|boxes| median_tree(boxes, 1), NEAREST), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(name(check(|_| Vec::new(), |_, _, _| None)), "not-started");
    assert_eq!(by_build(|_| Vec::new()), "no-nodes");
    assert_eq!(name(check(BUILD, |_, _, _| None)), "missed");
}

/// Parts the primitives of some numbers.
type Part<'p> = &'p dyn Fn(&[Aabb], &[u32]) -> [Vec<u32>; 2];

/// A tree whose nodes are made by parting numbers with a function.
fn parted(boxes: &[Aabb], few: usize, part: Part<'_>) -> Vec<Node> {
    fn grow(nodes: &mut Vec<Node>, boxes: &[Aabb], numbers: &[u32], few: usize, part: Part<'_>) -> usize {
        let index = nodes.len();
        let aabb = around(numbers.iter().map(|&n| &boxes[n as usize])).unwrap_or(Aabb::EVERYTHING);
        nodes.push(Node { aabb, content: Content::List(numbers.to_vec()) });
        if numbers.len() > few {
            let [lower, upper] = part(boxes, numbers);
            if lower.len() < numbers.len() && upper.len() < numbers.len() {
                let halves = [lower, upper].map(|half| grow(nodes, boxes, &half, few, part));
                nodes[index].content = Content::Halves(halves);
            }
        }
        index
    }
    let (mut nodes, numbers) = (Vec::new(), (0..).take(boxes.len()).collect::<Vec<u32>>());
    if !boxes.is_empty() {
        grow(&mut nodes, boxes, &numbers, few, part);
    }
    nodes
}

/// The numbers in the middle of an order.
fn halved(numbers: &[u32]) -> [Vec<u32>; 2] {
    let (lower, upper) = numbers.split_at(numbers.len() / 2);
    [lower.to_vec(), upper.to_vec()]
}

#[test]
fn trees_that_are_none() {
    assert_eq!(by_build(|boxes| median_tree(boxes, 9)), "long-list");
    // A plane through the middle of the box does not part what lies in one place.
    let by_middle: Build = |boxes| {
        parted(boxes, 8, &|boxes, numbers| {
            let aabb = around(numbers.iter().map(|&n| &boxes[n as usize])).unwrap();
            let axis = (aabb.max - aabb.min).max_position();
            let is_lower = |n: &u32| boxes[*n as usize].center()[axis] < aabb.center()[axis];
            numbers.iter().copied().partition(is_lower).into()
        })
    };
    assert_eq!(by_build(by_middle), "long-list");
    let one_by_one: Build = |boxes| parted(boxes, 8, &|_, numbers| [numbers[..1].to_vec(), numbers[1..].to_vec()]);
    assert_eq!(by_build(one_by_one), "too-deep");
    let both_sides: Build = |boxes| {
        parted(boxes, 8, &|_, numbers| {
            let half = numbers.len() / 2;
            [numbers[..=half].to_vec(), numbers[half..].to_vec()]
        })
    };
    assert_eq!(by_build(both_sides), "listed-twice");
    let loses_one: Build = |boxes| {
        parted(boxes, 8, &|_, numbers| {
            let half = numbers.len() / 2;
            [numbers[..half].to_vec(), numbers[half + 1..].to_vec()]
        })
    };
    assert_eq!(by_build(loses_one), "lost-primitive");
    let pushed_last: Build = |boxes| {
        let mut nodes = BUILD(boxes);
        nodes.reverse();
        nodes
    };
    assert_eq!(by_build(pushed_last), "unused-node");
    // One half twice.
    let same_half: Build = |boxes| {
        let mut nodes = BUILD(boxes);
        for node in &mut nodes {
            if let Content::Halves([lower, upper]) = &mut node.content {
                *upper = *lower;
            }
        }
        nodes
    };
    assert_eq!(by_build(same_half), "not-a-tree");
    let off_by_one: Build = |boxes| {
        let mut nodes = BUILD(boxes);
        for node in &mut nodes {
            if let Content::Halves(halves) = &mut node.content {
                *halves = halves.map(|half| half + 1);
            }
        }
        nodes
    };
    assert_eq!(by_build(off_by_one), "no-such-node");
}

#[test]
fn wrong_boxes() {
    let changed = |boxes: &[Aabb], change: fn(&Node) -> Aabb| {
        BUILD(boxes).iter().map(|node| Node { aabb: change(node), content: node.content.clone() }).collect()
    };
    let of_centers: Build = |boxes| {
        let points: Vec<_> = boxes.iter().map(|b| Aabb { min: b.center(), max: b.center() }).collect();
        median_tree(&points, 8)
    };
    assert_eq!(by_build(of_centers), "box-too-small");
    let from_zero = |boxes: &[Aabb]| {
        changed(boxes, |node| Aabb { min: node.aabb.min.min(Vec3::ZERO), max: node.aabb.max.max(Vec3::ZERO) })
    };
    assert_eq!(name(check(from_zero, NEAREST)), "box-too-large");
    assert_eq!(name(check(|boxes| changed(boxes, |_| Aabb::EVERYTHING), NEAREST)), "box-too-large");
}

#[test]
fn poor_trees() {
    assert_eq!(by_build(|boxes| parted(boxes, 8, &|_, numbers| halved(numbers))), "poor-tree");
    // Always along x.
    let along_x: Build = |boxes| {
        parted(boxes, 8, &|boxes, numbers| {
            let mut numbers = numbers.to_vec();
            numbers.sort_by(|&a, &b| boxes[a as usize].center().x.total_cmp(&boxes[b as usize].center().x));
            halved(&numbers)
        })
    };
    assert_eq!(by_build(along_x), "poor-tree");
}

#[test]
fn wrong_walks() {
    assert_eq!(by_walk(NearestHit { is_pruned: false, ..NearestHit::RIGHT }), "no-pruning");
    assert_eq!(by_walk(NearestHit { asks_again: false, ..NearestHit::RIGHT }), "old-range");
    assert_eq!(by_walk(NearestHit { order: Order::Farther, ..NearestHit::RIGHT }), "far-first");
    assert_eq!(by_walk(NearestHit { order: Order::Given, ..NearestHit::RIGHT }), "fixed-order");
    assert_eq!(by_walk(NearestHit { order: Order::Reversed, ..NearestHit::RIGHT }), "fixed-order");
}

/// A search whose first hit ends it.
fn first_hit(nodes: &[Node], number: usize, range: Interval, ray: &mut dyn Asking) -> Option<Found> {
    ray.cross(&nodes[number].aabb, range)?;
    match &nodes[number].content {
        Content::List(list) => list.iter().find_map(|&number| Some(Found { number, t: ray.test(number, range)? })),
        Content::Halves(halves) => halves.iter().find_map(|&half| first_hit(nodes, half, range, ray)),
    }
}

#[test]
fn wrong_hits() {
    let first: Nearest = |nodes, range, ray| nodes.first().and_then(|_| first_hit(nodes, 0, range, ray));
    assert_eq!(name(check(BUILD, first)), "not-nearest");
    let everywhere: Nearest = |nodes, _, ray| NEAREST(nodes, Interval::POSITIVE, ray);
    assert_eq!(name(check(BUILD, everywhere)), "range-ignored");
    // Of two hits at the same t, the last one tested.
    struct Later<'r>(&'r mut dyn Asking);
    impl Asking for Later<'_> {
        fn cross(&mut self, aabb: &Aabb, range: Interval) -> Option<Interval> {
            self.0.cross(aabb, range)
        }
        fn test(&mut self, number: u32, range: Interval) -> Option<f32> {
            // A range that ends at the hit itself.
            let max = if range.max.is_finite() { range.max.next_down() } else { range.max };
            self.0.test(number, Interval::new(range.min, max))
        }
    }
    let no_tie: Nearest = |nodes, range, ray| NEAREST(nodes, range, &mut Later(ray));
    assert_eq!(name(check(BUILD, no_tie)), "tie");
}
