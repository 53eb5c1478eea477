//! Prints the fingerprint of every picture of the course: the same lines on every machine and in every build.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::io::Result<()> {
    use std::io::Write as _;
    std::io::stdout().write_all(course::bits::table(0).as_bytes())
}

/// A web page calls the library instead.
#[cfg(target_arch = "wasm32")]
fn main() {}
