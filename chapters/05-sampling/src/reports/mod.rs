//! The reports of this chapter: what it tells in words and numbers.

mod experiment;

use common::report::Report;

/// All of them.
pub const REPORTS: &[Report] = &[experiment::REPORT];
