//! The table of `tests/data/optics.txt`: Fresnel's equations and Snell's law by an independent computation.

use std::{fs, path::Path};

use crate::exact::V;

/// A row: its numbers, after the words that name it.
pub(crate) struct Row {
    /// The material, or nothing.
    pub(crate) name: String,
    pub(crate) numbers: Vec<f64>,
}

impl Row {
    /// Numbers `i` to `i + 2` as a vector; `None` if they are not there.
    pub(crate) fn vector(&self, i: usize) -> Option<V> {
        Some(V(self.numbers.get(i..i + 3)?.try_into().ok()?))
    }
}

/// The rows of a part of the table, which must be so many.
pub(crate) fn rows(part: &str, count: usize) -> Vec<Row> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/optics.txt");
    let text = fs::read_to_string(path).unwrap();
    let lines = text.lines().skip_while(|line| !line.starts_with(&format!("[{part}]"))).skip(1);
    let rows: Vec<_> = lines.take_while(|line| !line.is_empty()).map(row).collect();
    assert_eq!(rows.len(), count, "rows of {part}");
    rows
}

fn row(line: &str) -> Row {
    let words = || line.split_whitespace();
    let name = words().next().filter(|word| word.parse::<f64>().is_err()).unwrap_or_default().into();
    Row { name, numbers: words().filter_map(|word| word.parse().ok()).collect() }
}
