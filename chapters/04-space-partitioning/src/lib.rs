//! Chapter 4, space partitioning: scenes of many objects.
//!
//! Each idea of the chapter has a file of its own, named after it. The pictures are in [`pictures`].

pub mod bounding_volume;
pub mod choice;
pub mod clip;
pub mod comparison;
pub mod eight_at_once;
pub mod every_one;
pub mod grid;
pub mod growth;
pub mod kd_tree;
pub mod lit_model;
pub mod measured;
pub mod model;
pub mod octree;
pub mod pictures;
pub mod primitives;
pub mod probe;
pub mod query;
pub mod reports;
pub mod rounding;
pub mod scenes;
pub mod slabs;
pub mod structure;
mod subtree;
pub mod triangles;
mod validate;
pub mod viewed_mesh;
pub mod workload;

pub use pictures::CHAPTER;
