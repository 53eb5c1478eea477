//! A kd-tree whose planes somebody else chooses: for exercise 4.3.

use common::Interval;
use ray_casting::{aabb::Aabb, ray::Ray};
use space_partitioning::{
    primitives::Primitives,
    probe::Probe,
    query::{Query, Question},
    rounding::{after, before, greater, lesser},
    slabs::Slabs,
    structure::{Cell, Partition, Structure},
};

use super::hierarchy::around;

/// Across which axis a plane halves a cell, and where; `None` to leave the cell whole.
pub(crate) type Choose<'c> = &'c dyn Fn(&Aabb, &[Aabb]) -> Option<(usize, f32)>;

/// A tree of halved cells. The whole is number 0.
pub(crate) struct PlaneTree<E> {
    aabb: Option<Aabb>,
    nodes: Vec<Node<E>>,
}

enum Node<E> {
    List(Vec<E>),
    Halved { axis: usize, position: f32, halves: [usize; 2] },
}

/// No leaf is deeper.
const MOST_LEVELS: u32 = 24;
/// A tree of more nodes does not grow any further, so that a bad choice does not fill the memory.
const MOST_NODES: usize = 100_000;

/// A shape of many primitives behind such a tree.
pub(crate) fn plane_tree<P: Primitives>(primitives: P, choose: Choose<'_>) -> Structure<P, PlaneTree<P::Entry>> {
    let references: Vec<_> = (0..primitives.count()).map(|number| (number, primitives.aabb(number))).collect();
    let aabb = around(references.iter().map(|(_, aabb)| aabb));
    let mut tree = PlaneTree { aabb, nodes: Vec::new() };
    if let Some(aabb) = aabb {
        tree.grow(&primitives, references, aabb, 0, choose);
    }
    Structure { primitives, partition: tree }
}

impl<E> PlaneTree<E> {
    /// Make a node; returns its index.
    fn grow<P: Primitives<Entry = E>>(
        &mut self,
        primitives: &P,
        references: Vec<(u32, Aabb)>,
        cell: Aabb,
        level: u32,
        choose: Choose<'_>,
    ) -> usize {
        let index = self.nodes.len();
        let boxes: Vec<_> = references.iter().map(|(_, aabb)| *aabb).collect();
        let may_grow = level < MOST_LEVELS && index < MOST_NODES && !boxes.is_empty();
        let chosen = if may_grow { choose(&cell, &boxes) } else { None };
        let chosen = chosen.filter(|&(axis, at)| axis < 3 && cell.min[axis] < at && at < cell.max[axis]);
        self.nodes.push(Node::List(references.iter().map(|(number, _)| primitives.entry(*number)).collect()));
        let Some((axis, position)) = chosen else { return index };
        let [mut lower_cell, mut upper_cell] = [cell; 2];
        lower_cell.max[axis] = position;
        upper_cell.min[axis] = position;
        let is_below = |aabb: &Aabb| aabb.min[axis] < position || aabb.max[axis] <= position;
        let is_above = |aabb: &Aabb| aabb.max[axis] > position;
        let [below, above]: [&dyn Fn(&Aabb) -> bool; 2] = [&is_below, &is_above];
        let halves = [(lower_cell, below), (upper_cell, above)].map(|(half, is_there)| {
            let parts = references.iter().filter(|(_, aabb)| is_there(aabb));
            let parts = parts.filter_map(|(number, _)| Some((*number, primitives.clipped(*number, &half)?)));
            self.grow(primitives, parts.collect(), half, level + 1, choose)
        });
        self.nodes[index] = Node::Halved { axis, position, halves };
        index
    }

    /// Visit a node that the ray is in during `inside`. Returns whether the search is over.
    fn visit<P: Primitives<Entry = E>, Q: Question, N: Probe>(
        &self,
        number: usize,
        slabs: &Slabs,
        inside: Interval,
        query: &mut Query<'_, P, Q, N>,
    ) -> bool {
        query.visit(u32::try_from(number).unwrap_or(u32::MAX));
        let (axis, position, halves) = match &self.nodes[number] {
            Node::List(list) => return query.test(list),
            Node::Halved { axis, position, halves } => (*axis, *position, *halves),
        };
        let t = slabs.plane(axis, position);
        let [near, far] = if slabs.inverse[axis] < 0.0 { [halves[1], halves[0]] } else { halves };
        let first = Interval::new(inside.min, lesser(after(t), inside.max));
        let second = Interval::new(greater(before(t), inside.min), inside.max);
        [(near, first), (far, second)].into_iter().any(|(half, inside)| {
            let is_met = inside.min <= inside.max && inside.min <= query.range().max;
            is_met && self.visit(half, slabs, inside, query)
        })
    }
}

impl<P: Primitives> Partition<P> for PlaneTree<P::Entry> {
    fn walk<Q: Question, N: Probe>(&self, ray: &Ray, query: &mut Query<'_, P, Q, N>) {
        let slabs = Slabs::of(ray);
        if let Some(inside) = self.aabb.and_then(|aabb| slabs.cross(&aabb, query.range())) {
            self.visit(0, &slabs, inside, query);
        }
    }

    fn aabb(&self) -> Option<Aabb> {
        self.aabb
    }

    // Nobody draws it.
    fn cells(&self) -> Vec<Cell<'_, P::Entry>> {
        Vec::new()
    }

    fn bytes(&self) -> usize {
        0
    }
}

/// The plane through the median of the middles across the longest side, for cells of more than 8.
pub(crate) fn median(cell: &Aabb, boxes: &[Aabb]) -> Option<(usize, f32)> {
    let axis = (cell.max - cell.min).max_position();
    let mut middles: Vec<_> = boxes.iter().map(|aabb| aabb.center()[axis]).collect();
    middles.sort_by(f32::total_cmp);
    (boxes.len() > 8).then(|| (axis, middles[middles.len() / 2]))
}
