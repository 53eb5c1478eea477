//! Chapter 2, shadows: is there anything between a point and the light?
//!
//! Each idea of the chapter has a file of its own, named after it. The pictures are in [`pictures`].

pub mod direct_light;
pub mod offset;
pub mod pictures;
pub mod shadow_ray;

pub use pictures::CHAPTER;
