//! The pictures of this chapter's exercises, one file each, and what they share. Every one is made with what the student
//! has written.

#![allow(dead_code, reason = "an exercise uses its own picture only")]

mod steps;

#[path = "1-bounding-sphere.rs"]
pub(crate) mod bounding_sphere;
#[path = "6-bounding-volume-hierarchy.rs"]
pub(crate) mod bounding_volume_hierarchy;
#[path = "2-mailboxing.rs"]
pub(crate) mod mailboxing;
#[path = "3-median-or-cost.rs"]
pub(crate) mod median_or_cost;
#[path = "4-ordered-shadow-walk.rs"]
pub(crate) mod ordered_shadow_walk;
#[path = "5-two-level-grid.rs"]
pub(crate) mod two_level_grid;

use common::{
    Error,
    film::Size,
    picture::{Chapter, ORBIT, Picture, Render, Settings},
};

/// Makes a picture of what a user has chosen.
type Make = fn(&Settings) -> Result<Box<dyn Render>, Error>;

/// The chapter as far as its exercises go: files are written to `pictures/exercises`.
pub(crate) fn chapter(pictures: &'static [Picture]) -> Chapter {
    Chapter { name: "exercises", pictures, ..space_partitioning::CHAPTER }
}

/// A picture with a camera that can be moved.
const fn picture(name: &'static str, alt: &'static str, make: Make) -> Picture {
    Picture { name, alt, knobs: &ORBIT, size: Size::of::<960, 540>(), samples: 4, takes_mesh: false, make }
}
