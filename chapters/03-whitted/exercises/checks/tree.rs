//! Trees of rays made up for a check: the origin of a ray is the number of its node, so that the check sees which rays are
//! followed, and in which order.

use std::cell::RefCell;

use common::{Interval, Rgb, Vec3, random::Stream};
use ray_casting::ray::Ray;
use whitted::{branches::Branch, probe::Kind};

use super::world::{Surface, World};

/// A ray of a tree.
#[derive(Clone)]
pub(super) struct Node {
    /// What it finds without further rays.
    pub(super) radiance: Rgb,
    /// What is guessed if it is not followed.
    pub(super) background: Rgb,
    /// Of its parent's radiance.
    pub(super) share: Rgb,
    /// Of the whole.
    pub(super) whole: Rgb,
    /// What comes out if shares are added on the way to the eye instead of multiplied.
    pub(super) added: Rgb,
    /// Whether it is the first of the two rays that its parent causes.
    pub(super) is_first: bool,
    /// The rays that it causes, once somebody has asked.
    pub(super) next: Option<[Option<usize>; 2]>,
}

impl Node {
    pub(super) fn contribution(&self) -> f32 {
        self.whole.element_sum() / 3.0
    }
}

/// A tree that grows where somebody looks.
pub(super) struct Tree {
    pub(super) words: &'static str,
    pub(super) nodes: RefCell<Vec<Node>>,
    /// The nodes that were followed, in this order.
    pub(super) followed: RefCell<Vec<usize>>,
    /// What a node's rays are like: by the node's number and its random numbers.
    pub(super) grow: fn(usize, &mut Stream) -> [Option<Rgb>; 2],
    /// After so many rays the tree answers nothing any more, so that every search ends.
    pub(super) end: usize,
}

/// The camera ray of every tree: it has a share of its own, as if it were the ray of another tree.
pub(super) const CAMERA_SHARE: Rgb = Rgb::new(0.5, 1.0, 0.75);

impl Tree {
    pub(super) fn new(words: &'static str, end: u32, grow: fn(usize, &mut Stream) -> [Option<Rgb>; 2]) -> Self {
        let tree =
            Self { words, nodes: RefCell::default(), followed: RefCell::default(), grow, end: end as usize + 100 };
        tree.plant(CAMERA_SHARE, [CAMERA_SHARE; 2], true);
        tree
    }

    /// A new node; its number.
    fn plant(&self, share: Rgb, [whole, added]: [Rgb; 2], is_first: bool) -> usize {
        let mut nodes = self.nodes.borrow_mut();
        let mut random = Stream::new(34, nodes.len() as u64, 0);
        let mut color = || Rgb::from_array([(); 3].map(|()| random.uniform()));
        let (radiance, background) = (color(), color());
        nodes.push(Node { radiance, background, share, whole, added, is_first, next: None });
        nodes.len() - 1
    }

    /// The rays that a node causes.
    fn next(&self, node: usize) -> [Option<usize>; 2] {
        let Node { whole, added, next, .. } = self.nodes.borrow()[node].clone();
        next.unwrap_or_else(|| {
            let mut random = Stream::new(35, node as u64, 0);
            let mut is_first = [true, false].into_iter();
            let next = (self.grow)(node, &mut random).map(|share| {
                let is_first = is_first.next() == Some(true);
                share.map(|share| self.plant(share, [whole * share, added + share], is_first))
            });
            self.nodes.borrow_mut()[node].next = Some(next);
            next
        })
    }

    #[expect(clippy::cast_precision_loss, reason = "few nodes")]
    pub(super) fn branch(&self, node: usize) -> Branch {
        let share = self.nodes.borrow()[node].share;
        let ray = Ray::new(Vec3::new(node as f32, 0.0, 0.0), Vec3::Y);
        Branch { kind: if node == 0 { Kind::Camera } else { Kind::Reflected }, ray, range: Interval::POSITIVE, share }
    }

    /// The number of the node that a ray belongs to.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "few nodes")]
    fn node(&self, branch: &Branch) -> usize {
        (branch.ray.origin.x as usize).min(self.nodes.borrow().len() - 1)
    }

    /// The right search.
    pub(super) fn ideal(&self, budget: usize) -> [Vec<usize>; 2] {
        self.search(budget, &|node, _| node.contribution(), &is_worth_it)
    }

    /// Search the tree: always the waiting ray for which `rank` is greatest, of those that `keeps` lets wait. The nodes in
    /// the order in which they are followed, and those that wait in the end.
    pub(super) fn search(
        &self,
        budget: usize,
        rank: &dyn Fn(&Node, usize) -> f32,
        keeps: &dyn Fn(&Node) -> bool,
    ) -> [Vec<usize>; 2] {
        let (mut followed, mut waiting) = (Vec::new(), vec![(0_usize, 0_usize)]);
        let mut age = 0;
        while followed.len() < budget {
            let rank_of = |(node, age): &(usize, usize)| rank(&self.nodes.borrow()[*node], *age);
            let best = (0..waiting.len()).max_by(|a, b| rank_of(&waiting[*a]).total_cmp(&rank_of(&waiting[*b])));
            let Some((node, _)) = best.map(|i| waiting.swap_remove(i)) else { break };
            followed.push(node);
            for next in self.next(node).into_iter().flatten() {
                age += 1;
                if keeps(&self.nodes.borrow()[next]) {
                    waiting.push((next, age));
                }
            }
        }
        [followed, waiting.into_iter().map(|(node, _)| node).collect()]
    }

    pub(super) fn sum(&self, nodes: &[usize], value: impl Fn(&Node) -> Rgb) -> Rgb {
        let all = self.nodes.borrow();
        nodes.iter().map(|&n| value(&all[n]).as_dvec3()).fold(Vec3::ZERO.as_dvec3(), |a, b| a + b).as_vec3()
    }
}

impl World for Tree {
    fn follow(&self, branch: &Branch) -> Surface {
        let node = self.node(branch);
        self.followed.borrow_mut().push(node);
        if self.followed.borrow().len() > self.end {
            return Surface::default();
        }
        let next = self.next(node).map(|next| next.map(|next| self.branch(next)));
        Surface { radiance: self.nodes.borrow()[node].radiance, next }
    }

    fn background(&self, branch: &Branch) -> Rgb {
        let node = self.node(branch);
        self.nodes.borrow()[node].background
    }
}

/// Whether a ray is worth following.
pub(super) fn is_worth_it(node: &Node) -> bool {
    node.whole != Rgb::ZERO
}

/// Shares of two rays, both of which bring something.
pub(super) fn two(_node: usize, random: &mut Stream) -> [Option<Rgb>; 2] {
    let part = 0.1 + 0.8 * random.uniform();
    [part, 0.97 - part].map(|part| Some(part * Rgb::from_array([(); 3].map(|()| 0.4 + 0.6 * random.uniform()))))
}
