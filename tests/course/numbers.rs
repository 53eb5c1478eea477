//! The numbers in the book's text, each measured here and pinned in `tests/numbers`.
//!
//! `UPDATE_NUMBERS=1 cargo test -p tests numbers` writes them anew.

mod path_tracing;
mod ray_casting;
mod sampling;
mod shadows;
mod space_partitioning;
mod whitted;

use std::{fmt::Write as _, fs, path::Path};

/// The text of a file of numbers.
struct Numbers(String);

impl Numbers {
    /// Numbers under a line that says which they are.
    fn titled(title: &str) -> Self {
        Self(format!("# {title}\n"))
    }

    /// Say what the next numbers are.
    fn about(&mut self, what: &str) {
        writeln!(self.0, "\n# {what}").unwrap();
    }

    fn pin(&mut self, name: &str, value: impl ToString) {
        writeln!(self.0, "{name} = {}", value.to_string()).unwrap();
    }
}

/// A share in per cent with one decimal.
fn percent(part: u32, whole: u32) -> String {
    format!("{:.1} %", 100.0 * f64::from(part) / f64::from(whole))
}

/// A whole number with its digits in groups of three, as the book writes it.
fn grouped(n: u32) -> String {
    if n < 10_000 {
        return n.to_string();
    }
    let [millions, thousands, ones] = [n / 1_000_000, n / 1_000 % 1_000, n % 1_000];
    if millions == 0 { format!("{thousands},{ones:03}") } else { format!("{millions},{thousands:03},{ones:03}") }
}

/// Two digits that count.
#[expect(clippy::disallowed_methods, reason = "f64 has digits to spare: its last bits do not matter here")]
fn figures(x: f64) -> String {
    let magnitude = x.abs().log10().floor() as i32 - 1;
    let unit = 10_f64.powi(magnitude);
    let decimals = usize::try_from(-magnitude).unwrap_or(0);
    format!("{:.decimals$}", if magnitude > 0 { (x / unit).round() * unit } else { x })
}

/// With the minus sign of the book.
fn signed(x: f64) -> String {
    format!("{x:.2}").replace('-', "−")
}

#[test]
fn numbers_are_pinned() {
    let chapters = [
        ("ray-casting", ray_casting::measured()),
        ("shadows", shadows::measured()),
        ("whitted", whitted::measured()),
        ("space-partitioning", space_partitioning::measured()),
        ("sampling", sampling::measured()),
        ("path-tracing", path_tracing::measured()),
    ];
    for (chapter, measured) in chapters {
        let file = format!("numbers/{chapter}.txt");
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(&file);
        if std::env::var_os("UPDATE_NUMBERS").is_some() {
            fs::write(&path, &measured).unwrap();
        }
        let pinned = fs::read_to_string(&path).unwrap_or_default();
        let changed: Vec<_> = measured.lines().filter(|line| !pinned.lines().any(|other| other == *line)).collect();
        assert!(
            measured == pinned,
            "tests/{file} is not what is measured now: {changed:#?}\nUPDATE_NUMBERS=1 writes it"
        );
    }
}
