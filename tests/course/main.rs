//! Tests that look at the whole course from outside, one file for each thing looked at.

#![allow(clippy::unwrap_used, clippy::panic, reason = "in a test, helpers may fail too")]

mod agreement;
mod assets;
mod book;
mod camera;
mod command_line;
mod degenerate;
mod exact;
mod experiments;
mod fresnel;
mod going_on;
mod growth;
mod house;
mod icosphere;
mod illumination;
mod implicit;
mod meshes;
mod mirrors;
mod normals;
mod numbers;
mod occlusion;
mod offsets;
mod optics;
mod pictures;
mod rays;
mod recursion;
mod refraction;
mod reports;
mod said_commands;
mod shadows;
mod shapes;
mod slope;
mod soups;
mod stories;
mod subjects;
mod terms;
mod trees;
mod triangles;
