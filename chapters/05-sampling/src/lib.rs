//! Chapter 5, sampling: integrals by chance, and directions with a density.
//!
//! Each idea of the chapter has a file of its own, named after it.

pub mod cosine_hemisphere;
pub mod direction_sample;
pub mod direction_sampling;
pub mod disc;
pub mod estimate;
pub mod integrals;
pub mod mirror;
#[cfg(test)]
mod proof;
pub mod slope;
pub mod uniform_hemisphere;
pub mod uniform_sphere;
pub mod unit_square;

/// Chapter 5.
pub const CHAPTER: common::picture::Chapter = common::picture::Chapter {
    number: 5,
    name: "sampling",
    title: "Monte Carlo sampling",
    pictures: &[],
    reports: &[],
};
