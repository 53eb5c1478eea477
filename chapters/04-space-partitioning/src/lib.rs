//! Chapter 4, space partitioning: scenes of many objects.
//!
//! Each idea of the chapter has a file of its own, named after it. The pictures are in [`pictures`].

pub mod model;
pub mod pictures;
pub mod scenes;

pub use pictures::CHAPTER;
