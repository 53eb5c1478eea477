//! The pictures of this chapter's exercises, one file each, and what they share. Every one is made with what the student
//! has written.

#![allow(dead_code, reason = "an exercise uses its own picture only")]

mod stage;

#[path = "2-cylinder.rs"]
pub(crate) mod cylinder;
#[path = "3-orthographic-camera.rs"]
pub(crate) mod orthographic_camera;
#[path = "1-plane.rs"]
pub(crate) mod plane;
#[path = "4-spot-light.rs"]
pub(crate) mod spot_light;
#[path = "6-torus.rs"]
pub(crate) mod torus;
#[path = "5-triangle.rs"]
pub(crate) mod triangle;

use common::picture::{Chapter, Picture};

/// The chapter as far as its exercises go: files are written to `pictures/exercises`.
pub(crate) fn chapter(pictures: &'static [Picture]) -> Chapter {
    Chapter { name: "exercises", pictures, ..ray_casting::CHAPTER }
}
