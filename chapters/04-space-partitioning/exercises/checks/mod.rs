//! The checks of this chapter's exercises, one file each, and what they share.
//!
//! A check is generic in the answer, so that the stub, the solution and the wrong answers of the tests go through the
//! same one.

#![allow(dead_code, reason = "an exercise uses its own check only")]

pub(crate) mod blocks;
pub(crate) mod hierarchy;
mod hierarchy_shape;
pub(crate) mod logged;
pub(crate) mod meshes;
pub(crate) mod plane_tree;
pub(crate) mod walks;
mod words;

#[path = "1-bounding-sphere.rs"]
pub(crate) mod bounding_sphere;
#[path = "6-bounding-volume-hierarchy.rs"]
pub(crate) mod bounding_volume_hierarchy;
#[path = "2-mailboxing.rs"]
pub(crate) mod mailboxing;
#[path = "3-median-or-cost.rs"]
pub(crate) mod median_or_cost;
#[path = "4-ordered-shadow-walk.rs"]
pub(crate) mod ordered_shadow_walk;
#[path = "5-two-level-grid.rs"]
pub(crate) mod two_level_grid;
