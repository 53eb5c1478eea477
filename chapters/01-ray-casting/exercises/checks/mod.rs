//! The checks of this chapter's exercises, one file each, and what they share.
//!
//! A check is generic in the answer, so that the stub, the solution and the wrong answers of the tests go through the
//! same one. What an answer should be comes from independent formulas in f64.

#![allow(dead_code, reason = "an exercise uses its own check only")]

mod crossing;
mod dice;
mod judge;
mod words;

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
