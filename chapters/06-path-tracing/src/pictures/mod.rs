//! The pictures of this chapter.

mod comparisons;
pub mod courtyard;
mod knobs;
pub mod room;
mod sheet;
pub mod steps;

use common::picture::Chapter;

/// Chapter 6 with all its pictures.
pub const CHAPTER: Chapter = Chapter {
    number: 6,
    name: "path-tracing",
    title: "Path tracing",
    pictures: &[
        courtyard::PICTURE,
        room::PICTURE,
        comparisons::SAMPLES,
        steps::STEPS,
        comparisons::DIRECTIONS,
        comparisons::LOCAL,
        comparisons::BOUNCES,
        comparisons::ERROR,
        steps::ROULETTE,
    ],
    reports: &[],
};
