//! The pictures of this chapter.

mod corridor;
mod depths;
mod disc;
mod evening;
pub mod glass;
mod glass_ball;
mod metals;
mod minray;
mod paper;
mod ray_tree;
mod reflectance;
mod studio;
mod terms;
pub mod treasure;

use common::picture::Chapter;

/// Chapter 3 with all its pictures.
pub const CHAPTER: Chapter = Chapter {
    number: 3,
    name: "whitted",
    title: "Recursive ray tracing",
    pictures: &[
        treasure::PICTURE,
        depths::PICTURE,
        corridor::PICTURE,
        metals::PICTURE,
        reflectance::PICTURE,
        glass::PICTURE,
        glass_ball::PICTURE,
        terms::PICTURE,
        ray_tree::PICTURE,
        minray::PICTURE,
    ],
    reports: &[],
};
