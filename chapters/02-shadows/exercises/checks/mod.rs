//! The checks of this chapter's exercises, one file each, and what they share.
//!
//! A check is generic in the answer, so that the stub, the solution and the wrong answers of the tests go through the
//! same one. What an answer should be comes from independent formulas in f64.

#![allow(dead_code, reason = "an exercise uses its own check only")]

mod blockers;
mod lift_mistakes;
mod pane_mistakes;
mod panel;
mod panel_mistakes;
mod words;

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
