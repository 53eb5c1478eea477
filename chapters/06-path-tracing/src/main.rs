//! Renders the pictures of chapter 6.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::cli::run(&path_tracing::CHAPTER)
}
