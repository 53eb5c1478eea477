//! The checks of this chapter's exercises, one file each, and what they share.
//!
//! A check takes what the student has written as a struct of functions, so that the stub, the solution and the wrong
//! answers of the tests go through the same one. What an answer should be comes from independent formulas in f64. The
//! random numbers are the same in every run, so a verdict is too.

#![allow(dead_code, reason = "an exercise uses its own check only")]

mod density_mistakes;
pub(crate) mod discrepancy;
mod glossy;
mod offsets;
pub(crate) mod table;
pub(crate) mod tally;
mod triangle;
mod view;
mod words;

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
