//! Chapter 3, recursive ray tracing: mirrors and glass.
//!
//! Each idea of the chapter has a file of its own, named after it. The pictures are in [`pictures`].

pub mod branches;
pub mod fresnel;
pub mod material;
pub mod minray;
pub mod pictures;
pub mod probe;
pub mod reflection;
pub mod refraction;
pub mod whitted;

pub use pictures::CHAPTER;
