//! Checks exercise 4.4, an ordered shadow walk.

use common::{
    Interval,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use ray_casting::ray::Ray;
use space_partitioning::{primitives::Primitives, triangles::Triangles};

use super::{
    hierarchy::{Asker, Asking, Node, boxes, median_tree},
    meshes::{soup, through_soup},
    walks::{AnyHit, Order},
    words,
};

/// A walk and what it comes out with.
struct Case<'c> {
    triangles: &'c Triangles,
    nodes: &'c [Node],
    ray: Ray,
    range: Interval,
    answer: bool,
    /// Numbers of all tests.
    tests: Vec<u32>,
    first_hit: Option<usize>,
    widest: Interval,
}

/// Accept a walk, or name what is wrong with it.
pub(crate) fn check(is_occluded: impl Fn(&[Node], Interval, &mut dyn Asking) -> bool) -> Verdict {
    // Behind references: so all answers share one copy of the steps.
    steps(&is_occluded)
}

/// An answer.
type IsOccluded<'f> = &'f dyn Fn(&[Node], Interval, &mut dyn Asking) -> bool;

/// The steps of the check.
fn steps(is_occluded: IsOccluded<'_>) -> Verdict {
    let mut dice = Dice::new(441);
    let scenes = [(0, 4), (1, 4), (3, 4), (9, 2), (60, 4), (400, 4)];
    let scenes = scenes.map(|(count, few)| {
        // A mesh has at least one triangle; a tree may have none.
        let triangles = soup(44, count.max(1));
        let boxes = boxes(&triangles);
        (triangles, median_tree(&boxes[..count], few))
    });
    let mut cases = Vec::new();
    for (triangles, nodes) in &scenes {
        for _ in 0..100 {
            let ray = match triangles.count() < 20 && dice.happens(0.5) {
                true => toward(triangles, &mut dice),
                false => through_soup(&mut dice),
            };
            let (min, length) = (dice.number(0.0, 1.0), dice.number(0.1, 1.0));
            for range in [Interval::POSITIVE, Interval::new(0.0, length), Interval::new(min, min + length)] {
                cases.push(Case::of(&is_occluded, triangles, nodes, ray, range));
            }
        }
    }
    if cases.iter().all(|case| !case.answer && case.tests.is_empty()) {
        return Err(Diagnosis::not_started("Nothing casts a shadow: `is_occluded` asks nothing and returns `false`."));
    }
    let advice = "A primitive was tested beyond the end of the range, which is where the light stands. What is hit there casts no \
                  shadow here.";
    let is_beyond = |tested: Interval, range: Interval| tested.max > range.max;
    cases.iter().try_for_each(|case| case.range("beyond-the-light", is_beyond, advice))?;
    let advice = "A primitive was tested before the begin of the range.";
    let is_before = |tested: Interval, range: Interval| tested.min < range.min;
    cases.iter().try_for_each(|case| case.range("range-min-ignored", is_before, advice))?;
    cases.iter().try_for_each(Case::answer)?;
    cases.iter().try_for_each(Case::end)?;
    boxes_that_are_missed(&cases)?;
    order(&cases)
}

/// A ray toward one of the triangles.
fn toward(triangles: &Triangles, dice: &mut Dice) -> Ray {
    let [a, b, c] = triangles.0.triangle(0).corners;
    let origin = dice.point(7.0);
    Ray::new(origin, (a + b + c) / 3.0 - origin + dice.point(0.1))
}

impl<'c> Case<'c> {
    fn of(
        is_occluded: &impl Fn(&[Node], Interval, &mut dyn Asking) -> bool,
        triangles: &'c Triangles,
        nodes: &'c [Node],
        ray: Ray,
        range: Interval,
    ) -> Self {
        let mut asker = Asker::new(triangles, &ray);
        let answer = trying(|| tried(nodes, &ray, range), || is_occluded(nodes, range, &mut asker));
        let Asker { tests, first_hit, widest, .. } = asker;
        Self { triangles, nodes, ray, range, answer, tests, first_hit, widest }
    }

    fn fault(&self, name: &'static str, got: String, expected: String, advice: &str) -> Verdict {
        let tried = tried(self.nodes, &self.ray, self.range);
        Err(Finding { tried, got, expected, advice: advice.into() }.named(name))
    }

    /// No test outside of the range.
    fn range(&self, name: &'static str, is_outside: fn(Interval, Interval) -> bool, advice: &str) -> Verdict {
        if is_outside(self.widest, self.range) {
            return self.fault(
                name,
                format!("a test in the {}", words::range(self.widest)),
                words::range(self.range),
                advice,
            );
        }
        Ok(())
    }

    /// The same answer as by brute force.
    fn answer(&self) -> Verdict {
        let count = if self.nodes.is_empty() { 0 } else { self.triangles.count() };
        let view = self.triangles.view(&self.ray);
        let hit = (0..count)
            .find(|&number| self.triangles.intersect(&self.triangles.entry(number), &view, self.range).is_some());
        match hit {
            Some(hit) if !self.answer => {
                let advice = match self.tests.contains(&hit) {
                    true => {
                        "The primitive was tested, and the test said: hit. That must become the answer of the whole walk."
                    }
                    false => {
                        "A primitive that is hit was not tested. Is the second half visited when there is no hit in the first \
                              one? And a ray that misses one half may meet the other."
                    }
                };
                self.fault("missed", "false".into(), format!("true: primitive {hit} is hit"), advice)
            }
            None if self.answer => {
                let advice = "To meet a box is not to hit what is in it. Only `test` tells of hits.";
                self.fault("phantom", "true".into(), "false: no primitive is hit in the range".into(), advice)
            }
            _ => Ok(()),
        }
    }

    /// No test after the first hit.
    fn end(&self) -> Verdict {
        match self.first_hit {
            Some(first) if first < self.tests.len() => {
                let advice = "The first hit ends everything. In a loop over a list `return` does that; between two halves, `||` does: \
                              the second half is visited only if the first one says `false`.";
                let expected = format!("none after test number {first}, which was a hit");
                self.fault("goes-on", format!("{} tests", self.tests.len()), expected, advice)
            }
            _ => Ok(()),
        }
    }

    /// The tests of another walk.
    fn tests_of(&self, walk: AnyHit) -> (Vec<u32>, bool) {
        let (mut asker, mut unclear) = (Asker::new(self.triangles, &self.ray), false);
        walk.walk(self.nodes, self.range, &mut asker, &mut unclear);
        (asker.tests, unclear)
    }
}

fn tried(nodes: &[Node], ray: &Ray, range: Interval) -> String {
    let nodes = words::counted(nodes.len(), "node");
    format!("{}, {}, in a tree of {nodes}", words::ray(ray), words::range(range))
}

/// What is in a box that is missed is not tested: seen from rays that hit nothing, which test all the rest.
fn boxes_that_are_missed(cases: &[Case<'_>]) -> Verdict {
    let sorted = |tests: &[u32]| {
        let mut tests = tests.to_vec();
        tests.sort_unstable();
        tests
    };
    let is_endless = cases.iter().filter(|case| !case.answer).all(|case| {
        let (tests, _) = case.tests_of(AnyHit { is_endless: true, ..AnyHit::RIGHT });
        sorted(&tests) == sorted(&case.tests)
    });
    for case in cases.iter().filter(|case| !case.answer) {
        let (right, _) = case.tests_of(AnyHit::RIGHT);
        let (right, got) = (sorted(&right), sorted(&case.tests));
        if right == got {
            continue;
        }
        let told = |tests: &[u32]| format!("tested, sorted by number: {}", words::numbers(tests));
        let twice = got.windows(2).any(|pair| pair[0] == pair[1]);
        let (name, advice) = if is_endless {
            (
                "box-beyond-the-light",
                "A box that lies beyond the end of the range, or before its begin, cannot hold a hit that \
                                      counts. Hand `range` on to `cross`.",
            )
        } else if twice {
            ("tested-twice", "A primitive is tested twice. Is a node visited twice?")
        } else {
            (
                "boxes-ignored",
                "If `cross` says `None`, nothing in that box is tested, and if it says `Some`, what is in it is. This \
                               holds for the box of node 0, too.",
            )
        };
        return case.fault(name, told(&got), told(&right), advice);
    }
    Ok(())
}

/// The longer way first.
fn order(cases: &[Case<'_>]) -> Verdict {
    const WRONG: [(Order, &str, &str); 5] = [
        (Order::Shorter, "shorter-first", "You begin where the ray is inside for the shorter time."),
        (
            Order::Nearer,
            "near-first",
            "You visit the nearer half first. A shadow ray need not find the nearest hit: begin where the way through the box is \
             longer.",
        ),
        (
            Order::Farther,
            "far-first",
            "You visit the farther half first. Begin where the way through the box is longer.",
        ),
        (
            Order::Given,
            "fixed-order",
            "You visit the halves in the order of the node. Begin where the way through the box is longer.",
        ),
        (
            Order::Reversed,
            "fixed-order",
            "You visit the halves in the order of the node, the second one first. Begin where the way through the box is longer.",
        ),
    ];
    let Some(wrong) = cases.iter().find(|case| {
        let (right, unclear) = case.tests_of(AnyHit::RIGHT);
        !unclear && right != case.tests
    }) else {
        return Ok(());
    };
    let is_endless = cases.iter().all(|case| {
        let (tests, unclear) = case.tests_of(AnyHit { is_endless: true, ..AnyHit::RIGHT });
        unclear || tests == case.tests
    });
    // Of the walks that differ from the right one, nearly all are those of another order. (Where both halves begin together,
    // an order does not say which comes first.)
    let differing: Vec<_> = cases.iter().filter(|case| case.tests != case.tests_of(AnyHit::RIGHT).0).collect();
    let known = WRONG.iter().find(|(order, ..)| {
        let is_same = |case: &&&Case<'_>| case.tests_of(AnyHit { order: *order, is_endless: false }).0 == case.tests;
        10 * differing.iter().filter(is_same).count() >= 9 * differing.len()
    });
    let (name, advice) = match known {
        Some((_, name, advice)) => (*name, *advice),
        None if is_endless => (
            "whole-line",
            "The way through a box counts only as far as it lies in the range: hand `range` on to `cross`.",
        ),
        None => (
            "wrong-order",
            "Of two halves that are met, begin with the one where `max − min` of what `cross` returns is greater. Do so in every \
             node. Lists are tested in their order.",
        ),
    };
    let told = |tests: &[u32]| format!("tested in this order: {}", words::numbers(tests));
    wrong.fault(name, told(&wrong.tests), told(&wrong.tests_of(AnyHit::RIGHT).0), advice)
}
