//! What is measured in this chapter: each experiment as numbers, as a table for people, and as a chart.

pub mod constant_sky;
pub mod dimension;
pub mod mean_cosine;
pub mod outside_three_sigma;

use crate::chart::Chart;

/// What an experiment found.
#[derive(Clone, Debug, PartialEq)]
pub struct Findings {
    /// A table for people, in lines of at most 100 characters.
    pub text: String,
    /// The same in more detail.
    pub chart: Chart,
}
