//! The pictures of this chapter's exercises, one file each, and what they share. Every one is made with what the student
//! has written.

#![allow(dead_code, reason = "an exercise uses its own picture only")]

#[path = "2-ambient-occlusion.rs"]
pub(crate) mod ambient_occlusion;
#[path = "1-any-hit.rs"]
pub(crate) mod any_hit;
#[path = "5-lifted-point.rs"]
pub(crate) mod lifted_point;
#[path = "3-soft-shadows.rs"]
pub(crate) mod soft_shadows;
#[path = "4-stained-glass.rs"]
pub(crate) mod stained_glass;

use common::{
    Error,
    film::Size,
    picture::{Chapter, ORBIT, Picture, Render, Settings},
};

/// Makes a picture of what a user has chosen.
type Make = fn(&Settings) -> Result<Box<dyn Render>, Error>;

/// The chapter as far as its exercises go: files are written to `pictures/exercises`.
pub(crate) fn chapter(pictures: &'static [Picture]) -> Chapter {
    Chapter { name: "exercises", pictures, ..shadows::CHAPTER }
}

/// A picture with a camera that can be moved.
const fn picture(name: &'static str, alt: &'static str, make: Make) -> Picture {
    Picture { name, alt, knobs: &ORBIT, size: Size::of::<960, 540>(), samples: 16, takes_mesh: false, make }
}
