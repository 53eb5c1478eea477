//! The pictures of this chapter's exercises, one file each, and what they share. Every one is made with what the student
//! has written.

#![allow(dead_code, reason = "an exercise uses its own picture only")]

mod studio;

#[path = "2-absorption.rs"]
pub(crate) mod absorption;
#[path = "4-budget.rs"]
pub(crate) mod budget;
#[path = "1-checkerboard.rs"]
pub(crate) mod checkerboard;
#[path = "3-dispersion.rs"]
pub(crate) mod dispersion;
#[path = "5-soap-film.rs"]
pub(crate) mod soap_film;

use common::picture::{Chapter, Picture};

/// The chapter as far as its exercises go: files are written to `pictures/exercises`.
pub(crate) fn chapter(pictures: &'static [Picture]) -> Chapter {
    Chapter { name: "exercises", pictures, ..whitted::CHAPTER }
}
