//! Checks exercise 4.6, a bounding volume hierarchy.

use common::{
    Interval, Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
    obj::ObjMesh,
};
use ray_casting::{aabb::Aabb, ray::Ray};
use space_partitioning::{every_one::every_one, query::Found, triangles::Triangles};

use super::{
    hierarchy::{Asker, Asking, Node, boxes, median_tree},
    hierarchy_shape::{MOST_IN_LIST, shape},
    meshes::{in_stadium, soup, stadium, through_soup, triangles},
    walks::{NearestHit, Order},
    words,
};

/// Accept a tree and a search in it, or name what is wrong with them.
pub(crate) fn check(
    build: impl Fn(&[Aabb]) -> Vec<Node>,
    nearest: impl Fn(&[Node], Interval, &mut dyn Asking) -> Option<Found>,
) -> Verdict {
    // Behind references: so all answers share one copy of the steps.
    steps(&build, &nearest)
}

/// The second half of an answer.
type Nearest<'f> = &'f dyn Fn(&[Node], Interval, &mut dyn Asking) -> Option<Found>;

/// The steps of the check.
fn steps(build: &dyn Fn(&[Aabb]) -> Vec<Node>, nearest: Nearest<'_>) -> Verdict {
    let triangles = soup(46, 300);
    let mut dice = Dice::new(461);
    let nodes = median_tree(&boxes(&triangles), MOST_IN_LIST);
    let finds_nothing = (0..50).all(|_| {
        let ray = through_soup(&mut dice);
        let case = Case { triangles: &triangles, nodes: &nodes, ray, range: Interval::POSITIVE };
        let (found, asker) = case.outcome(&nearest);
        found.is_none() && asker.tests.is_empty()
    });
    if finds_nothing && made(&build, &boxes(&triangles), "a soup of triangles").is_empty() {
        return Err(Diagnosis::not_started(
            "`build` returns a tree without nodes, and `nearest` finds nothing in any tree.",
        ));
    }
    trees(&build)?;
    searches(&nearest)?;
    // As good as the tree that the task describes.
    quality(&build, &triangles, "a soup of triangles", through_soup)?;
    quality(&build, &stadium(), "a teapot in a stadium", in_stadium)
}

fn made(build: &impl Fn(&[Aabb]) -> Vec<Node>, boxes: &[Aabb], what: &str) -> Vec<Node> {
    trying(|| tree_words(boxes, what), || build(boxes))
}

fn tree_words(boxes: &[Aabb], what: &str) -> String {
    format!("a tree of {}: {what}", words::counted(boxes.len(), "primitive"))
}

/// Trees over boxes of all kinds.
fn trees(build: &impl Fn(&[Aabb]) -> Vec<Node>) -> Verdict {
    let tree = |boxes: &[Aabb], what: &str| shape(&made(build, boxes, what), boxes, &tree_words(boxes, what));
    let unit = |at: Vec3| Aabb { min: at, max: at + 1.0 };
    let along = |count: u16, by: Vec3| (0..count).map(|i| unit(by * f32::from(i))).collect::<Vec<_>>();
    tree(&along(1, Vec3::X), "one cube")?;
    tree(&along(8, Vec3::X * 2.0), "cubes in a row along x")?;
    tree(&along(9, Vec3::Y * 2.0), "cubes in a row along y")?;
    for count in [17, 64, 100] {
        tree(&along(count, Vec3::new(0.5, -0.3, 0.2)), "cubes in a slanting row, overlapping")?;
    }
    tree(&[], "an empty tree")?;
    let mut dice = Dice::new(462);
    for count in [20, 200] {
        let mut random = || {
            let (at, size) = (dice.point(5.0), dice.point(0.5).abs());
            // Every size may be zero.
            let size = if dice.happens(0.3) { size * Vec3::new(1.0, 0.0, 1.0) } else { size };
            Aabb { min: at, max: at + size }
        };
        let random: Vec<_> = (0..count).map(|_| random()).collect();
        tree(&random, "boxes here and there, some of them flat")?;
    }
    tree(&along(1000, Vec3::ZERO), "cubes, all in the same place")?;
    let mut crowd = along(1000, Vec3::ZERO);
    crowd[500] = unit(Vec3::X * 1000.0);
    tree(&crowd, "cubes in the same place, but for one that is far away")?;
    // Each one twice as far as the one before.
    let places = (0..100_u8).scan(1e-6, |place, _| {
        *place *= 1.7;
        Some(unit(Vec3::X * *place))
    });
    tree(&places.collect::<Vec<_>>(), "cubes, each 1.7 times as far away as the one before")?;
    tree(&boxes(&stadium()), "a teapot in a stadium")
}

/// A search for the nearest hit.
struct Case<'c> {
    triangles: &'c Triangles,
    nodes: &'c [Node],
    ray: Ray,
    range: Interval,
}

impl<'c> Case<'c> {
    fn outcome(
        &self,
        nearest: &impl Fn(&[Node], Interval, &mut dyn Asking) -> Option<Found>,
    ) -> (Option<Found>, Asker<'c>) {
        let mut asker = Asker::new(self.triangles, &self.ray);
        let found = trying(|| self.tried(), || nearest(self.nodes, self.range, &mut asker));
        (found, asker)
    }

    fn tests_of(&self, walk: NearestHit) -> usize {
        let mut asker = Asker::new(self.triangles, &self.ray);
        walk.walk(self.nodes, self.range, &mut asker);
        asker.tests.len()
    }

    fn tried(&self) -> String {
        let nodes = words::counted(self.nodes.len(), "node");
        format!("{}, {}, in a tree of {nodes}", words::ray(&self.ray), words::range(self.range))
    }

    fn fault(&self, name: &'static str, got: Option<Found>, expected: Option<Found>, advice: &str) -> Verdict {
        let (got, expected) = (words::found(got), words::found(expected));
        Err(Finding { tried: self.tried(), got, expected, advice: advice.into() }.named(name))
    }

    /// The mistake, if the answer is not that of brute force.
    fn compare(&self, got: Option<Found>, expected: Option<Found>, asker: &Asker<'_>) -> Verdict {
        let is_widened = asker.widest.min < self.range.min || asker.widest.max > self.range.max;
        if is_widened {
            let advice = "A primitive was tested outside of the range that was asked for.";
            return self.fault("range-ignored", got, expected, advice);
        }
        match (got, expected) {
            (got, expected) if got == expected => Ok(()),
            (None, Some(Found { number, .. })) => {
                let advice = match asker.tests.contains(&number) {
                    true => "The primitive was tested, but its hit did not become the answer.",
                    false => {
                        "The primitive was not tested. Is the second half visited when there is no hit in the first one? Does the \
                              box of a list get its question?"
                    }
                };
                self.fault("missed", got, expected, advice)
            }
            (Some(_), None) => self.fault("phantom", got, expected, "Only what `test` returns is a hit."),
            (Some(a), Some(b)) if a.t == b.t => {
                let advice = "Both are hit at the same t. Then the least number wins, whichever was tested first. To see the second one \
                              at all, shorten the range to `t.next_up()`.";
                self.fault("tie", got, expected, advice)
            }
            (Some(_), Some(Found { number, .. })) => {
                let advice = match asker.tests.contains(&number) {
                    true => {
                        "A nearer hit was found, but did not become the answer. Is it lost when the search goes on in the other half?"
                    }
                    false => {
                        "This is a hit, but not the nearest one. Boxes overlap: what is in the second half may lie before a hit \
                              in the first one."
                    }
                };
                self.fault("not-nearest", got, expected, advice)
            }
            _ => Ok(()),
        }
    }
}

/// Searches in trees that were built by somebody else.
fn searches(nearest: &impl Fn(&[Node], Interval, &mut dyn Asking) -> Option<Found>) -> Verdict {
    let mut dice = Dice::new(463);
    let mut counts = Counts::default();
    for (count, few) in [(1, 8), (3, 8), (5, 1), (60, 8), (300, 2), (600, 8)] {
        let triangles = soup(47, count);
        let nodes = median_tree(&boxes(&triangles), few);
        #[expect(clippy::unwrap_used, reason = "these triangles are finite and few")]
        let brute = every_one(triangles.clone()).unwrap();
        for _ in 0..150 {
            let ray = through_soup(&mut dice);
            let (min, length) = (dice.number(0.0, 1.0), dice.number(0.1, 1.0));
            for range in [Interval::POSITIVE, Interval::new(min, min + length)] {
                let case = Case { triangles: &triangles, nodes: &nodes, ray, range };
                let (found, asker) = case.outcome(nearest);
                case.compare(found, brute.nearest(&ray, range, &mut ()), &asker)?;
                counts.add(&case, asker.tests.len());
            }
        }
    }
    let triangles = soup(48, 1);
    let empty = Case { triangles: &triangles, nodes: &[], ray: Ray::new(Vec3::Z, -Vec3::Z), range: Interval::POSITIVE };
    let (found, asker) = empty.outcome(nearest);
    empty.compare(found, None, &asker)?;
    counts.judge()?;
    behind_a_wall(nearest)
}

/// Two walls one behind the other, each in a list of its own: the second one is not tested.
fn behind_a_wall(nearest: &impl Fn(&[Node], Interval, &mut dyn Asking) -> Option<Found>) -> Verdict {
    let wall = |z: f32| [Vec3::new(-1.0, -1.0, z), Vec3::new(1.0, -1.0, z), Vec3::new(0.0, 1.0, z)];
    let mesh = ObjMesh {
        positions: [wall(0.0), wall(-5.0)].concat(),
        triangles: vec![[0, 1, 2], [3, 4, 5]],
        ..ObjMesh::default()
    };
    let triangles = triangles(&mesh);
    let nodes = median_tree(&boxes(&triangles), 1);
    let case =
        Case { triangles: &triangles, nodes: &nodes, ray: Ray::new(Vec3::Z, -Vec3::Z), range: Interval::POSITIVE };
    let (_, asker) = case.outcome(nearest);
    if asker.tests == [0] {
        return Ok(());
    }
    let advice = "Both halves were asked about before the first one was visited. Meanwhile something was hit, and the second half lies \
                  behind it: compare its `min` with the end of the range once more before you visit it, or ask again.";
    Err(Finding {
        tried: format!(
            "{}, with a list for each of two triangles: number 0 at z = 0, number 1 at z = -5",
            case.tried()
        ),
        got: format!("tested: {}", words::numbers(&asker.tests)),
        expected: "tested: 0".into(),
        advice: advice.into(),
    }
    .named("old-range"))
}

/// Tests of an answer and of other walks, summed up.
#[derive(Default)]
struct Counts {
    got: usize,
    right: usize,
    others: [usize; 4],
}

/// Walks that are not right, and what is wrong with them.
const OTHERS: [(NearestHit, &str, &str); 4] = [
    (
        NearestHit { is_pruned: false, ..NearestHit::RIGHT },
        "no-pruning",
        "What lies behind the nearest hit so far is not tested: hand the range that ends just behind that hit on to `cross`.",
    ),
    (
        NearestHit { order: Order::Farther, ..NearestHit::RIGHT },
        "far-first",
        "You visit the farther half first. Of two halves that are met, begin with the one where `min` of what `cross` returns is less.",
    ),
    (
        NearestHit { order: Order::Given, ..NearestHit::RIGHT },
        "fixed-order",
        "You visit the halves in the order of the node. Begin with the one where `min` of what `cross` returns is less.",
    ),
    (
        NearestHit { order: Order::Reversed, ..NearestHit::RIGHT },
        "fixed-order",
        "You visit the halves in the order of the node, the second one first. Begin with the one where `min` of what `cross` returns \
         is less.",
    ),
];

impl Counts {
    fn add(&mut self, case: &Case<'_>, got: usize) {
        self.got += got;
        self.right += case.tests_of(NearestHit::RIGHT);
        for (sum, (walk, ..)) in self.others.iter_mut().zip(OTHERS) {
            *sum += case.tests_of(walk);
        }
    }

    fn judge(&self) -> Verdict {
        if self.got * 100 <= self.right * 103 {
            return Ok(());
        }
        let known = OTHERS.iter().zip(self.others).find(|(_, sum)| self.got.abs_diff(*sum) * 100 <= *sum);
        let (name, advice) = match known {
            Some(((_, name, advice), _)) => (*name, *advice),
            None => (
                "too-many-tests",
                "The hits are right, but too much is tested. Hand the range that ends just behind the nearest hit so far on to \
                 every question, visit the nearer half first, and leave out a half that begins behind the hit.",
            ),
        };
        Err(Finding {
            tried: "the nearest hits of 1800 rays, in several trees".into(),
            got: format!("{} tests", self.got),
            expected: format!("about {}", self.right),
            advice: advice.into(),
        }
        .named(name))
    }
}

/// A tree is as good as the one that the task describes.
fn quality(
    build: &impl Fn(&[Aabb]) -> Vec<Node>,
    triangles: &Triangles,
    what: &str,
    make_ray: fn(&mut Dice) -> Ray,
) -> Verdict {
    let boxes = boxes(triangles);
    let [yours, usual] = [made(build, &boxes, what), median_tree(&boxes, MOST_IN_LIST)];
    let mut dice = Dice::new(464);
    let rays: Vec<_> = (0..1000).map(|_| make_ray(&mut dice)).collect();
    let [got, expected] = [&yours, &usual].map(|nodes| {
        let tests =
            |ray: &Ray| Case { triangles, nodes, ray: *ray, range: Interval::POSITIVE }.tests_of(NearestHit::RIGHT);
        rays.iter().map(tests).sum::<usize>()
    });
    if got * 10 <= expected * 13 {
        return Ok(());
    }
    let advice = "The tree is a right one, but its boxes overlap too much. Primitives that lie near each other belong together: sort them \
                  by the centers of their boxes, along the axis on which the centers lie farthest apart.";
    Err(Finding {
        tried: format!("the nearest hits of 1000 rays in {}", tree_words(&boxes, what)),
        got: format!("{got} tests"),
        expected: format!("at most {}", expected * 13 / 10),
        advice: advice.into(),
    }
    .named("poor-tree"))
}
