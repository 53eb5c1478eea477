//! A tree of boxes, and a ray that asks about them: for exercises 4.4 and 4.6.

use common::Interval;
use ray_casting::{aabb::Aabb, ray::Ray};
use space_partitioning::{primitives::Primitives, slabs::Slabs, triangles::Triangles};

/// A part of a tree of boxes: a box, and what is in it. A tree is a list of nodes. The whole is number 0; a list without
/// nodes is a tree with nothing in it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Node {
    /// The box around all that is in it.
    pub(crate) aabb: Aabb,
    /// What is in it.
    pub(crate) content: Content,
}

/// What is in a node.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Content {
    /// Two other nodes, by their numbers in the list of all nodes. Their boxes may overlap.
    Halves([usize; 2]),
    /// Primitives, by their numbers.
    List(Vec<u32>),
}

/// A ray that asks about boxes and primitives, and counts.
pub(crate) trait Asking {
    /// The part of `range` in which the ray is inside the box, or a little more; `None` if it misses the box.
    fn cross(&mut self, aabb: &Aabb, range: Interval) -> Option<Interval>;

    /// The `t` inside `range` at which the ray hits a primitive.
    fn test(&mut self, number: u32, range: Interval) -> Option<f32>;
}

/// A ray among triangles that writes down what it asks.
pub(crate) struct Asker<'t> {
    triangles: &'t Triangles,
    view: <Triangles as Primitives>::View,
    slabs: Slabs,
    /// How many boxes were asked about.
    pub(crate) boxes: u64,
    /// The numbers of the primitives that were asked about.
    pub(crate) tests: Vec<u32>,
    /// How many tests there were when the first of them said: hit.
    pub(crate) first_hit: Option<usize>,
    /// The greatest end of the ranges that were asked with, and the least begin.
    pub(crate) widest: Interval,
}

impl<'t> Asker<'t> {
    /// A ray that has asked nothing yet.
    pub(crate) fn new(triangles: &'t Triangles, ray: &Ray) -> Self {
        Self {
            triangles,
            view: triangles.view(ray),
            slabs: Slabs::of(ray),
            boxes: 0,
            tests: Vec::new(),
            first_hit: None,
            widest: Interval::new(f32::INFINITY, f32::NEG_INFINITY),
        }
    }
}

impl Asking for Asker<'_> {
    fn cross(&mut self, aabb: &Aabb, range: Interval) -> Option<Interval> {
        self.boxes += 1;
        self.slabs.cross(aabb, range)
    }

    fn test(&mut self, number: u32, range: Interval) -> Option<f32> {
        self.tests.push(number);
        self.widest = Interval::new(self.widest.min.min(range.min), self.widest.max.max(range.max));
        if number >= self.triangles.count() {
            return None;
        }
        let t = self.triangles.intersect(&self.triangles.entry(number), &self.view, range);
        if t.is_some() {
            self.first_hit.get_or_insert(self.tests.len());
        }
        t
    }
}

/// The boxes of all triangles.
pub(crate) fn boxes(triangles: &Triangles) -> Vec<Aabb> {
    (0..triangles.count()).map(|number| triangles.aabb(number)).collect()
}

/// The box around boxes; `None` around none.
pub(crate) fn around<'a>(boxes: impl IntoIterator<Item = &'a Aabb>) -> Option<Aabb> {
    boxes.into_iter().copied().reduce(|a, b| Aabb { min: a.min.min(b.min), max: a.max.max(b.max) })
}

/// A tree over boxes: each half has half of the primitives, along the longest side of the box around the middles. Lists hold
/// up to `few`.
pub(crate) fn median_tree(boxes: &[Aabb], few: usize) -> Vec<Node> {
    let mut nodes = Vec::new();
    let mut numbers: Vec<u32> = (0..).take(boxes.len()).collect();
    if !numbers.is_empty() {
        grow(&mut nodes, boxes, &mut numbers, few);
    }
    nodes
}

/// Make a node of primitives; returns its number.
fn grow(nodes: &mut Vec<Node>, boxes: &[Aabb], numbers: &mut [u32], few: usize) -> usize {
    let place = nodes.len();
    let aabb = around(numbers.iter().map(|&number| &boxes[number as usize]));
    let aabb = aabb.unwrap_or(Aabb::EVERYTHING);
    nodes.push(Node { aabb, content: Content::List(numbers.to_vec()) });
    if numbers.len() > few {
        let middles: Vec<_> = numbers.iter().map(|&number| boxes[number as usize].center()).collect();
        let axis = Aabb::around(&middles).map_or(0, |aabb| (aabb.max - aabb.min).max_position());
        numbers.sort_by(|&a, &b| {
            let [a, b] = [a, b].map(|number| boxes[number as usize].center()[axis]);
            a.total_cmp(&b)
        });
        let (lower, upper) = numbers.split_at_mut(numbers.len() / 2);
        let halves = [grow(nodes, boxes, lower, few), grow(nodes, boxes, upper, few)];
        nodes[place].content = Content::Halves(halves);
    }
    place
}
