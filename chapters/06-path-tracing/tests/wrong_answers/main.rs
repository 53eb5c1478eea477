//! Typical wrong answers to the exercises, put through the same checks as the students' answers: each must be caught, and
//! the mistake must be called by its name.

#[path = "../../exercises/checks/mod.rs"]
mod checks;

mod area_light;
mod asked_or_found;
mod depth_of_field;
mod glass;
mod lamp_paths;
mod path_points;
mod stratified_paths;

use common::exercise::Verdict;

/// The name of the mistake that a check has found.
fn name(verdict: Verdict) -> &'static str {
    verdict.expect_err("a wrong answer was accepted").name
}
