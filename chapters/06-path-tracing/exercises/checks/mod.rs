//! The checks of this chapter's exercises, one file each, and what they share.
//!
//! A check takes what the student has written as functions, so that the stub, the solution and the wrong answers of the
//! tests go through the same one. What an answer should be comes from closed forms in f64, or from paths that find all
//! light by chance. The random numbers are the same in every run, so a verdict is too.

#![allow(dead_code, reason = "an exercise uses its own check only")]

pub(crate) mod effort;
mod even_counts;
mod fixed_paths;
mod garden;
pub(crate) mod glass_case;
mod glass_furnace;
mod glass_mistakes;
pub(crate) mod glass_world;
pub(crate) mod lamp;
pub(crate) mod lamp_exact;
mod lamp_light;
mod lamp_paths;
mod lamp_points;
mod lamp_rooms;
mod lamp_scenes;
pub(crate) mod lamp_world;
mod lens;
mod lens_mistakes;
mod lens_rays;
mod lens_spread;
mod orders;
mod path_mistakes;
pub(crate) mod pixel_means;
pub(crate) mod place;
mod place_densities;
mod place_pairs;
mod place_samples;
mod places;
mod point_sets;
pub(crate) mod quad;
mod set_mistakes;
mod words;

#[path = "2-area-light.rs"]
pub(crate) mod area_light;
#[path = "4-asked-or-found.rs"]
pub(crate) mod asked_or_found;
#[path = "3-depth-of-field.rs"]
pub(crate) mod depth_of_field;
#[path = "1-glass.rs"]
pub(crate) mod glass;
#[path = "5-stratified-paths.rs"]
pub(crate) mod stratified_paths;
