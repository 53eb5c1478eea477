//! Tests that look at the whole course from outside, one file for each thing looked at.

mod assets;
mod pictures;
