//! Walks through a tree of boxes, right ones and some that are not, to compare an answer with.

use common::Interval;
use space_partitioning::query::Found;

use super::hierarchy::{Asking, Content, Node};

/// Which of two halves comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order {
    /// The one in which the ray has the longer way.
    Longer,
    /// The one in which it has the shorter way.
    Shorter,
    /// The one that it enters first.
    Nearer,
    /// The one that it enters last.
    Farther,
    /// The one that comes first in the node.
    Given,
    /// The one that comes second in the node.
    Reversed,
}

/// The halves that a ray meets in `range`, in order, with where it is inside.
fn met(
    nodes: &[Node],
    halves: [usize; 2],
    range: Interval,
    ray: &mut dyn Asking,
    order: Order,
) -> Vec<(usize, Interval)> {
    let mut met: Vec<_> = halves
        .into_iter()
        .filter_map(|half| ray.cross(&nodes[half].aabb, range).map(|inside| (half, inside)))
        .collect();
    let key = |inside: Interval| match order {
        Order::Longer => inside.min - inside.max,
        Order::Shorter => inside.max - inside.min,
        Order::Nearer => inside.min,
        Order::Farther => -inside.min,
        Order::Given | Order::Reversed => 0.0,
    };
    met.sort_by(|(_, a), (_, b)| key(*a).total_cmp(&key(*b)));
    if order == Order::Reversed {
        met.reverse();
    }
    met
}

/// Whether there is any hit, and how the walk went.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AnyHit {
    /// Which half comes first.
    pub(crate) order: Order,
    /// Whether boxes count that lie outside of the range.
    pub(crate) is_endless: bool,
}

impl AnyHit {
    /// The right one.
    pub(crate) const RIGHT: Self = Self { order: Order::Longer, is_endless: false };

    /// Walk. `unclear` becomes true where two ways are nearly equally long.
    pub(crate) fn walk(self, nodes: &[Node], range: Interval, ray: &mut dyn Asking, unclear: &mut bool) -> bool {
        let boxes = if self.is_endless { Interval::new(-1e9, 1e9) } else { range };
        let is_met = nodes.first().is_some_and(|whole| ray.cross(&whole.aabb, boxes).is_some());
        is_met && self.visit(nodes, 0, range, boxes, ray, unclear)
    }

    fn visit(
        self,
        nodes: &[Node],
        number: usize,
        range: Interval,
        boxes: Interval,
        ray: &mut dyn Asking,
        unclear: &mut bool,
    ) -> bool {
        match &nodes[number].content {
            Content::List(list) => list.iter().any(|&number| ray.test(number, range).is_some()),
            Content::Halves(halves) => {
                let met = met(nodes, *halves, boxes, ray, self.order);
                if let [(_, a), (_, b)] = met[..] {
                    let [a, b] = [a, b].map(|inside| inside.max - inside.min);
                    *unclear |= (a - b).abs() < 1e-3 * (a + b);
                }
                met.into_iter().any(|(half, _)| self.visit(nodes, half, range, boxes, ray, unclear))
            }
        }
    }
}

/// The nearest hit, and how the walk goes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NearestHit {
    /// Which half comes first.
    pub(crate) order: Order,
    /// Whether boxes behind the nearest hit so far are left out.
    pub(crate) is_pruned: bool,
    /// Whether the second half is asked about again when the first one is done.
    pub(crate) asks_again: bool,
}

impl NearestHit {
    /// The right one.
    pub(crate) const RIGHT: Self = Self { order: Order::Nearer, is_pruned: true, asks_again: true };

    /// Walk.
    pub(crate) fn walk(self, nodes: &[Node], range: Interval, ray: &mut dyn Asking) -> Option<Found> {
        let mut search = Search { walk: self, whole: range, range, found: None };
        if nodes.first().is_some_and(|whole| ray.cross(&whole.aabb, range).is_some()) {
            search.visit(nodes, 0, ray);
        }
        search.found
    }
}

struct Search {
    walk: NearestHit,
    whole: Interval,
    range: Interval,
    found: Option<Found>,
}

impl Search {
    fn visit(&mut self, nodes: &[Node], number: usize, ray: &mut dyn Asking) {
        match &nodes[number].content {
            Content::List(list) => {
                for &number in list {
                    let Some(t) = ray.test(number, self.range) else { continue };
                    if self.found.is_none_or(|nearest| t < nearest.t || number < nearest.number) {
                        self.found = Some(Found { number, t });
                        self.range = self.range.up_to(t.next_up());
                    }
                }
            }
            Content::Halves(halves) => {
                let boxes = if self.walk.is_pruned { self.range } else { self.whole };
                for (half, inside) in met(nodes, *halves, boxes, ray, self.walk.order) {
                    let is_behind = inside.min > self.range.max;
                    if !(is_behind && self.walk.is_pruned && self.walk.asks_again) {
                        self.visit(nodes, half, ray);
                    }
                }
            }
        }
    }
}
