//! Likely mistakes in a search with a budget, by the rays that are followed and by what comes out.

use common::{Rgb, exercise::trying};

use super::{
    tree::{CAMERA_SHARE, Node, Tree, is_worth_it, two},
    words,
    world::Trace,
};

/// A search that is not the right one: its name, what to say about it, how it ranks a ray by its node and its age, and
/// which rays it lets wait at all.
type Rival<'a> = (&'static str, &'static str, &'a dyn Fn(&Node, usize) -> f32, &'a dyn Fn(&Node) -> bool);

impl Tree {
    /// The name of the search that follows rays in this order.
    pub(super) fn wrong_order(
        &self,
        trace: Trace,
        [followed, ideal]: [&[usize]; 2],
        got: Rgb,
        budget: usize,
    ) -> (&'static str, &'static str) {
        #[expect(clippy::cast_precision_loss, reason = "few nodes")]
        let age = |age: usize| age as f32;
        let depth_first = "This order is depth-first: what came last is followed first, however little it brings.";
        let by_channel = "The contribution is the mean of all three channels of the share.";
        let lost = "Only one of the two rays that a surface causes is ever followed. What becomes of the other one?";
        let contribution = |node: &Node, _: usize| node.contribution();
        let rivals: [Rival<'_>; 15] = [
            ("ray-lost", lost, &contribution, &|node| is_worth_it(node) && node.is_first),
            ("ray-lost", lost, &contribution, &|node| is_worth_it(node) && !node.is_first),
            ("channel-zero-dropped", ZERO_CHANNEL, &contribution, &|node| node.whole.min_element() > 0.0),
            ("channel-zero-dropped", ZERO_CHANNEL, &contribution, &|node| node.whole.x > 0.0),
            ("channel-zero-dropped", ZERO_CHANNEL, &contribution, &|node| node.whole.y > 0.0),
            ("channel-zero-dropped", ZERO_CHANNEL, &contribution, &|node| node.whole.z > 0.0),
            ("depth-first", depth_first, &|_, n| age(n), &is_worth_it),
            // The same, with the first of two rays first.
            ("depth-first", depth_first, &|_, n| age(n.div_ceil(2)) - 0.1 * age((n + 1) % 2), &is_worth_it),
            (
                "breadth-first",
                "This order is breadth-first: one depth after the other, however little a ray brings.",
                &|_, n| -age(n),
                &is_worth_it,
            ),
            (
                "least-first",
                "You follow the least contribution first. `BinaryHeap` gives out its greatest element: is your order reversed?",
                &|node, _| -node.contribution(),
                &is_worth_it,
            ),
            (
                "share-of-parent",
                "You rank rays by their share of the ray that caused them. Multiply it by that ray's own share of the whole.",
                &|node, _| node.share.element_sum(),
                &is_worth_it,
            ),
            ("one-channel", by_channel, &|node, _| node.whole.x, &is_worth_it),
            ("greatest-channel", by_channel, &|node, _| node.whole.max_element(), &is_worth_it),
            ("vector-length", by_channel, &|node, _| node.whole.length(), &is_worth_it),
            ("luminance", by_channel, &|node, _| common::color::luminance(node.whole), &is_worth_it),
        ];
        // As it is with a limit instead of a search: the order is right, but it ends early.
        let is_short = followed.len() < ideal.len() && followed == &ideal[..followed.len()];
        // Of those that follow the same rays, the one whose sum is the same as well, if there is one.
        let same_rays: Vec<_> = rivals
            .iter()
            .map(|(name, advice, rank, keeps)| (*name, *advice, self.search(budget, rank, keeps)))
            .filter(|(_, _, [rays, _])| rays == followed)
            .collect();
        let has_same_sum = |(_, _, [rays, rest]): &&(_, _, [Vec<usize>; 2])| {
            let sum = self.sum(rays, |n| n.whole * n.radiance) + self.sum(rest, |n| n.whole * n.background);
            words::is_near(got, sum, 1e-3)
        };
        let rival = same_rays.iter().find(has_same_sum).or(same_rays.iter().find(|(name, ..)| *name != "ray-lost"));
        let rival = rival.map(|(name, advice, _)| (*name, *advice));
        let is_weak = |&n: &usize| self.nodes.borrow()[n].whole.max_element() < 1e-3;
        if is_short && followed.is_empty() {
            ("nothing-followed", "There is a budget left, but not even the camera ray is followed.")
        } else if is_short && rival.is_some_and(|(name, _)| name == "channel-zero-dropped") {
            ("channel-zero-dropped", ZERO_CHANNEL)
        } else if is_short && ideal.get(followed.len()).is_some_and(is_weak) {
            (
                "weak-dropped",
                "The search ends, though a ray still waits and there is a budget left for it. Its share is small, but only \
                 a share of zero is not worth following.",
            )
        } else if is_short && counts_the_waiting(trace) {
            (
                "waiting-counted",
                "The search ends when the rays that were followed and those that wait are together as many as the budget. \
                 Only what is followed takes from it; any number may wait.",
            )
        } else if is_short {
            ("budget-not-used", "The search ends, though rays still wait and there is a budget left for them.")
        } else {
            rival.unwrap_or((
                "wrong-order",
                "Of all rays that wait, wherever in the tree they are, the one with the greatest mean share comes next.",
            ))
        }
    }

    /// The likely mistake in a sum over the right rays.
    pub(super) fn wrong_sum(
        &self,
        got: Rgb,
        right: Rgb,
        followed: &[usize],
        rest: &[usize],
    ) -> (&'static str, &'static str) {
        let is = |value: Rgb| words::is_near(got, value, 1e-3);
        let found = self.sum(followed, |n| n.whole * n.radiance);
        let guess = self.sum(rest, |n| n.whole * n.background);
        let colored = |keeps: &dyn Fn(Rgb) -> bool| {
            self.sum(rest, |n| if keeps(n.whole) { n.whole * n.background } else { Rgb::ZERO })
        };
        let added = self.sum(followed, |n| n.added * n.radiance) + self.sum(rest, |n| n.added * n.background);
        if got.is_nan() {
            ("not-a-number", "This is no number. Was something divided by zero, or zero multiplied by infinity?")
        } else if is(right.min(Rgb::ONE)) {
            ("clamped", "The sum is kept from being more than 1. Radiance has no upper bound.")
        } else if is(added) {
            (
                "shares-added",
                "The shares on the way to the eye were added up. Half of a half is a quarter: the share of the whole is their \
                 product.",
            )
        } else if is(found) {
            (
                "rest-forgotten",
                "The rays that still wait in the end are missing: each brings its share of the background.",
            )
        } else if is(found + self.sum(rest, |n| n.background)) {
            ("rest-unweighted", "The rays that still wait bring their share of the background, not all of it.")
        } else if is(found + self.sum(rest, |n| n.share * n.background)) {
            ("rest-unweighted", "The share of a waiting ray is multiplied with all shares on its way to the eye.")
        } else if is(self.sum(followed, |n| n.radiance) + guess) {
            ("shares-missing", "What a ray finds counts with the ray's share of the whole.")
        } else if is(self.sum(followed, |n| n.share * n.radiance) + self.sum(rest, |n| n.share * n.background)) {
            ("share-of-parent", "Shares are multiplied all the way to the eye, not only with the last surface.")
        } else if is((found + guess) / CAMERA_SHARE) {
            ("camera-share", "The camera ray has a share as well, `camera_ray.share`, and here it is not one.")
        } else if is(found + guess + self.sum(followed, |n| n.whole * n.background)) {
            ("guessed-and-followed", "A ray is either followed or guessed, not both.")
        } else if is(guess) {
            ("radiance-forgotten", "The `radiance` of the surfaces is missing.")
        } else if is(found + colored(&|whole| whole.min_element() > 0.0))
            || (0..3).any(|c| is(found + colored(&|whole| whole[c] > 0.0)))
        {
            ("channel-zero-dropped", ZERO_CHANNEL)
        } else {
            (
                "wrong-sum",
                "The right rays are followed, but the sum is wrong: the product of all shares on the way to the eye times \
                 `radiance`, and for those that wait times `background`.",
            )
        }
    }
}

/// What to say if a ray was dropped because of one channel.
const ZERO_CHANNEL: &str = "A ray was dropped because one channel of its share is zero. The others still bring something: drop a ray \
                            only if all three are zero.";

/// The nodes of a tree of pairs that a search follows with this budget, and those that it should follow and guess.
fn on_pairs(trace: Trace, budget: u32) -> [Vec<usize>; 3] {
    let tree = Tree::new("a tree of rays, each causing two more", budget, two);
    let words = || format!("{}, with a budget of {budget}", tree.words);
    let _ = trying(words, || trace(&tree, tree.branch(0), budget));
    let followed = tree.followed.borrow().clone();
    let [ideal, rest] = tree.ideal(budget as usize);
    [followed, ideal, rest]
}

/// Whether the rays that wait in the end are followed, instead of one ray too many.
pub(super) fn follows_the_rest(trace: Trace) -> bool {
    let [mut followed, mut all, rest] = on_pairs(trace, 5);
    all.extend(rest);
    all.sort_unstable();
    followed.sort_unstable();
    followed == all
}

/// Whether the search ends when as many rays were followed or wait as the budget allows.
fn counts_the_waiting(trace: Trace) -> bool {
    const BUDGET: u32 = 41;
    let [followed, ideal, _] = on_pairs(trace, BUDGET);
    // Each ray that is followed leaves one more waiting: about half of the budget is spent.
    (BUDGET as usize).abs_diff(2 * followed.len()) <= 3 && followed == ideal[..followed.len()]
}
