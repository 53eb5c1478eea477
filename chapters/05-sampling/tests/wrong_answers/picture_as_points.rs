//! Wrong points and densities of tables that are right.

use crate::{
    checks::{
        picture_as_density::{Answer, check},
        table::{Table, sample_of},
    },
    name,
    picture_as_density::{RIGHT, invert, sides, table_pdf},
};

/// The diagnosis of such samples.
fn samples(sample_table: fn(&Table, [f64; 2]) -> ([f64; 2], f64)) -> &'static str {
    name(check(Answer { sample_table, ..RIGHT }))
}

/// The diagnosis of such a density.
fn pdfs(table_pdf: fn(&Table, [f64; 2]) -> f64) -> &'static str {
    name(check(Answer { table_pdf, ..RIGHT }))
}

#[test]
fn wrong_points() {
    assert_eq!(samples(|table, [x, y]| sample_of(table, [y, x])), "numbers-swapped");
    assert_eq!(
        samples(|table, u| {
            let ([x, y], pdf) = sample_of(table, u);
            ([y, x], pdf)
        }),
        "axes-swapped"
    );
    assert_eq!(
        samples(|table, u| {
            let (([x, y], pdf), [columns, rows]) = (sample_of(table, u), sides(table));
            ([x * columns, y * rows], pdf)
        }),
        "not-in-the-square"
    );
    assert_eq!(
        samples(|table, u| {
            let [(column, along), (row, up)] = [invert(&table.columns[0], u[0]), invert(&table.rows, u[1])];
            let [columns, rows] = sides(table);
            ([(column as f64 + along) / columns, (row as f64 + up) / rows], 1.0)
        }),
        "first-row-only"
    );
    assert_eq!(
        samples(|table, u| {
            let [columns, rows] = sides(table);
            let (column, along) = invert(&table.columns[(u[1] * rows) as usize], u[0]);
            ([(column as f64 + along) / columns, u[1]], 1.0)
        }),
        "rows-equally-likely"
    );
    assert_eq!(
        samples(|table, u| {
            let (([x, y], pdf), [columns, rows]) = (sample_of(table, u), sides(table));
            ([((x * columns).floor() + 0.5) / columns, ((y * rows).floor() + 0.5) / rows], pdf)
        }),
        "place-within-the-cell"
    );
    assert_eq!(samples(|_, u| (u, 1.0)), "wrong-point");
    assert_eq!(samples(|_, _| ([f64::NAN; 2], 1.0)), "wrong-point");
}

#[test]
fn wrong_densities() {
    let share = |table: &Table, u| {
        let ((point, pdf), [columns, rows]) = (sample_of(table, u), sides(table));
        (point, pdf / columns / rows)
    };
    assert_eq!(samples(share), "share-not-density");
    assert_eq!(
        samples(|table, u| {
            let ((point, pdf), [_, rows]) = (sample_of(table, u), sides(table));
            let (row, _) = invert(&table.rows, u[1]);
            let before = if row == 0 { 0.0 } else { table.rows[row - 1] };
            (point, pdf / rows / (table.rows[row] - before))
        }),
        "row-forgotten"
    );
    assert_eq!(samples(|table, u| (sample_of(table, u).0, 1.0)), "wrong-density");
    assert_eq!(
        pdfs(|table, point| {
            let [columns, rows] = sides(table);
            table_pdf(table, point) / columns / rows
        }),
        "pdf-is-a-share"
    );
    assert_eq!(pdfs(|table, [x, y]| table_pdf(table, [1.0 - x, y])), "wrong-pdf");
    assert_eq!(pdfs(|_, _| 1.0), "wrong-pdf");
    assert_eq!(pdfs(|_, _| f64::NAN), "wrong-pdf");
}
