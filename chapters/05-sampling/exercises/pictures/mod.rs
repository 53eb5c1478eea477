//! The pictures of this chapter's exercises, one file each, and what they share. Every one is made with what the student
//! has written.

#![allow(dead_code, reason = "an exercise uses its own picture only")]

mod evening;

#[path = "3-halton-points.rs"]
pub(crate) mod halton_points;
#[path = "4-phong-lobe.rs"]
pub(crate) mod phong_lobe;
#[path = "5-picture-as-density.rs"]
pub(crate) mod picture_as_density;
#[path = "1-stratified-samples.rs"]
pub(crate) mod stratified_samples;
#[path = "2-triangle-points.rs"]
pub(crate) mod triangle_points;

use common::{
    Error,
    film::Size,
    picture::{Chapter, Picture, Render, Settings},
};

/// Makes a picture of what a user has chosen.
type Make = fn(&Settings) -> Result<Box<dyn Render>, Error>;

/// The chapter as far as its exercises go: files are written to `pictures/exercises`.
pub(crate) fn chapter(pictures: &'static [Picture]) -> Chapter {
    Chapter { name: "exercises", pictures, ..sampling::CHAPTER }
}

/// A picture without knobs.
const fn picture(name: &'static str, alt: &'static str, make: Make) -> Picture {
    Picture { name, alt, knobs: &[], size: Size::of::<960, 540>(), samples: 1, takes_mesh: false, make }
}
