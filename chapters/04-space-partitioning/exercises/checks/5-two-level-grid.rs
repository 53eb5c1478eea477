//! Checks exercise 4.5, grids in a grid.

use std::collections::BTreeSet;

use common::{
    Interval, Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use ray_casting::{aabb::Aabb, ray::Ray};
use space_partitioning::{
    every_one::every_one,
    grid::{DENSITY, Grid},
    primitives::{Primitives, overlap},
    probe::{Probe, Walk},
    query::{Any, Found, Nearest, Query, Question},
    scenes::builder::Builder,
    structure::{Partition, Structure},
    triangles::Triangles,
};

use super::{
    blocks::{Blocks, Content, Filled, Part, TwoLevel, filled},
    meshes::{in_stadium, soup, stadium, through_soup, triangles},
    words,
};

/// Blocks with more primitives get a grid.
const FEW: usize = 24;
/// What a list holds of a triangle.
type Entry = <Triangles as Primitives>::Entry;

/// Accept two levels, or name what is wrong with them.
pub(crate) fn check<T: TwoLevel>() -> Verdict {
    let triangles = soup(45, 600);
    let everywhere = Aabb { min: Vec3::splat(-20.0), max: Vec3::splat(20.0) };
    let all: Vec<u32> = (0..triangles.count()).collect();
    let mut dice = Dice::new(451);
    let rays: Vec<_> = (0..150).map(|_| through_soup(&mut dice)).collect();
    let is_empty = matches!(content::<T>(&triangles, &all, &everywhere), Content::List(list) if list.is_empty());
    if is_empty {
        let structure = made::<T>(&triangles, 2);
        let walks = |ray: &Ray| outcome::<T, Nearest>(&structure, ray, Interval::POSITIVE).1 != Walk::default();
        if !rays.iter().any(walks) {
            return Err(Diagnosis::not_started("Every block is empty, and `walk` goes nowhere."));
        }
    }
    // Blocks from as large as all triangles to very small.
    block::<T>(&triangles, &all, &everywhere)?;
    for _ in 0..60 {
        let (center, half) = (dice.point(4.0), dice.choice([4.0, 2.0, 1.0, 0.5, 0.1]));
        block::<T>(&triangles, &all, &Aabb { min: center - half, max: center + half })?;
    }
    // Only some of them, in an order of their own.
    let backward: Vec<u32> = all.iter().rev().copied().collect();
    for count in [0, 1, 10, FEW - 1, FEW, FEW + 1, 100] {
        block::<T>(&triangles, &backward[..count], &everywhere)?;
    }
    block_without_grid::<T>()?;
    // Walks, at last through blocks of which only the one around the teapot has a grid.
    for count in [1, 3, 8] {
        walks::<T>(&triangles, count, &rays)?;
    }
    let rays: Vec<_> = (0..100).map(|_| in_stadium(&mut dice)).collect();
    walks::<T>(&stadium(), 5, &rays)
}

fn block_words(numbers: &[u32], block: &Aabb) -> String {
    const MANY_DIGITS: f32 = 1e9;
    let triangles = words::counted(numbers.len(), "triangle");
    if block.max.x > MANY_DIGITS {
        return format!("the block from {:e} to {:e} along each axis, and {triangles}", block.min.x, block.max.x);
    }
    let (min, max) = (words::triple(block.min), words::triple(block.max));
    format!("the block from {min} to {max}, and {triangles}")
}

fn content<T: TwoLevel>(triangles: &Triangles, numbers: &[u32], block: &Aabb) -> Content<Entry> {
    trying(|| block_words(numbers, block), || T::content(triangles, numbers, block))
}

fn made<T: TwoLevel>(triangles: &Triangles, count: u16) -> Structure<Triangles, Filled<Entry, T>> {
    trying(
        || format!("{} triangles in {count} × {count} × {count} blocks", triangles.count()),
        || filled(triangles.clone(), count),
    )
}

/// What one block holds.
fn block<T: TwoLevel>(triangles: &Triangles, numbers: &[u32], block: &Aabb) -> Verdict {
    let content = content::<T>(triangles, numbers, block);
    let expected: Vec<u32> =
        numbers.iter().copied().filter(|&number| triangles.clipped(number, block).is_some()).collect();
    let fault = |name, got: String, wanted: String, advice: &str| {
        Err(Finding { tried: block_words(numbers, block), got, expected: wanted, advice: advice.into() }.named(name))
    };
    let kind = if expected.len() > FEW { "a grid over" } else { "a list of" };
    let list_words =
        |numbers: &[u32]| format!("{}: {}", words::counted(numbers.len(), "primitive"), words::numbers(numbers));
    let wanted = format!("{kind} {}", list_words(&expected));
    let (grid, got) = match &content {
        Content::List(list) => (None, list.iter().map(|entry| triangles.number(entry)).collect::<Vec<_>>()),
        Content::Grid(grid) => {
            let cells = Partition::<Triangles>::cells(grid);
            let numbers: BTreeSet<u32> =
                cells.iter().flat_map(|cell| cell.list.iter().map(|entry| triangles.number(entry))).collect();
            (Some(grid), numbers.into_iter().collect())
        }
    };
    let kind = if grid.is_some() { "a grid over" } else { "a list of" };
    let told = format!("{kind} {}", list_words(&got));
    let sorted: BTreeSet<u32> = got.iter().copied().collect();
    let reaches = |number: &u32| expected.contains(number);
    if let Some(missing) = expected.iter().find(|number| !sorted.contains(number)) {
        let advice = format!(
            "Primitive {missing} reaches into the block, but is not there. A primitive belongs to every block that some part of it \
             lies in, not only to that of its center, and not only if all of it lies there."
        );
        return fault("missing", told, wanted, &advice);
    }
    if let Some(extra) = got.iter().find(|number| !reaches(number)) {
        let by_box = |number: &u32| overlap(&triangles.aabb(*number), block).is_some();
        if sorted.len() == numbers.len() {
            let advice = "The block holds all primitives that there are. Leave out those that do not reach into it; a grid is to be \
                          over a `Part`.";
            return fault("everything", told, wanted, advice);
        }
        let advice = format!("Primitive {extra} does not reach into the block.");
        if got.iter().all(by_box) {
            let advice = format!("{advice} Its box does, but it passes by in a corner of it: ask `clipped`.");
            return fault("by-boxes", told, wanted, &advice);
        }
        return fault("too-many", told, wanted, &advice);
    }
    let Some(grid) = grid else {
        if expected.len() > FEW {
            return fault("no-grid", told, wanted, "A block with more than `FEW` primitives holds a grid.");
        }
        if got != expected {
            return fault("wrong-list", told, wanted, "The list has each of them once, in the order of `numbers`.");
        }
        return Ok(());
    };
    if expected.len() <= FEW {
        let advice = "A block with `FEW` primitives or less holds a list. Count those that reach into the block, and not all of `numbers`.";
        return fault("grid-for-few", told, wanted, advice);
    }
    if !is_inside(Partition::<Triangles>::aabb(grid), block) {
        let advice = "This grid reaches beyond its block. Make it over a `Part` of the block's own box.";
        return fault("grid-beyond-block", told, wanted, advice);
    }
    let Ok(right) = Grid::over(&Part::new(triangles, &expected, block), DENSITY) else { return Ok(()) };
    if grid.resolution() != right.resolution() {
        let told = |grid: &Grid<Entry>| format!("a grid of {:?} cells", grid.resolution());
        return fault("other-density", told(grid), told(&right), "The grid of a block has a density of `DENSITY`.");
    }
    Ok(())
}

/// A block with many primitives, and no grid over them: twice their size is no number any more.
fn block_without_grid<T: TwoLevel>() -> Verdict {
    const FAR: f32 = 3e38;
    let corners = |y: u16| [Vec3::new(0.0, f32::from(y), 0.0), Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 0.0, FAR)];
    let mut builder = Builder::default();
    for y in 1..40 {
        let corners = corners(y).map(|corner| builder.vertex(corner));
        builder.triangle(corners);
    }
    let triangles = triangles(&builder.mesh);
    let numbers: Vec<u32> = (0..triangles.count()).collect();
    let block = Aabb { min: Vec3::splat(-FAR), max: Vec3::splat(FAR) };
    let content = content::<T>(&triangles, &numbers, &block);
    let got = match &content {
        Content::List(list) => list.iter().map(|entry| triangles.number(entry)).collect::<Vec<_>>(),
        Content::Grid(_) => Vec::new(),
    };
    if got == numbers {
        return Ok(());
    }
    let kind = if matches!(content, Content::Grid(_)) {
        "a grid".into()
    } else {
        format!("a list of {}", words::numbers(&got))
    };
    Err(Finding {
        tried: format!("{}, so large that `Grid::over` returns an `Err`", block_words(&numbers, &block)),
        got: kind,
        expected: format!("a list of {}", words::numbers(&numbers)),
        advice: "Where there is no grid, the block lists its primitives, however many they are.".into(),
    }
    .named("no-list"))
}

/// Whether a box lies inside of a block, but for rounding.
fn is_inside(aabb: Option<Aabb>, block: &Aabb) -> bool {
    let room = (block.max - block.min) * 1e-3;
    let larger = Aabb { min: block.min - room, max: block.max + room };
    aabb.is_some_and(|aabb| larger.contains(aabb.min) && larger.contains(aabb.max))
}

/// What one walk finds, and its steps.
fn outcome<T: TwoLevel, Q: Question>(
    structure: &Structure<Triangles, Filled<Entry, T>>,
    ray: &Ray,
    range: Interval,
) -> (Option<Found>, Walk) {
    let mut walk = Walk::default();
    let mut query = Query::<_, Q, _>::new(&structure.primitives, ray, range, &mut walk);
    trying(|| tried::<Q>(ray, range), || structure.partition.walk(ray, &mut query));
    (query.found(), walk)
}

fn tried<Q: Question>(ray: &Ray, range: Interval) -> String {
    let question = if Q::ANY_HIT { "any hit" } else { "the nearest hit" };
    format!("{question} of {}, {}", words::ray(ray), words::range(range))
}

/// Rays through blocks, as many of them along each axis.
fn walks<T: TwoLevel>(triangles: &Triangles, count: u16, rays: &[Ray]) -> Verdict {
    let structure = made::<T>(triangles, count);
    #[expect(clippy::unwrap_used, reason = "these triangles are finite and few")]
    let brute = every_one(triangles.clone()).unwrap();
    for ray in rays {
        for range in [Interval::POSITIVE, Interval::new(0.2, 0.9)] {
            let expected = brute.nearest(ray, range, &mut ());
            walk::<T, Nearest>(&structure, ray, range, expected)?;
            walk::<T, Any>(&structure, ray, range, expected)?;
        }
    }
    Ok(())
}

/// One ray.
fn walk<T: TwoLevel, Q: Question>(
    structure: &Structure<Triangles, Filled<Entry, T>>,
    ray: &Ray,
    range: Interval,
    expected: Option<Found>,
) -> Verdict {
    let (found, steps) = outcome::<T, Q>(structure, ray, range);
    let fault = |name, got: String, wanted: String, advice: &str| {
        Err(Finding { tried: tried::<Q>(ray, range), got, expected: wanted, advice: advice.into() }.named(name))
    };
    let is_right = if Q::ANY_HIT { found.is_some() == expected.is_some() } else { found == expected };
    if !is_right {
        let advice = "Does the walk visit every block that the ray meets, lists as well as grids, until a hit lies before the next \
                      block?";
        let ends_early = steps == steps_of::<T, Q>(structure, ray, range, Faults { ends_early: true, ..Faults::NONE });
        let (name, advice) =
            if ends_early && found.is_some() { ("ends-early", ENDS_EARLY) } else { ("wrong-hit", advice) };
        return fault(name, words::found(found), words::found(expected), advice);
    }
    let others = [
        (Faults { never_ends: true, ..Faults::NONE }, "goes-on-behind", GOES_ON_BEHIND),
        (Faults { ends_late: true, ..Faults::NONE }, "any-goes-on", ANY_GOES_ON),
        (Faults { never_ends: true, ends_late: true, ..Faults::NONE }, "goes-on", GOES_ON),
        (Faults { ends_early: true, ..Faults::NONE }, "ends-early", ENDS_EARLY),
        (Faults { is_silent: true, ..Faults::NONE }, "not-counted", NOT_COUNTED),
    ];
    let right = steps_of::<T, Q>(structure, ray, range, Faults::NONE);
    if steps == right {
        return Ok(());
    }
    let known = others.iter().find(|(faults, ..)| steps_of::<T, Q>(structure, ray, range, *faults) == steps);
    let (name, advice) = match known {
        Some((_, name, advice)) => (*name, *advice),
        None if steps.tests == right.tests => ("not-counted", NOT_COUNTED),
        None => (
            "wrong-walk",
            "The hit is right, but the steps are not. Take the blocks in the order of `along`, visit and test each of them once, and stop \
             where nothing can be found any more.",
        ),
    };
    let told = |walk: &Walk| {
        let [cells, tests] = [(walk.cells.len(), "cell"), (walk.tests.len(), "primitive")];
        format!("{} visited, {} tested", words::counted(cells.0, cells.1), words::counted(tests.0, tests.1))
    };
    fault(name, told(&steps), told(&right), advice)
}

const GOES_ON_BEHIND: &str = "A block that begins behind the nearest hit so far cannot hold a nearer one. Compare `inside.min` with \
                              `query.range().max` before each block: it becomes less with every hit.";
const ANY_GOES_ON: &str = "Any hit will do here, and there was one, but the walk went on. `query.test` says whether the search is over. A \
                           walk through a grid does not: it is over if `Q::ANY_HIT` and something was found.";
const ENDS_EARLY: &str = "The first block with a hit does not end the search for the nearest one: a triangle that reaches into several \
                          blocks may be hit in a later one, and another triangle before. Compare `inside.min` with `query.range().max`.";
const GOES_ON: &str = "The walk goes on after the hit that it looked for. Compare `inside.min` with `query.range().max` before each block, \
                       and stop when any hit will do and there is one.";
const NOT_COUNTED: &str =
    "Every block that is entered is told to `query.visit`, once, by its number, before its list or its grid.";

/// What is wrong with a walk to compare with.
#[derive(Clone, Copy)]
struct Faults {
    never_ends: bool,
    ends_late: bool,
    ends_early: bool,
    is_silent: bool,
}

impl Faults {
    const NONE: Self = Self { never_ends: false, ends_late: false, ends_early: false, is_silent: false };
}

/// The steps of a walk with these faults.
fn steps_of<T: TwoLevel, Q: Question>(
    structure: &Structure<Triangles, Filled<Entry, T>>,
    ray: &Ray,
    range: Interval,
    faults: Faults,
) -> Walk {
    let mut walk = Walk::default();
    let mut query = Query::<_, Q, _>::new(&structure.primitives, ray, range, &mut walk);
    let Filled { blocks, contents, .. } = &structure.partition;
    go(blocks, contents, ray, &mut query, faults);
    walk
}

fn go<Q: Question, N: Probe>(
    blocks: &Blocks,
    contents: &[Content<Entry>],
    ray: &Ray,
    query: &mut Query<'_, Triangles, Q, N>,
    faults: Faults,
) {
    for (number, inside) in blocks.along(ray, query.range()) {
        if inside.min > query.range().max && !faults.never_ends {
            return;
        }
        if !faults.is_silent {
            query.visit(number);
        }
        match &contents[number as usize] {
            Content::List(list) => {
                query.test(list);
            }
            Content::Grid(grid) => Partition::<Triangles>::walk(grid, ray, query),
        }
        if query.found().is_some() && (Q::ANY_HIT && !faults.ends_late || faults.ends_early) {
            return;
        }
    }
}
