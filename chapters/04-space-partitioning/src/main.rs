//! Renders the pictures of chapter 4.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::cli::run(&space_partitioning::CHAPTER)
}
