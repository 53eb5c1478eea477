//! Renders the pictures of chapter 5.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::cli::run(&sampling::CHAPTER)
}
