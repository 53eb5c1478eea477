//! Chapter 5, sampling: integrals by chance, and directions with a density.
//!
//! Each idea of the chapter has a file of its own, named after it. What is measured of them is in [`experiments`].

pub mod chart;
pub mod chi_square;
pub mod cosine_hemisphere;
pub mod direction_sample;
pub mod direction_sampling;
pub mod disc;
pub mod estimate;
pub mod experiments;
pub mod integrals;
pub mod mirror;
pub mod pictures;
#[cfg(feature = "cli")]
pub mod plot;
#[cfg(test)]
mod proof;
pub mod reports;
pub mod sky_light;
pub mod slope;
pub mod uniform_hemisphere;
pub mod uniform_sphere;
pub mod unit_square;

pub use pictures::CHAPTER;
