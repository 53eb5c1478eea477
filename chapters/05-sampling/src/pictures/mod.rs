//! The pictures of this chapter.

mod convergence;
pub(crate) mod disc_samples;
mod hemisphere_samples;
mod light_from_everywhere;
mod palette;
mod regular_and_random;
pub mod tangent_frame;
pub mod uniform_against_cosine;

use common::picture::Chapter;

use crate::reports::REPORTS;

/// Chapter 5 with all its pictures.
pub const CHAPTER: Chapter = Chapter {
    number: 5,
    name: "sampling",
    title: "Monte Carlo sampling",
    pictures: &[
        light_from_everywhere::PICTURE,
        regular_and_random::PICTURE,
        convergence::PICTURE,
        hemisphere_samples::PICTURE,
        tangent_frame::PICTURE,
        disc_samples::PICTURE,
        uniform_against_cosine::PICTURE,
    ],
    reports: REPORTS,
};
