//! Scenes of many triangles, made by rule and chance: with the character and the size of the scenes that the field
//! measures on, and of any other size.

pub mod arches;
pub mod backdrop;
pub mod ball;
pub mod budget;
pub mod builder;
pub mod chance;
pub mod clearing;
pub mod court;
pub mod cuboid;
pub mod cushion;
pub mod foliage;
pub mod fountain;
pub mod furniture;
pub mod hair_ball;
pub mod interior;
pub mod lathe;
pub mod mountain;
pub mod noise;
pub mod plant;
pub mod prism;
pub mod sphere_flake;
pub mod spline;
pub mod square;
pub mod stadium;
pub mod surface;
#[cfg(test)]
mod tests;
pub mod tube;

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
    interior::GENERATOR,
    court::GENERATOR,
    clearing::GENERATOR,
    hair_ball::GENERATOR,
    plant::GENERATOR,
    square::GENERATOR,
    sphere_flake::GENERATOR,
    mountain::GENERATOR,
    stadium::GENERATOR,
];

/// Their names, in the same order.
pub const NAMES: [&str; GENERATORS.len()] = {
    let mut names = [""; GENERATORS.len()];
    let mut i = 0;
    while i < names.len() {
        names[i] = GENERATORS[i].name;
        i += 1;
    }
    names
};
