//! Wrong grids in a grid.

use common::{Interval, exercise::dice::Dice};
use ray_casting::{aabb::Aabb, ray::Ray};
use space_partitioning::{
    grid::{DENSITY, Grid, grid},
    primitives::{Primitives, overlap},
    probe::{Counts, Probe},
    query::{Query, Question},
    structure::Partition,
};

use crate::{
    checks::{
        blocks::{Blocks, Content, Part, TwoLevel, filled},
        meshes::{in_stadium, stadium},
        two_level_grid::check,
    },
    name,
};

/// The right answer, but for the fault of that number.
struct Wrong<const FAULT: usize>;

/// No fault.
const NONE: usize = 0;
// Faults of `content`.
const EMPTY: usize = 1;
const EVERYTHING: usize = 2;
const BY_BOXES: usize = 3;
const BY_CENTER: usize = 4;
const ALL_OF_IT: usize = 5;
const ALWAYS_LIST: usize = 6;
const ALWAYS_GRID: usize = 7;
const GRID_OVER_ALL: usize = 8;
const UNCLIPPED: usize = 9;
const COARSE: usize = 10;
const OTHER_LIMIT: usize = 11;
const NO_ERR: usize = 20;
const EMPTY_ON_ERR: usize = 21;
// Faults of `walk`.
const NOWHERE: usize = 12;
const NEVER_ENDS: usize = 13;
const ENDS_LATE: usize = 14;
const ENDS_EARLY: usize = 15;
const SILENT: usize = 16;
const LISTS_ONLY: usize = 17;
const BACKWARD: usize = 18;
const GRID_HIT_IGNORED: usize = 19;

impl<const FAULT: usize> TwoLevel for Wrong<FAULT> {
    fn content<P: Primitives>(primitives: &P, numbers: &[u32], block: &Aabb) -> Content<P::Entry> {
        let is_inside = |number: &u32| {
            let aabb = primitives.aabb(*number);
            match FAULT {
                EMPTY => false,
                EVERYTHING => true,
                BY_BOXES => overlap(&aabb, block).is_some(),
                BY_CENTER => block.contains(aabb.center()),
                ALL_OF_IT => block.contains(aabb.min) && block.contains(aabb.max),
                _ => primitives.clipped(*number, block).is_some(),
            }
        };
        let inside: Vec<u32> = numbers.iter().copied().filter(is_inside).collect();
        let list = |numbers: &[u32]| Content::List(numbers.iter().map(|&number| primitives.entry(number)).collect());
        let few = match FAULT {
            ALWAYS_LIST => usize::MAX,
            ALWAYS_GRID => 0,
            OTHER_LIMIT => 23,
            _ => 24,
        };
        if inside.len() <= few {
            return list(&inside);
        }
        let everything = Aabb { min: -1000.0 * common::Vec3::ONE, max: 1000.0 * common::Vec3::ONE };
        let grid = match FAULT {
            GRID_OVER_ALL => Grid::over(primitives, DENSITY),
            UNCLIPPED => Grid::over(&Part::new(primitives, &inside, &everything), DENSITY),
            COARSE => Grid::over(&Part::new(primitives, &inside, block), 1.0),
            _ => Grid::over(&Part::new(primitives, &inside, block), DENSITY),
        };
        if FAULT == NO_ERR {
            return Content::Grid(grid.expect("a grid"));
        }
        match grid {
            Ok(grid) => Content::Grid(grid),
            Err(_) if FAULT == EMPTY_ON_ERR => list(&[]),
            Err(_) => list(&inside),
        }
    }

    fn walk<P: Primitives, Q: Question, N: Probe>(
        blocks: &Blocks,
        contents: &[Content<P::Entry>],
        ray: &Ray,
        query: &mut Query<'_, P, Q, N>,
    ) {
        let mut along = blocks.along(ray, query.range());
        match FAULT {
            NOWHERE => along.clear(),
            BACKWARD => along.reverse(),
            _ => {}
        }
        for (number, inside) in along {
            if inside.min > query.range().max && FAULT != NEVER_ENDS && FAULT != BACKWARD {
                return;
            }
            if FAULT != SILENT {
                query.visit(number);
            }
            let is_over = match &contents[number as usize] {
                Content::List(list) => query.test(list),
                Content::Grid(_) if FAULT == LISTS_ONLY => false,
                Content::Grid(grid) => {
                    Partition::<P>::walk(grid, ray, query);
                    FAULT != GRID_HIT_IGNORED && Q::ANY_HIT && query.found().is_some()
                }
            };
            if is_over && FAULT != ENDS_LATE || FAULT == ENDS_EARLY && query.found().is_some() {
                return;
            }
        }
    }
}

fn diagnosis<const FAULT: usize>() -> &'static str {
    name(check::<Wrong<FAULT>>())
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(check::<Wrong<NONE>>(), Ok(()));
}

/// Nothing in the blocks, and no walk.
struct Nothing;

impl TwoLevel for Nothing {
    fn content<P: Primitives>(_: &P, _: &[u32], _: &Aabb) -> Content<P::Entry> {
        Content::List(Vec::new())
    }

    fn walk<P: Primitives, Q: Question, N: Probe>(
        _: &Blocks,
        _: &[Content<P::Entry>],
        _: &Ray,
        _: &mut Query<'_, P, Q, N>,
    ) {
    }
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(name(check::<Nothing>()), "not-started");
    assert_eq!(diagnosis::<EMPTY>(), "missing");
    assert_eq!(diagnosis::<NOWHERE>(), "wrong-hit");
}

#[test]
fn wrong_contents() {
    // A grid over a part leaves out what does not reach into the block, but then there are too few for a grid.
    assert_eq!(diagnosis::<EVERYTHING>(), "grid-for-few");
    assert_eq!(diagnosis::<BY_BOXES>(), "by-boxes");
    assert_eq!(diagnosis::<BY_CENTER>(), "missing");
    assert_eq!(diagnosis::<ALL_OF_IT>(), "missing");
    assert_eq!(diagnosis::<ALWAYS_LIST>(), "no-grid");
    assert_eq!(diagnosis::<ALWAYS_GRID>(), "grid-for-few");
    assert_eq!(diagnosis::<GRID_OVER_ALL>(), "everything");
    assert_eq!(diagnosis::<UNCLIPPED>(), "grid-beyond-block");
    assert_eq!(diagnosis::<COARSE>(), "other-density");
    assert_eq!(diagnosis::<OTHER_LIMIT>(), "grid-for-few");
    assert_eq!(diagnosis::<EMPTY_ON_ERR>(), "no-list");
}

#[test]
#[should_panic(expected = "NotFinite")]
fn a_grid_that_cannot_be_made() {
    let _ = check::<Wrong<NO_ERR>>();
}

#[test]
fn wrong_walks() {
    assert_eq!(diagnosis::<NEVER_ENDS>(), "goes-on-behind");
    assert_eq!(diagnosis::<ENDS_LATE>(), "any-goes-on");
    assert_eq!(diagnosis::<GRID_HIT_IGNORED>(), "any-goes-on");
    assert_eq!(diagnosis::<ENDS_EARLY>(), "ends-early");
    assert_eq!(diagnosis::<SILENT>(), "not-counted");
    assert_eq!(diagnosis::<LISTS_ONLY>(), "wrong-hit");
    assert_eq!(diagnosis::<BACKWARD>(), "wrong-walk");
}

#[test]
fn two_levels_take_less_than_half_of_the_steps() {
    let triangles = stadium();
    let flat = grid(triangles.clone()).unwrap();
    let two = filled::<_, Wrong<NONE>>(triangles, 12);
    let (mut in_flat, mut in_two) = (Counts::default(), Counts::default());
    let mut dice = Dice::new(455);
    for _ in 0..2000 {
        let ray = in_stadium(&mut dice);
        let [a, b] =
            [flat.nearest(&ray, Interval::POSITIVE, &mut in_flat), two.nearest(&ray, Interval::POSITIVE, &mut in_two)];
        assert_eq!(a, b);
    }
    assert!(in_two.steps() * 2 < in_flat.steps(), "{in_two:?} {in_flat:?}");
}
