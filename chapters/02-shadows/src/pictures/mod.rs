//! The pictures of this chapter.

mod acne;
mod colored_lights;
mod epsilons;
mod inverse_square;
mod lamp_between;
mod props;
mod scaled;
pub mod still_life;
mod table;
mod terminator;
mod without_and_with;

use common::picture::Chapter;

/// Chapter 2 with all its pictures.
pub const CHAPTER: Chapter = Chapter {
    number: 2,
    name: "shadows",
    title: "Shadows",
    pictures: &[
        still_life::PICTURE,
        without_and_with::PICTURE,
        acne::PICTURE,
        epsilons::PICTURE,
        scaled::PICTURE,
        lamp_between::PICTURE,
        inverse_square::PICTURE,
        colored_lights::PICTURE,
        terminator::PICTURE,
    ],
    reports: &[],
};
