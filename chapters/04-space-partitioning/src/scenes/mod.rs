//! Scenes of many triangles, made by rule and chance: with the character and the size of the scenes that the field
//! measures on, and of any other size.

pub mod builder;
pub mod clearing;
pub mod hair_ball;
pub mod mountain;
mod noise;
pub mod plant;
mod shape;
pub mod sphere_flake;
pub mod stadium;
#[cfg(test)]
mod tests;

use crate::model::Model;

/// A family of scenes of any size.
#[derive(Clone, Copy, Debug)]
pub struct Generator {
    /// Name on the command line.
    pub name: &'static str,
    /// Number of triangles of the field's scene whose character and size it has.
    pub full_size: u32,
    /// Makes the scene with about so many triangles.
    pub make: fn(triangles: u32) -> Model,
}

/// All of them.
pub const GENERATORS: &[Generator] = &[
    clearing::GENERATOR,
    hair_ball::GENERATOR,
    mountain::GENERATOR,
    plant::GENERATOR,
    sphere_flake::GENERATOR,
    stadium::GENERATOR,
];
