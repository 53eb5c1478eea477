//! Renders the pictures of chapter 3.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::cli::run(&whitted::CHAPTER)
}
