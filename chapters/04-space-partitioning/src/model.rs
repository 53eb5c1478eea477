//! The model: a scene made of triangles alone, however many, and the way to look at it.

use common::{Rgb, Vec3, obj::ObjMesh};
use ray_casting::{light::Light, material::Phong, mesh::Shading};

/// All that is needed to show a scene of many triangles.
pub struct Model {
    /// The triangles of all parts, one part after the other.
    pub mesh: ObjMesh,
    /// How the triangles are shaded.
    pub shading: Shading,
    /// What the triangles are made of: never empty, and the first part starts at triangle 0.
    pub parts: Vec<Part>,
    /// Who looks.
    pub view: View,
    /// The abstract lights.
    pub lights: Vec<Box<dyn Light>>,
    /// `L_a`: the light that is taken to come from everywhere.
    pub ambient: Rgb,
    /// What a ray sees that hits nothing.
    pub background: Rgb,
}

/// Triangles of one material that follow each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// What to call it in a pixel's story.
    pub name: &'static str,
    /// Index of its first triangle. It reaches up to the first of the next part.
    pub first: u32,
    /// What it is made of.
    pub material: Phong,
}

/// Where the eye is when nothing is said.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Position of the eye, in scene units.
    pub eye: Vec3,
    /// The point in the middle of the picture.
    pub lookat: Vec3,
    /// Full angle across the shorter side of the picture, in degrees.
    pub field_of_view: f32,
}
