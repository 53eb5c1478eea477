//! Chapter 1, ray casting: what does a ray hit, and how bright is it?
//!
//! Each idea of the chapter has a file of its own, named after it. The pictures are in [`pictures`].

pub mod aabb;
pub mod background;
pub mod camera;
pub mod frame;
pub mod hit;
pub mod implicit;
pub mod light;
pub mod local_illumination;
pub mod material;
pub mod mesh;
pub mod pictures;
pub mod quadratic;
pub mod quadric;
pub mod ray;
pub mod rendering_loop;
pub mod scene;
pub mod shape;
pub mod sphere;
pub mod triangle;
pub mod triangle_barycentric;
pub mod triangle_edges;

pub use pictures::CHAPTER;
