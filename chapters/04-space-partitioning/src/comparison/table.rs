//! The comparison as a table for people.

use std::fmt;

use super::{Comparison, Cost, Row};
use crate::{choice::Choice, workload::RayKind};

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.head(f)?;
        for row in &self.rows {
            self.row(f, row)?;
        }
        writeln!(f)?;
        if self.rows.iter().all(|row| row.choice != Choice::BruteForce) {
            writeln!(f, "Brute force would take too long here; it joins in where triangles or rays are few.")?;
        }
        let threads = match common::parallel::threads() {
            1 => "one thread".into(),
            n => format!("{n} threads"),
        };
        match self.agrees() {
            true => writeln!(f, "All structures found the same hits.")?,
            false => writeln!(f, "WARNING: the structures found different hits. One of them is wrong.")?,
        }
        writeln!(f, "Cells and tests are means over all rays of a kind: exact, and the same on every machine.")?;
        writeln!(f, "Times are this machine's, on {threads}: compare lines of one table only.")
    }
}

impl Comparison {
    fn head(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:14}{:>8}{:>9}", "", "build", "memory")?;
        for (kind, rays) in RayKind::ALL.iter().zip(self.rays) {
            write!(f, "{:>23}", format!("{rays} {}", kind.name()))?;
        }
        write!(f, "\n{:14}{:>8}{:>9}", "structure", "s", "B/tri.")?;
        for _ in RayKind::ALL {
            write!(f, "{:>8}{:>7}{:>8}", "cells", "tests", "Mrays/s")?;
        }
        writeln!(f)
    }

    fn row(&self, f: &mut fmt::Formatter<'_>, row: &Row) -> fmt::Result {
        let Row { choice, build, bytes, costs } = row;
        let per_triangle = ratio(*bytes as f64, self.triangles);
        write!(f, "{:14}{:>8}{:>9}", choice.name(), digits(Some(build.as_secs_f64())), digits(per_triangle))?;
        for (Cost { counts, time, .. }, rays) in costs.iter().zip(self.rays) {
            let [cells, tests] = [counts.cells, counts.tests].map(|steps| digits(ratio(steps as f64, rays)));
            let speed = (rays > 0).then(|| rays as f64 / time.as_secs_f64().max(1e-9) / 1e6);
            write!(f, "{cells:>8}{tests:>7}{:>8}", digits(speed))?;
        }
        writeln!(f)
    }
}

/// A sum as a mean, if it is one of anything.
fn ratio(sum: f64, count: usize) -> Option<f64> {
    (count > 0).then(|| sum / count as f64)
}

/// A number with about three digits, in at most six characters if it is below a million.
fn digits(number: Option<f64>) -> String {
    match number {
        None => "-".into(),
        Some(x) if x >= 99.95 => format!("{x:.0}"),
        Some(x) if x >= 9.995 => format!("{x:.1}"),
        Some(x) if x >= 0.9995 => format!("{x:.2}"),
        Some(x) if x >= 0.00995 => format!("{x:.3}"),
        Some(x) => format!("{x:.4}"),
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;
    use crate::probe::Counts;

    fn row(choice: Choice, steps: u64) -> Row {
        let counts = Counts { cells: steps, tests: 2 * steps, hits: 0 };
        let cost = Cost { counts, answers: (0, 0), time: Duration::from_millis(500) };
        Row { choice, build: Duration::from_micros(12_340), bytes: 44_444, costs: [cost; 3] }
    }

    #[test]
    fn numbers_have_three_digits() {
        let numbers = [0.0, 0.001_23, 0.012_34, 0.999_9, 1.234_5, 9.996, 12.345, 99.96, 123.4, 1e5];
        let shown = ["0.0000", "0.0012", "0.012", "1.00", "1.23", "10.0", "12.3", "100", "123", "100000"];
        assert_eq!(numbers.map(|x| digits(Some(x))), shown);
        assert_eq!(digits(None), "-");
    }

    #[test]
    fn the_table_is_aligned_and_narrow() {
        let rows = vec![row(Choice::Grid, 99), row(Choice::MedianKdTree, 1_234_567)];
        let comparison = Comparison { triangles: 1_000, rays: [2_000_000, 1_999_999, 0], rows };
        let table = comparison.to_string();
        let lines: Vec<_> = table.lines().collect();
        assert!(lines.iter().all(|line| line.chars().count() <= 100), "{table}");
        // Columns end where their heads end.
        assert!(lines[..4].iter().all(|line| line.len() == lines[0].len()), "{table}");
        assert!(lines[2].starts_with("grid             0.012     44.4"), "{table}");
        assert!(lines[2].ends_with("-      -       -"), "{table}");
        assert!(table.contains("Brute force would") && !table.contains("NaN"), "{table}");
    }
}
