//! The list of all chapters, for whatever looks at the whole course: the book, the tests, the demos in a web page.

pub mod bits;
#[cfg(target_arch = "wasm32")]
mod exports;
pub mod live;

use common::picture::{Chapter, Picture};

/// The chapters in their order.
pub const CHAPTERS: &[Chapter] = &[
    ray_casting::CHAPTER,
    shadows::CHAPTER,
    whitted::CHAPTER,
    space_partitioning::CHAPTER,
    sampling::CHAPTER,
    path_tracing::CHAPTER,
];

/// Pictures that hang on the wall: chapter, name, and with how many samples per pixel they are pinned. By themselves they
/// have fewer, so that nobody waits.
const POSTERS: &[(&str, &str, u32)] = &[("path-tracing", "courtyard", 512)];

/// With how many samples per pixel a picture is pinned if they are more than it has by itself.
#[must_use]
pub fn poster_samples(chapter: &str, picture: &Picture) -> Option<u32> {
    POSTERS.iter().find(|(of, name, _)| *of == chapter && *name == picture.name).map(|(_, _, samples)| *samples)
}
