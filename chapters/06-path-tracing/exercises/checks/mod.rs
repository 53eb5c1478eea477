//! The checks of this chapter's exercises, one file each, and what they share.
//!
//! A check takes what the student has written as a struct of functions, so that the stub, the solution and the wrong
//! answers of the tests go through the same one. The random numbers are the same in every run, so a verdict is too.

#![allow(dead_code, reason = "an exercise uses its own check only")]

mod even_counts;
mod lens;
mod lens_mistakes;
mod lens_rays;
mod lens_spread;

#[path = "3-depth-of-field.rs"]
pub(crate) mod depth_of_field;
