//! Tests that look at the whole course from outside, one file for each thing looked at.

mod assets;
mod book;
mod command_line;
mod exact;
mod house;
mod icosphere;
mod implicit;
mod pictures;
mod rays;
mod shapes;
mod triangles;
