//! The checks of this chapter's exercises, one file each, and what they share.
//!
//! A check takes what the student has written as a struct of functions, so that the stub, the solution and the wrong
//! answers of the tests go through the same one. The random numbers are the same in every run, so a verdict is too.

#![allow(dead_code, reason = "an exercise uses its own check only")]

mod even_counts;
mod fixed_paths;
mod garden;
mod lens;
mod lens_mistakes;
mod lens_rays;
mod lens_spread;
mod orders;
mod path_mistakes;
pub(crate) mod pixel_means;
mod point_sets;
mod set_mistakes;

#[path = "3-depth-of-field.rs"]
pub(crate) mod depth_of_field;
#[path = "5-stratified-paths.rs"]
pub(crate) mod stratified_paths;
