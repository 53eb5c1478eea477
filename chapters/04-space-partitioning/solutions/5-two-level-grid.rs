//! # Exercise 4.5: grids in a grid
//!
//! A regular grid over a teapot in a stadium has cells as large as a rank of seats, and one of them holds the whole teapot with
//! its thousands of triangles. Finer cells everywhere do not help: nearly all of them would be empty.
//!
//! Make it two levels. Divide the stadium into few **blocks**. Where a block has few triangles it lists them. Where it has many,
//! it gets a grid of its own, whose cells are as small as that block needs.
//!
//! ## Your task
//!
//! Fill in `content` and `walk` below. This is what you are given, in `checks/blocks.rs` and in the chapter:
//!
//! ```text
//! enum Content<E> { List(Vec<E>), Grid(Grid<E>) }     // of a block; E is an entry
//!
//! blocks.along(ray, range) -> Vec<(u32, Interval)>    // the blocks that a ray meets, from front to back: of each its number,
//!                                                     // and `inside`, the part of `range` in which the ray is inside
//! Part::new(primitives, &numbers, block)              // a part of some primitives: those of these numbers (`&[u32]`), and of
//!                                                     // them only what lies inside of the block (`&Aabb`)
//! Grid::over(&part, DENSITY)                          // a grid over a part: a `Result`
//!
//! primitives.clipped(number, block)                   // the box around what lies in the block; `None` if nothing does
//! primitives.entry(number)                            // what a list has of a primitive
//!
//! query.range()                                       // where hits count: it ends just behind the nearest one so far
//! query.visit(number)                                 // counts a visit to a block
//! query.test(&list)                                   // tests a list; `true` if the search is over
//! query.found()                                       // the best hit so far
//! Partition::<P>::walk(&grid, ray, query)             // lets the ray go through a grid
//! Q::ANY_HIT                                          // whether any hit ends the search
//! ```
//!
//! `content` says what a block holds. `numbers` are all primitives that there are.
//!
//! - Of them, those count of which some part lies in the block: where `clipped` returns a box.
//! - If they are at most `FEW`, the content is a list of their entries, in the order of `numbers`.
//! - If they are more, it is a grid over that part, with a density of `DENSITY`. When there is no such grid (an `Err`, for instance
//!   because some of them have no finite size) the content is a list of their entries all the same.
//!
//! `walk` lets a ray go through the blocks, from front to back:
//!
//! - Each block that is entered is told to `query.visit`, by its number, and before what it holds is tested. What it holds is
//!   `contents[number as usize]`: an index is a `usize`, and numbers are `u32`.
//! - A block that the ray enters only behind the end of `query.range()` is not entered, nor are those behind it. The range may have
//!   become shorter since the last block. It is enough to compare with `inside.min` of the block.
//! - The search is over when `query.test` says so. A walk through a grid does not say so: it is over if any hit will do and there is one.
//!
//! Is the hit not to lie in the block, as it must in other tutorials? No. A triangle that reaches into several blocks may be hit in one
//! that is still to come. But the range then ends just behind that hit, and the blocks up to there are still visited.
//!
//! ## When you are done
//!
//! `cargo exercise 4.5` checks your answer and renders a teapot in a stadium. The brighter a pixel, the more steps its ray
//! took (eight times as many are twice as bright): on the left in a flat grid, on the right in yours.

use std::process::ExitCode;

use common::{
    exercise::{self, Verdict},
    picture::Picture,
};
use ray_casting::{aabb::Aabb, ray::Ray};
#[allow(unused_imports, reason = "the answer needs them")]
use space_partitioning::{
    grid::{DENSITY, Grid},
    primitives::Primitives,
    probe::Probe,
    query::{Query, Question},
    structure::Partition,
};

#[allow(unused_imports, reason = "the answer needs them")]
use checks::blocks::{Blocks, Content, Part, TwoLevel};

/// Blocks with more primitives get a grid.
#[allow(dead_code, reason = "the answer needs it")]
const FEW: usize = 24;

/// The two levels: what fills a block, and how a ray goes through all of them.
struct TwoLevelGrid;

impl TwoLevel for TwoLevelGrid {
    /// What a block holds.
    fn content<P: Primitives>(primitives: &P, numbers: &[u32], block: &Aabb) -> Content<P::Entry> {
        // STUB: let _ = (primitives, numbers, block); // take this line away when you start
        // STUB: Content::List(Vec::new())
        let reaching: Vec<_> =
            numbers.iter().copied().filter(|&number| primitives.clipped(number, block).is_some()).collect();
        let list = || Content::List(reaching.iter().map(|&number| primitives.entry(number)).collect());
        if reaching.len() <= FEW {
            return list();
        }
        Grid::over(&Part::new(primitives, &reaching, block), DENSITY).map_or_else(|_| list(), Content::Grid)
        // END STUB
    }

    /// Walk through the blocks along a ray.
    fn walk<P: Primitives, Q: Question, N: Probe>(
        blocks: &Blocks,
        contents: &[Content<P::Entry>],
        ray: &Ray,
        query: &mut Query<'_, P, Q, N>,
    ) {
        // STUB: let _ = (blocks, contents, ray, query); // take this line away when you start
        for (number, inside) in blocks.along(ray, query.range()) {
            // Whatever this block and those behind it hold, a hit lies before it.
            if inside.min > query.range().max {
                return;
            }
            query.visit(number);
            let is_over = match &contents[number as usize] {
                Content::List(list) => query.test(list),
                Content::Grid(grid) => {
                    Partition::<P>::walk(grid, ray, query);
                    Q::ANY_HIT && query.found().is_some()
                }
            };
            if is_over {
                return;
            }
        }
        // END STUB
    }
}

// From here on your grid is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your grid saves.
const PICTURE: Picture = pictures::two_level_grid::picture(pictures::two_level_grid::make::<TwoLevelGrid>);

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your grid is right.
fn accepted() -> Verdict {
    checks::two_level_grid::check::<TwoLevelGrid>()
}
