//! The order of growth: brute force in proportion to the number of triangles, the kd-tree hardly at all.
//!
//! Up to ten million triangles the counts come from a file, which `cargo run --release -p space-partitioning
//! --no-default-features --example space-partitioning-measure` prints. Its smaller half is counted again here.

use std::sync::Arc;

use space_partitioning::{
    choice::Choice,
    growth::{MOST_BY_FORCE, Row, SIZES, Subject},
    measured,
};

use crate::slope::slope;

/// Scenes up to this size are counted again.
const COUNTED: u32 = 31_600;
/// Up to this size by brute force too.
const COUNTED_BY_FORCE: u32 = 3_160;

/// Tests per ray over the number of triangles.
fn tests(rows: impl IntoIterator<Item = Row>) -> Vec<(f64, f64)> {
    rows.into_iter().map(|row| (row.triangles as f64, row.counts.tests as f64 / row.rays as f64)).collect()
}

/// What the file says of a structure.
fn measured_rows(choice: Choice) -> impl Iterator<Item = Row> {
    measured::growth().into_iter().map(|measured| measured.row).filter(move |row| row.choice == choice)
}

#[test]
fn the_file_says_what_is_counted() {
    let [all, by_force] = [COUNTED, COUNTED_BY_FORCE].map(|most| SIZES.iter().filter(|&&size| size <= most).count());
    let rows = common::parallel::map(all, |i| {
        let subject = Subject::new(SIZES[i]).unwrap();
        let choices = Choice::STRUCTURES.into_iter().chain((i < by_force).then_some(Choice::BruteForce));
        choices.map(|choice| subject.row(choice, choice.over(Arc::clone(&subject.mesh)).unwrap().as_ref())).collect()
    });
    let rows: Vec<Vec<Row>> = rows;
    for row in rows.into_iter().flatten() {
        let found = measured_rows(row.choice).find(|measured| measured.triangles == row.triangles);
        assert_eq!(found, Some(row), "the file growth.csv is out of date");
    }
}

#[test]
fn brute_force_grows_in_proportion_and_the_kd_tree_hardly() {
    let brute_force = tests(measured_rows(Choice::BruteForce));
    assert_eq!(brute_force.len(), SIZES.iter().filter(|&&size| size <= MOST_BY_FORCE).count());
    assert!((slope(&brute_force) - 1.0).abs() < 1e-6, "{}", slope(&brute_force));
    let large = tests(measured_rows(Choice::KdTree).filter(|row| row.triangles >= 9_900));
    assert_eq!(large.len(), SIZES.iter().filter(|&&size| size >= 10_000).count());
    assert!(large.last().unwrap().0 > 9e6, "{large:?}");
    assert!(slope(&large) < 0.1, "{} of {large:?}", slope(&large));
}
