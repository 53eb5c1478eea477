//! Chapter 6, path tracing: all light, by paths that chance chooses.
//!
//! Each idea of the chapter has a file of its own, named after it. The pictures are in [`pictures`].

pub mod direct_light;
pub mod experiments;
pub mod importance;
pub mod material;
pub mod method;
pub mod path_tracer;
pub mod pictures;
pub mod probe;
#[cfg(test)]
mod proof;
pub mod random_walk;
pub mod roulette;
pub mod world;

pub use pictures::CHAPTER;
