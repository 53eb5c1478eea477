//! Renders the pictures of chapter 2.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::cli::run(&shadows::CHAPTER)
}
