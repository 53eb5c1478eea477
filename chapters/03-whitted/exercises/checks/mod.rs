//! The checks of this chapter's exercises, one file each, and what they share.
//!
//! A check takes what the student has written as a struct of functions, so that the stub, the solution and the wrong
//! answers of the tests go through the same one. What an answer should be comes from independent formulas in f64.

#![allow(dead_code, reason = "an exercise uses its own check only")]

mod budget_mistakes;
mod cauchy;
mod film;
mod film_mistakes;
mod prism;
mod tree;
mod words;

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
pub(crate) mod tracer;
pub(crate) mod world;
