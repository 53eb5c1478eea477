//! The pictures of this chapter.

mod building;
mod cells;
mod growth;
mod heat;
mod log_plots;
mod losers;
mod palette;
mod scene;
mod scenes;
mod surface_area_cost;
mod walks;

use common::picture::Chapter;

/// Chapter 4 with all its pictures.
pub const CHAPTER: Chapter = Chapter {
    number: 4,
    name: "space-partitioning",
    title: "Space partitioning",
    pictures: &[
        scenes::SHADED[0],
        scenes::STEPS[0],
        scenes::SHADED[1],
        scenes::STEPS[1],
        scenes::SHADED[2],
        scenes::STEPS[2],
        scenes::SHADED[3],
        scenes::STEPS[3],
        scenes::SHADED[4],
        scenes::STEPS[4],
        scenes::SHADED[5],
        scenes::STEPS[5],
        scenes::SHADED[6],
        scenes::STEPS[6],
        scenes::SHADED[7],
        scenes::STEPS[7],
        scenes::SHADED[8],
        scenes::STEPS[8],
        walks::PICTURE,
        cells::PICTURE,
        surface_area_cost::PICTURE,
        growth::PICTURE,
        building::PICTURE,
        losers::PICTURE,
    ],
};
