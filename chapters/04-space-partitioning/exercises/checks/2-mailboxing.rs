//! Checks exercise 4.2, mailboxing.

use std::collections::HashSet;

use common::{
    Interval,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use ray_casting::ray::Ray;
use space_partitioning::{
    grid::{Grid, grid},
    primitives::Primitives,
    query::Found,
    structure::Structure,
    triangles::Triangles,
};

use super::{
    logged::{Logged, logging},
    meshes::{soup, spikes, through_soup},
    words,
};

/// What a list holds of a triangle.
type Entry = <Logged as Primitives>::Entry;

/// Accept a wrapper around primitives, or name what is wrong with it.
pub(crate) fn check<M: Primitives<Entry = Entry>>(make: impl Fn(Logged) -> M) -> Verdict {
    let triangles = soup(42, 400);
    let trial = Trial::new(&make, &triangles);
    let mut dice = Dice::new(421);
    let rays: Vec<_> = (0..300).map(|_| through_soup(&mut dice)).collect();
    let range = Interval::POSITIVE;
    let outcomes: Vec<_> = rays.iter().map(|ray| trial.mailed(ray, range, false)).collect();
    if rays.iter().zip(&outcomes).all(|(ray, outcome)| trial.plain(ray, range, false) == *outcome) {
        return Err(Diagnosis::not_started(
            "Nothing is saved: a primitive is tested again in every cell that lists it.",
        ));
    }
    let was_asked = outcomes.iter().any(|(_, log)| !log.is_empty());
    alone(&make, &triangles, was_asked)?;
    together(&make, &triangles)?;
    for (i, ray) in rays.iter().enumerate() {
        for any in [false, true] {
            for range in [range, Interval::new(0.1, 0.9)] {
                trial.probe(&make, i, ray, range, any)?;
            }
        }
    }
    // Many tests on one way.
    let trial = Trial::new(&make, &spikes(1500));
    for i in 0..100 {
        let ray = Ray::new(dice.direction().normalize() * 2.0, dice.direction());
        let ray = if i % 2 == 0 { Ray::new(ray.origin, dice.point(0.3) - ray.origin) } else { ray };
        trial.probe(&make, i, &ray, Interval::POSITIVE, false)?;
    }
    Ok(())
}

/// The same triangles in two grids, one of them with mailboxes.
struct Trial<M: Primitives> {
    triangles: Triangles,
    plain: Structure<Logged, Grid<Entry>>,
    mailed: Structure<M, Grid<Entry>>,
}

/// What was found, and the numbers of all tests.
type Outcome = (Option<Found>, Vec<u32>);

impl<M: Primitives<Entry = Entry>> Trial<M> {
    #[expect(clippy::unwrap_used, reason = "these triangles are finite and few")]
    fn new(make: &impl Fn(Logged) -> M, triangles: &Triangles) -> Self {
        let logged = || Logged(triangles.clone());
        let tried = || format!("a grid of {} triangles", triangles.count());
        let mailed = trying(tried, || grid(make(logged())).unwrap());
        Self { triangles: triangles.clone(), plain: grid(logged()).unwrap(), mailed }
    }

    fn plain(&self, ray: &Ray, range: Interval, any: bool) -> Outcome {
        logging(|| search(&self.plain, ray, range, any))
    }

    fn mailed(&self, ray: &Ray, range: Interval, any: bool) -> Outcome {
        trying(|| self.tried(ray, range, any), || logging(|| search(&self.mailed, ray, range, any)))
    }

    fn tried(&self, ray: &Ray, range: Interval, any: bool) -> String {
        let question = if any { "any hit" } else { "the nearest hit" };
        let (ray, range) = (words::ray(ray), words::range(range));
        format!("{question} of {ray}, {range}, in a grid of {} triangles", self.triangles.count())
    }

    /// The mistake, if the walk of the ray of that index goes wrong.
    fn probe(&self, make: &impl Fn(Logged) -> M, index: usize, ray: &Ray, range: Interval, any: bool) -> Verdict {
        let (expected, repeated) = self.plain(ray, range, any);
        let tests = once(&repeated);
        let (found, log) = self.mailed(ray, range, any);
        if (found, &log) == (expected, &tests) {
            return Ok(());
        }
        let fault = |name, advice: &str| {
            let told = |found, tests: &[u32]| format!("{}; tested: {}", words::found(found), words::numbers(tests));
            let tried = self.tried(ray, range, any);
            Err(Finding { tried, got: told(found, &log), expected: told(expected, &tests), advice: advice.into() }
                .named(name))
        };
        // The same without any ray before.
        let is_right_alone = index > 0 && {
            let fresh = Trial::new(make, &self.triangles);
            fresh.mailed(ray, range, any) == (expected, tests.clone())
        };
        if is_right_alone {
            return fault(OLD_NOTES.0, OLD_NOTES.1);
        }
        if let Some(&lost) = tests.iter().find(|number| !log.contains(number)) {
            let advice = format!(
                "Primitive {lost} was never tested, although no note about it can be there. Does a note say which \
                 primitive it is about, and not only a part of its number?"
            );
            return fault("lost-test", &advice);
        }
        let mut seen = HashSet::new();
        let again: Vec<u32> = log.iter().copied().filter(|number| !seen.insert(*number)).collect();
        if again.is_empty() {
            let advice = "All primitives were tested that should be, but the answer is another one. Hand the same entry and the \
                          same range on, and return what comes back. About a primitive that was tested before, the answer is \
                          `None`.";
            return fault("wrong-hit", advice);
        }
        let advice = "Some primitives are tested again, because the note about them was lost. Keep all notes until the ray is done.";
        fault("forgetful", advice)
    }
}

/// What a ray hits first, or anything that it hits.
fn search<P: Primitives<Entry = Entry>>(
    structure: &Structure<P, Grid<Entry>>,
    ray: &Ray,
    range: Interval,
    any: bool,
) -> Option<Found> {
    if any { structure.any(ray, range, &mut ()) } else { structure.nearest(ray, range, &mut ()) }
}

/// The numbers, each only where it comes first.
fn once(numbers: &[u32]) -> Vec<u32> {
    let mut seen = HashSet::new();
    numbers.iter().copied().filter(|number| seen.insert(*number)).collect()
}

/// The rays through the center of a triangle from several sides.
fn toward(triangles: &Triangles, number: u32) -> [Ray; 2] {
    let [a, b, c] = triangles.0.triangle(number as usize).corners;
    let (center, normal) = ((a + b + c) / 3.0, (b - a).cross(c - a));
    [1.0, -1.0].map(|side| Ray::new(center + normal.normalize_or_zero() * side, -normal * side))
}

/// One view, asked again and again.
fn alone<M: Primitives<Entry = Entry>>(make: &impl Fn(Logged) -> M, triangles: &Triangles, was_asked: bool) -> Verdict {
    let mailed = make(Logged(triangles.clone()));
    let ask = |number: u32, view: &M::View, ray: &Ray, range: Interval| {
        let tried = || format!("primitive {number}, by {}, {}", words::ray(ray), words::range(range));
        let (t, log) = logging(|| trying(tried, || mailed.intersect(&mailed.entry(number), view, range)));
        (t, log, tried())
    };
    let told = |t: Option<f32>| t.map_or("no hit".into(), |t| format!("a hit at t = {t}"));
    for number in [0, 1, 17] {
        let [ray, _] = toward(triangles, number);
        let make_view = || trying(|| words::ray(&ray), || mailed.view(&ray));
        let mut is_asked_again = [false; 2];
        let mut again = String::new();
        // A hit, and two ranges without it.
        for range in [Interval::POSITIVE, Interval::new(0.0, 0.001), Interval::new(1e9, 2e9)] {
            let view = make_view();
            let right = triangles.intersect(&triangles.entry(number), &triangles.view(&ray), range);
            let (t, log, tried) = ask(number, &view, &ray, range);
            if log != [number] {
                // Notes from before stay; a condition the wrong way round does not.
                let is_noted = log.is_empty() && ask(number, &view, &ray, range).1.is_empty();
                let (name, advice) = match was_asked && is_noted {
                    true => OLD_NOTES,
                    false => {
                        ("never-tested", "When there is no note about a primitive yet, ask `self.0.intersect`, once.")
                    }
                };
                let got = format!("tested: {}", words::numbers(&log));
                let expected = format!("tested: {number}");
                return Err(Finding { tried, got, expected, advice: advice.into() }.named(name));
            }
            if t != right {
                let advice = "Hand the same entry and the same range on, and return what comes back.";
                return Err(
                    Finding { tried, got: told(t), expected: told(right), advice: advice.into() }.named("wrong-answer")
                );
            }
            let (second, log, tried) = ask(number, &view, &ray, range);
            if !log.is_empty() || second.is_some() {
                is_asked_again[usize::from(right.is_some())] = true;
                again = tried;
            }
        }
        let (name, advice) = match is_asked_again {
            [true, true] => {
                ("no-note", "The second time, there must be a note about this primitive, and the answer is `None`.")
            }
            [false, true] => ("hits-again", HIT_OR_MISS),
            [true, false] => ("misses-again", HIT_OR_MISS),
            [false, false] => continue,
        };
        return Err(Finding {
            tried: format!("{again}, asked about twice with the same view"),
            got: "it was tested twice, or the second answer was a hit".into(),
            expected: "one test, and `None` as the second answer".into(),
            advice: advice.into(),
        }
        .named(name));
    }
    Ok(())
}

const OLD_NOTES: (&str, &str) = (
    "old-notes",
    "A note is left from a ray before, or the table of notes starts with 0, which is the number of a primitive. Notes belong to one \
     ray, and the next one begins without any: let them lie in its view, and let an empty place hold no number, as `None` does.",
);

const HIT_OR_MISS: &str =
    "A note belongs to every test, whether it says hit or not. Here only one of the two is noted.";

/// Two rays on their way at the same time.
fn together<M: Primitives<Entry = Entry>>(make: &impl Fn(Logged) -> M, triangles: &Triangles) -> Verdict {
    let mailed = make(Logged(triangles.clone()));
    for number in [0, 1, 17] {
        let rays = toward(triangles, number);
        let tried = || {
            let [a, b] = rays.map(|ray| words::ray(&ray));
            format!("primitive {number}, by two rays at the same time: {a} and {b}")
        };
        let views = rays.map(|ray| trying(tried, || mailed.view(&ray)));
        let entry = mailed.entry(number);
        let got = [0, 1, 0, 1].map(|i| trying(tried, || mailed.intersect(&entry, &views[i], Interval::POSITIVE)));
        let is_right = got.map(|t| t.is_some()) == [true, true, false, false];
        if !is_right {
            let got = got.map(|t| if t.is_some() { "hit" } else { "none" }).join(", ");
            let advice = "The notes of one ray are seen, or taken away, by another one. Each ray has a view of its own: let the \
                          notes lie there, and not in `Mailboxed` or in a static variable.";
            return Err(Finding {
                tried: tried(),
                got: format!("{got}, when the first and the second ray ask by turns"),
                expected: "hit, hit, none, none".into(),
                advice: advice.into(),
            }
            .named("shared-notes"));
        }
    }
    Ok(())
}
