//! Tests that look at the whole course from outside, one file for each thing looked at.

mod assets;
mod command_line;
mod exact;
mod implicit;
mod pictures;
mod rays;
mod shapes;
