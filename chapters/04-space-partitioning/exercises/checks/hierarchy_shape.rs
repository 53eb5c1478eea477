//! Whether a tree of boxes is one: what exercise 4.6 asks of `build`.

use common::exercise::{Finding, Verdict};
use ray_casting::aabb::Aabb;

use super::{
    hierarchy::{Content, Node, around},
    words,
};

/// Lists are at most so long.
pub(crate) const MOST_IN_LIST: usize = 8;
/// Nodes are at most so deep.
const MOST_LEVELS: usize = 64;

/// Accept a tree over boxes, or name what is wrong with it. `tried` says what the boxes are.
pub(crate) fn shape(nodes: &[Node], boxes: &[Aabb], tried: &str) -> Verdict {
    let fault = |name, got: String, expected: String, advice: &str| {
        Err(Finding { tried: tried.into(), got, expected, advice: advice.into() }.named(name))
    };
    if nodes.is_empty() {
        if boxes.is_empty() {
            return Ok(());
        }
        let advice = "Where there are primitives there is at least one node, number 0.";
        return fault("no-nodes", "a tree without nodes".into(), "at least one node".into(), advice);
    }
    // Look at all nodes from the whole down.
    let mut visits = vec![0_u32; nodes.len()];
    let mut stands = vec![Vec::new(); boxes.len()];
    let mut order = Vec::new();
    let mut waiting = vec![(0, 0)];
    while let Some((number, level)) = waiting.pop() {
        visits[number] += 1;
        if visits[number] > 1 {
            let advice = "Each node is the half of one other node only, and node 0 of none. Is the index of a half the one at which it \
                          was pushed? `nodes.len()` is the index of the next node only until something else is pushed.";
            let got = format!("node {number} is reached twice from node 0");
            return fault("not-a-tree", got, "each node is reached once".into(), advice);
        }
        if level > MOST_LEVELS {
            let advice = "Such a deep tree is nearly a list. When all centers lie in the same place, or most of them in a corner, a plane \
                          in the middle does not part them. Part them by their number.";
            return fault(
                "too-deep",
                format!("node {number} at level {level}"),
                format!("at most {MOST_LEVELS} levels"),
                advice,
            );
        }
        order.push(number);
        match &nodes[number].content {
            Content::Halves(halves) => {
                if let Some(half) = halves.iter().find(|&&half| half >= nodes.len()) {
                    let all = words::counted(nodes.len(), "node");
                    let got = format!("node {number} has node {half} as a half, of {all}");
                    return fault("no-such-node", got, "halves that exist".into(), "The first node has the index 0.");
                }
                waiting.extend(halves.map(|half| (half, level + 1)));
            }
            Content::List(list) => {
                for &primitive in list {
                    match stands.get_mut(primitive as usize) {
                        Some(places) => places.push(number),
                        None => {
                            let got = format!("node {number} lists primitive {primitive}, of {}", boxes.len());
                            return fault(
                                "no-such-primitive",
                                got,
                                "primitives that exist".into(),
                                "Numbers begin with 0.",
                            );
                        }
                    }
                }
                if list.is_empty() && !boxes.is_empty() {
                    let advice = "All primitives went to one side, and the other side is an empty list.";
                    return fault("empty-list", format!("node {number} lists nothing"), "no empty list".into(), advice);
                }
                if list.len() > MOST_IN_LIST {
                    let got = format!("node {number} lists {} primitives", list.len());
                    let advice = "Go on parting until few are left, also when all boxes are the same.";
                    return fault("long-list", got, format!("at most {MOST_IN_LIST}"), advice);
                }
            }
        }
    }
    if boxes.is_empty() {
        let got = format!("a tree of {}", words::counted(nodes.len(), "node"));
        return fault("no-primitives", got, "no nodes".into(), "Of no primitives, the tree has no nodes.");
    }
    if let Some(unused) = visits.iter().position(|&visits| visits == 0) {
        let got = format!("node {unused} is the half of no other node");
        return fault(
            "unused-node",
            got,
            "every node is reached from node 0".into(),
            "Node 0 is the whole: it is the first that goes into the list, before its halves.",
        );
    }
    if let Some(lost) = stands.iter().position(Vec::is_empty) {
        let advice = "When primitives are parted, each goes to one of the two sides. What about one that lies at the place of \
                      the cut?";
        let got = format!("primitive {lost} of {} stands in no list", boxes.len());
        return fault("lost-primitive", got, "each stands in one".into(), advice);
    }
    if let Some(twice) = stands.iter().position(|places| places.len() > 1) {
        let advice =
            "Objects are parted, not space: each goes to one side, even if its box reaches over to the other one.";
        let got = format!("primitive {twice} stands in {} lists", stands[twice].len());
        return fault("listed-twice", got, "each stands in one".into(), advice);
    }
    sizes(nodes, boxes, &order, fault)
}

/// The boxes of all nodes, from the deepest up.
fn sizes(
    nodes: &[Node],
    boxes: &[Aabb],
    order: &[usize],
    fault: impl Fn(&'static str, String, String, &str) -> Verdict,
) -> Verdict {
    let mut right = vec![Aabb::EVERYTHING; nodes.len()];
    for &number in order.iter().rev() {
        let smallest = match &nodes[number].content {
            Content::List(list) => around(list.iter().map(|&primitive| &boxes[primitive as usize])),
            Content::Halves(halves) => around(halves.iter().map(|&half| &right[half])),
        };
        right[number] = smallest.unwrap_or(Aabb::EVERYTHING);
    }
    let Some(&wrong) = order.iter().find(|&&number| nodes[number].aabb != right[number]) else { return Ok(()) };
    let (got, expected) = (&nodes[wrong].aabb, &right[wrong]);
    let told = |aabb: &Aabb| format!("node {wrong} with {}", words::aabb(aabb));
    if !(got.contains(expected.min) && got.contains(expected.max)) {
        let advice = "The box of a node must hold the boxes of all its primitives, and not only their centers.";
        return fault("box-too-small", told(got), told(expected), advice);
    }
    let advice = "The box of a node is the smallest one around the boxes of its own primitives, and not a part of the box above it. A box \
                  that grows from nothing begins with min = +∞ and max = −∞, not with zeros.";
    fault("box-too-large", told(got), told(expected), advice)
}
