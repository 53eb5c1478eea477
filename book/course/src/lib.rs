//! The list of all chapters, for whatever looks at the whole course: the book, the tests, the demos in a web page.

pub mod bits;
#[cfg(target_arch = "wasm32")]
mod exports;
pub mod live;

use common::picture::Chapter;

/// The chapters in their order.
pub const CHAPTERS: &[Chapter] = &[
    ray_casting::CHAPTER,
    shadows::CHAPTER,
    whitted::CHAPTER,
    space_partitioning::CHAPTER,
    sampling::CHAPTER,
    path_tracing::CHAPTER,
];
