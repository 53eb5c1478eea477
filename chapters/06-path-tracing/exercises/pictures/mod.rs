//! The pictures of this chapter's exercises, one file each, and what they share. Every one is made with what the student
//! has written.

#![allow(dead_code, reason = "an exercise uses its own picture only")]

#[path = "3-depth-of-field.rs"]
pub(crate) mod depth_of_field;
#[path = "5-stratified-paths.rs"]
pub(crate) mod stratified_paths;

use common::picture::{Chapter, Picture};

/// The chapter as far as its exercises go: files are written to `pictures/exercises`.
pub(crate) fn chapter(pictures: &'static [Picture]) -> Chapter {
    Chapter { name: "exercises", pictures, ..path_tracing::CHAPTER }
}
