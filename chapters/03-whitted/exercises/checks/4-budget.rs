//! Checks exercise 3.4, a budget of rays.
//!
//! The rays are those of made-up trees: the origin of a ray is the number of its node, so that the check sees which rays are
//! followed, and in which order.

use std::cell::RefCell;

use common::{
    Interval, Rgb, Vec3,
    exercise::{Diagnosis, Finding, Verdict, trying},
    random::Stream,
};
use ray_casting::{camera::Camera, material::Phong, ray::Ray, scene::Scene, sphere::Sphere};
use shadows::offset::Offset;
use whitted::{
    branches::Branch,
    material::{Fresnel, Material},
    probe::{Kind, Listener},
    whitted::{Limits, Terms, Whitted},
};

use super::{
    words,
    world::{Surface, Trace, World, depth_first},
};

/// A ray of a tree.
#[derive(Clone)]
struct Node {
    /// What it finds without further rays.
    radiance: Rgb,
    /// What is guessed if it is not followed.
    background: Rgb,
    /// Of its parent's radiance.
    share: Rgb,
    /// Of the whole.
    whole: Rgb,
    /// The rays that it causes, once somebody has asked.
    next: Option<[Option<usize>; 2]>,
}

impl Node {
    fn contribution(&self) -> f32 {
        self.whole.element_sum() / 3.0
    }
}

/// A tree that grows where somebody looks.
struct Tree {
    words: &'static str,
    nodes: RefCell<Vec<Node>>,
    /// The nodes that were followed, in this order.
    followed: RefCell<Vec<usize>>,
    /// What a node's rays are like: by the node's number and its random numbers.
    grow: fn(usize, &mut Stream) -> [Option<Rgb>; 2],
    /// After so many rays the tree answers nothing any more, so that every search ends.
    end: usize,
}

/// A search that is not the right one: its name, what to say about it, and how it ranks a ray by its node and its age.
type Rival<'a> = (&'static str, &'static str, &'a dyn Fn(&Node, usize) -> f32);

/// The camera ray of every tree: it has a share of its own, as if it were the ray of another tree.
const CAMERA_SHARE: Rgb = Rgb::new(0.5, 1.0, 0.75);

impl Tree {
    fn new(words: &'static str, end: u32, grow: fn(usize, &mut Stream) -> [Option<Rgb>; 2]) -> Self {
        let tree =
            Self { words, nodes: RefCell::default(), followed: RefCell::default(), grow, end: end as usize + 100 };
        tree.plant(CAMERA_SHARE, CAMERA_SHARE);
        tree
    }

    /// A new node; its number.
    fn plant(&self, share: Rgb, whole: Rgb) -> usize {
        let mut nodes = self.nodes.borrow_mut();
        let mut random = Stream::new(34, nodes.len() as u64, 0);
        let mut color = || Rgb::from_array([(); 3].map(|()| random.uniform()));
        let (radiance, background) = (color(), color());
        nodes.push(Node { radiance, background, share, whole, next: None });
        nodes.len() - 1
    }

    /// The rays that a node causes.
    fn next(&self, node: usize) -> [Option<usize>; 2] {
        let Node { whole, next, .. } = self.nodes.borrow()[node].clone();
        next.unwrap_or_else(|| {
            let mut random = Stream::new(35, node as u64, 0);
            let next = (self.grow)(node, &mut random).map(|share| share.map(|share| self.plant(share, whole * share)));
            self.nodes.borrow_mut()[node].next = Some(next);
            next
        })
    }

    #[expect(clippy::cast_precision_loss, reason = "few nodes")]
    fn branch(&self, node: usize) -> Branch {
        let share = self.nodes.borrow()[node].share;
        let ray = Ray::new(Vec3::new(node as f32, 0.0, 0.0), Vec3::Y);
        Branch { kind: if node == 0 { Kind::Camera } else { Kind::Reflected }, ray, range: Interval::POSITIVE, share }
    }

    /// The number of the node that a ray belongs to.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "few nodes")]
    fn node(&self, branch: &Branch) -> usize {
        (branch.ray.origin.x as usize).min(self.nodes.borrow().len() - 1)
    }

    /// Search the tree: always the waiting ray for which `rank` is greatest. The nodes in the order in which they are
    /// followed, and those that wait in the end.
    fn search(&self, budget: usize, rank: &dyn Fn(&Node, usize) -> f32) -> [Vec<usize>; 2] {
        let (mut followed, mut waiting) = (Vec::new(), vec![(0_usize, 0_usize)]);
        let mut age = 0;
        while followed.len() < budget {
            let rank_of = |(node, age): &(usize, usize)| rank(&self.nodes.borrow()[*node], *age);
            let best = (0..waiting.len()).max_by(|a, b| rank_of(&waiting[*a]).total_cmp(&rank_of(&waiting[*b])));
            let Some((node, _)) = best.map(|i| waiting.swap_remove(i)) else { break };
            followed.push(node);
            for next in self.next(node).into_iter().flatten() {
                age += 1;
                if self.nodes.borrow()[next].whole != Rgb::ZERO {
                    waiting.push((next, age));
                }
            }
        }
        [followed, waiting.into_iter().map(|(node, _)| node).collect()]
    }

    fn sum(&self, nodes: &[usize], value: impl Fn(&Node) -> Rgb) -> Rgb {
        let all = self.nodes.borrow();
        nodes.iter().map(|&n| value(&all[n]).as_dvec3()).fold(Vec3::ZERO.as_dvec3(), |a, b| a + b).as_vec3()
    }

    /// Ask the student's search, and judge it.
    fn check(&self, trace: Trace, budget: u32) -> Verdict {
        self.followed.borrow_mut().clear();
        let asked = || format!("{}, with a budget of {budget}", self.words);
        let got = trying(asked, || trace(self, self.branch(0), budget));
        let followed = self.followed.borrow().clone();
        let [ideal, rest] = self.search(budget as usize, &|node, _| node.contribution());
        let finding = |got: String, expected: String, name, advice: &str| {
            Err(Finding { tried: asked(), got, expected, advice: advice.into() }.named(name))
        };
        let rays = |n: usize| if n == 1 { "1 ray followed".into() } else { format!("{n} rays followed") };
        let many = |n: usize| if n > self.end { format!("more than {}", rays(self.end)) } else { rays(n) };
        if followed.len() > budget as usize {
            let (name, advice) = match followed.len() - budget as usize {
                1 => ("camera-ray-not-counted", "One ray too many. The camera ray is one of the budget, too."),
                _ => ("over-budget", "Each call of `follow` takes 1 of the budget, wherever it is made."),
            };
            return finding(many(followed.len()), format!("at most {budget}"), name, advice);
        }
        let is_dark = |n: &usize| self.nodes.borrow()[*n].whole == Rgb::ZERO;
        if followed.iter().any(is_dark) {
            let advice =
                "A ray was followed whose share of the whole is zero: whatever it finds, nothing of it arrives.";
            return finding(rays(followed.len()), rays(ideal.len()), "followed-for-nothing", advice);
        }
        if followed != ideal {
            let i = (0..).find(|&i| followed.get(i) != ideal.get(i)).unwrap_or_default();
            let is_short = followed.len() == i;
            let told = |nodes: &[usize]| match nodes.get(i) {
                Some(&n) if !is_short => {
                    let whole = self.nodes.borrow()[n].whole;
                    format!("as ray {} the one with the share {} of the whole", i + 1, words::color(whole))
                }
                _ => rays(nodes.len()),
            };
            let (name, advice) = self.wrong_order(&followed, &ideal, budget as usize);
            return finding(told(&followed), told(&ideal), name, advice);
        }
        let right = self.sum(&ideal, |n| n.whole * n.radiance) + self.sum(&rest, |n| n.whole * n.background);
        if words::is_near(got, right, 1e-3) {
            return Ok(());
        }
        let (name, advice) = self.wrong_sum(got, &ideal, &rest);
        finding(words::color(got), words::color(right), name, advice)
    }

    /// The name of the search that follows rays in this order.
    fn wrong_order(&self, followed: &[usize], ideal: &[usize], budget: usize) -> (&'static str, &'static str) {
        #[expect(clippy::cast_precision_loss, reason = "few nodes")]
        let age = |age: usize| age as f32;
        let depth_first = "This order is depth-first: what came last is followed first, however little it brings.";
        let by_channel = "The contribution is the mean of all three channels of the share.";
        let rivals: [Rival<'_>; 8] = [
            ("depth-first", depth_first, &|_, n| age(n)),
            // The same, with the first of two rays first.
            ("depth-first", depth_first, &|_, n| age(n.div_ceil(2)) - 0.1 * age((n + 1) % 2)),
            (
                "breadth-first",
                "This order is breadth-first: one depth after the other, however little a ray brings.",
                &|_, n| -age(n),
            ),
            (
                "least-first",
                "You follow the least contribution first. `BinaryHeap` gives out its greatest element: is your order reversed?",
                &|node, _| -node.contribution(),
            ),
            (
                "share-of-parent",
                "You rank rays by their share of the ray that caused them. Multiply it by that ray's own share of the whole.",
                &|node, _| node.share.element_sum(),
            ),
            ("one-channel", by_channel, &|node, _| node.whole.x),
            ("greatest-channel", by_channel, &|node, _| node.whole.max_element()),
            ("luminance", by_channel, &|node, _| common::color::luminance(node.whole)),
        ];
        let is = |rank: &dyn Fn(&Node, usize) -> f32| self.search(budget, rank)[0] == followed;
        // As it is with a limit instead of a search: the order is right, but it ends early.
        let is_short = followed.len() < ideal.len() && followed == &ideal[..followed.len()];
        let rival = rivals.iter().find(|(_, _, rank)| is(*rank)).map(|(name, advice, _)| (*name, *advice));
        if is_short && followed.is_empty() {
            ("nothing-followed", "There is a budget left, but not even the camera ray is followed.")
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
    fn wrong_sum(&self, got: Rgb, followed: &[usize], rest: &[usize]) -> (&'static str, &'static str) {
        let is = |value: Rgb| words::is_near(got, value, 1e-3);
        let found = self.sum(followed, |n| n.whole * n.radiance);
        let guess = self.sum(rest, |n| n.whole * n.background);
        if is(found) {
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
        } else {
            (
                "wrong-sum",
                "The right rays are followed, but the sum is wrong: share of the whole times `radiance`, and for those that \
                 wait times `background`.",
            )
        }
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

/// Accept a search, or name what is wrong with it.
pub(crate) fn check(trace: Trace) -> Verdict {
    let leaf = || Tree::new("a ray that causes no others", 10, |_, _| [None; 2]);
    let first = leaf();
    let is_black = trying(|| first.words.into(), || trace(&first, first.branch(0), 1)) == Rgb::ZERO;
    if is_black && first.followed.borrow().is_empty() {
        return Err(Diagnosis::not_started("`trace` follows no ray, and its result is black."));
    }
    // One ray after the other.
    for budget in [4, 1, 10, 0, 2000] {
        let gray = |_: usize, _: &mut Stream| [Some(Rgb::splat(0.999)), None];
        Tree::new("rays between two mirrors, each causing one more", budget, gray).check(trace, budget)?;
    }
    for budget in [1, 10, 0] {
        leaf().check(trace, budget)?;
    }
    // Trees that have an end, and trees that have none.
    let two = |_: usize, random: &mut Stream| {
        let part = 0.1 + 0.8 * random.uniform();
        [part, 0.97 - part].map(|part| Some(part * Rgb::from_array([(); 3].map(|()| 0.4 + 0.6 * random.uniform()))))
    };
    for budget in [20, 2, 3, 4, 6, 9, 77, 300] {
        Tree::new("a tree of rays, each causing two more", budget, two).check(trace, budget)?;
    }
    let some = |node: usize, random: &mut Stream| {
        let share = |u: f32| match node {
            n if n > 40 => None,
            _ if u < 0.25 => Some(Rgb::ZERO),
            _ => Some(Rgb::new(u, 1.0 - u, 0.5)),
        };
        [share(random.uniform()), share(random.uniform())]
    };
    for budget in [5, 20, 200] {
        Tree::new("a tree of rays, some with a share of zero", budget, some).check(trace, budget)?;
    }
    mirrors(trace)?;
    heap_of_glass(trace)?;
    let tree = Tree::new("a tree of rays, each causing two more", 20_000, two);
    let got = trying(|| format!("{}, with a budget of 20000", tree.words), || trace(&tree, tree.branch(0), 20_000));
    let followed = tree.followed.borrow().len();
    if followed != 20_000 || !got.is_finite() {
        let (tried, got) = (format!("{}, with a budget of 20000", tree.words), format!("{followed} rays followed"));
        let advice = "Is there a limit besides the budget?".into();
        return Err(Finding { tried, got, expected: "20000".into(), advice }.named("budget-not-used"));
    }
    Ok(())
}

/// A scene of that camera and nothing but the recursion.
fn whitted(scene: Scene<Material>, eye: Vec3, lookat: Vec3, limits: Limits) -> Option<Whitted> {
    let camera = Camera::new(eye, lookat, Vec3::Y, 40.0).ok()?;
    let (terms, fresnel, offset) = (Terms::ALL, Fresnel::Exact, Offset::Following);
    Some(Whitted { scene, camera, limits, terms, fresnel, offset })
}

/// Between two silver balls, a ray along their axis never escapes: with a budget of n, the same comes out as with the depth
/// n − 1.
fn mirrors(trace: Trace) -> Verdict {
    for budget in 1..12 {
        let mut scene = Scene::new();
        scene.surround(Rgb::new(0.5, 1.0, 2.0));
        for x in [-3.0, 3.0] {
            scene.add("mirror", Sphere::new(Vec3::X * x, 1.0), Material::SILVER);
        }
        let limits = Limits { max_depth: budget - 1, min_weight: 0.0 };
        let Some(world) = whitted(scene, Vec3::ZERO, Vec3::X, limits) else { return Ok(()) };
        let camera_ray = Branch::from_camera(Ray::new(Vec3::ZERO, Vec3::X));
        let tried = format!("a ray to and fro between two silver balls, with a budget of {budget}");
        let got = trying(|| tried.clone(), || trace(&world, camera_ray, budget));
        let right = world.trace_plain(&camera_ray, 0);
        if !words::is_near(got, right, 1e-4) {
            let (got, expected) =
                (words::color(got), format!("{}, as with a depth of {}", words::color(right), budget - 1));
            let advice = "One ray causes one more here, so that a budget of n is as good as a greatest depth of n − 1.";
            return Err(Finding { tried, got, expected, advice: advice.into() }.named("not-like-depth"));
        }
    }
    Ok(())
}

/// Budget of the comparison with depth-first search.
const EQUAL: u32 = 8;

/// Among glass balls, the greatest share first must be nearer to the truth than depth-first, for the same budget.
fn heap_of_glass(trace: Trace) -> Verdict {
    let mut scene = Scene::new();
    scene.surround(Rgb::new(0.3, 0.5, 0.9));
    scene.ambient = Rgb::ONE;
    let floor = Phong::of(Rgb::new(0.8, 0.2, 0.1), 0.0, 1.0);
    scene.add("floor", Sphere::new(Vec3::Y * -1001.0, 1000.0), Material::rough(floor));
    for (x, z) in [(-1.1, 0.0), (1.1, 0.0), (0.0, -1.8), (0.0, 1.8)] {
        scene.add("ball", Sphere::new(Vec3::new(x, 0.0, z), 1.0), Material::glass(1.5));
    }
    let limits = Limits { max_depth: 60, min_weight: 1e-5 };
    let Some(world) = whitted(scene, Vec3::new(0.0, 1.5, 8.0), Vec3::ZERO, limits) else { return Ok(()) };
    let mut errors = [0.0_f32; 2];
    let mut random = Stream::new(36, 0, 0);
    for _ in 0..400 {
        let target = Vec3::new(random.uniform() * 4.0 - 2.0, random.uniform() * 2.0 - 1.0, 0.0);
        let eye = world.camera.eye();
        let camera_ray = Branch::from_camera(Ray::new(eye, (target - eye).normalize()));
        let truth = world.trace(camera_ray, 0, &mut Listener(&mut common::story::Untold));
        let tried = || format!("glass balls on a floor, with a budget of {EQUAL}");
        let results = [trying(tried, || trace(&world, camera_ray, EQUAL)), depth_first(&world, camera_ray, EQUAL)];
        for (error, result) in errors.iter_mut().zip(results) {
            *error += (result - truth).abs().element_sum() / 3.0 / 400.0;
        }
    }
    let [yours, depth_first] = errors;
    // Written so that an error that is no number is wrong.
    let is_better = yours < depth_first;
    if is_better {
        return Ok(());
    }
    let told = |error: f32| format!("a mean error of {}", words::number(f64::from(error)));
    Err(Finding {
        tried: format!("400 camera rays at glass balls on a floor, each with a budget of {EQUAL}"),
        got: told(yours),
        expected: format!("less than {} of depth-first search", told(depth_first)),
        advice: "The greatest share first must be nearer to the truth than depth-first.".into(),
    }
    .named("not-better"))
}
