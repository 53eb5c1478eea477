//! Renders the pictures of chapter 1.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::cli::run(&ray_casting::CHAPTER)
}
