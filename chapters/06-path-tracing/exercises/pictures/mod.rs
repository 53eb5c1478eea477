//! The pictures that the exercises of this chapter show once an answer is accepted, made with what the student
//! has written.

#![allow(dead_code, reason = "an exercise uses its own picture only")]

#[path = "2-area-light.rs"]
pub(crate) mod area_light;
#[path = "4-asked-or-found.rs"]
pub(crate) mod asked_or_found;
#[path = "3-depth-of-field.rs"]
pub(crate) mod depth_of_field;
#[path = "1-glass.rs"]
pub(crate) mod glass;
#[path = "5-stratified-paths.rs"]
pub(crate) mod stratified_paths;

use common::{
    Error,
    film::Size,
    picture::{Chapter, ORBIT, Picture, Render, Settings},
};

/// Makes a picture of what a user has chosen.
type Make = fn(&Settings) -> Result<Box<dyn Render>, Error>;

/// The chapter as far as its exercises go: files are written to `pictures/exercises`.
pub(crate) fn chapter(pictures: &'static [Picture]) -> Chapter {
    Chapter { name: "exercises", pictures, ..path_tracing::CHAPTER }
}

/// A picture whose camera can be moved.
const fn picture(name: &'static str, alt: &'static str, make: Make) -> Picture {
    Picture { name, alt, knobs: &ORBIT, size: Size::of::<960, 540>(), samples: 32, takes_mesh: false, make }
}
