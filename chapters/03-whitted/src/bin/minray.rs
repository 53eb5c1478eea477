//! Prints the picture of the business card: `cargo run -p whitted --bin minray > card.ppm`.

use std::{
    io::{self, BufWriter, ErrorKind, Write},
    process::ExitCode,
};

fn main() -> ExitCode {
    if let Some(argument) = std::env::args_os().nth(1) {
        let argument = argument.display();
        eprintln!(
            "error: '{argument}' is not understood: minray takes no arguments, and prints a picture as plain PPM"
        );
        eprintln!("For other sizes: cargo run -p whitted -- minray --size 640x640");
        return ExitCode::from(2);
    }
    let mut out = BufWriter::new(io::stdout().lock());
    match whitted::minray::print(&mut out).and_then(|()| out.flush()) {
        Ok(()) => ExitCode::SUCCESS,
        // Whoever reads has seen enough.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: the picture could not be written to standard output: {error}");
            ExitCode::FAILURE
        }
    }
}
