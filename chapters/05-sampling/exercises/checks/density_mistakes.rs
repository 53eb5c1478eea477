//! Checks points and densities of a table, for exercise 5.5.

use common::{
    Stream,
    exercise::{Finding, Verdict, expect, trying},
};

use super::{
    picture_as_density::{Answer, ROUNDING, list},
    table::{Table, before, cumulative_of, invert_of, sample_of, share_of},
    words::{about, number},
};

/// A point and its density.
type Sampled = ([f64; 2], f64);

/// Tables that are tried: how many columns, and the weights row by row.
const TABLES: [(usize, &[f64]); 5] = [
    (3, &[1.0, 2.0, 3.0, 0.0, 4.0, 2.0]),
    (1, &[2.0, 0.0, 1.0]),
    (4, &[0.0, 1.0, 0.0, 3.0]),
    (2, &[0.0, 0.0, 1.0, 5.0, 0.0, 0.0, 2.0, 2.0]),
    (3, &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
];

/// What is wrong with points and densities, if anything is.
pub(super) fn judge(answer: Answer) -> Verdict {
    let tables = TABLES.map(|(columns, weights)| Table::new(cumulative_of, columns, weights));
    let words = |i: usize| {
        let (columns, weights) = TABLES[i];
        let rows: Vec<String> = weights.chunks(columns).map(list).collect();
        format!("the table with the rows {}", rows.join(", "))
    };
    let sample = |i: usize, u: [f64; 2]| {
        let tried = || format!("`sample_table` of {} and u = {}", words(i), list(&u));
        trying(tried, || (answer.sample_table)(&tables[i], u))
    };
    let mut random = Stream::new(59, 0, 0);
    let us: Vec<[f64; 2]> = (0..300).map(|_| [(); 2].map(|()| f64::from(random.uniform()))).collect();
    let all = || (0..tables.len()).flat_map(|i| us.iter().map(move |u| (i, *u)));
    expect(all().any(|(i, u)| sample(i, u) != ([0.0; 2], 0.0)), "sample-not-started", || {
        "`invert` is right. Now for `sample_table`, which returns the point (0, 0) with density 0.".into()
    })?;
    let near = |a: f64, b: f64| (a - b).abs() <= ROUNDING * b.abs().max(1.0);
    let same = |a: [f64; 2], b: [f64; 2]| near(a[0], b[0]) && near(a[1], b[1]);
    let told = |(point, pdf): Sampled| format!("the point {} with density {}", list(&point), about(pdf));
    let wrong = |(i, u): (usize, [f64; 2]), name, advice: &str| {
        let tried = format!("`sample_table` of {} and u = {}", words(i), list(&u));
        let (got, expected) = (told(sample(i, u)), told(sample_of(&tables[i], u)));
        Err(Finding { tried, got, expected, advice: advice.into() }.named(name))
    };
    if let Some(question) = all().find(|&(i, u)| !same(sample(i, u).0, sample_of(&tables[i], u).0)) {
        let is = |rival: &dyn Fn(&Table, [f64; 2]) -> [f64; 2]| {
            all().all(|(i, u)| same(sample(i, u).0, rival(&tables[i], u)))
        };
        let right = |table: &Table, u: [f64; 2]| sample_of(table, u).0;
        let (name, advice) = if is(&|table, [x, y]| right(table, [y, x])) {
            ("numbers-swapped", "u[1] chooses the row and u[0] the column.")
        } else if is(&|table, u| {
            let [x, y] = right(table, u);
            [y, x]
        }) {
            ("axes-swapped", "x goes along a row: it comes from the column, and y from the row.")
        } else if is(&|table, u| {
            let [x, y] = right(table, u);
            [x * table.columns[0].len() as f64, y * table.rows.len() as f64]
        }) {
            (
                "not-in-the-square",
                "These are cells and parts of cells. The point lies in the unit square: divide by their number.",
            )
        } else if is(&|table, u| {
            place([invert_of(&table.columns[0], u[0]), invert_of(&table.rows, u[1])].map(along), table)
        }) {
            (
                "first-row-only",
                "The column must be chosen by the weights of the row that u[1] has found, not by those of row 0.",
            )
        } else if is(&|table, u| {
            let row = ((u[1] * table.rows.len() as f64) as usize).min(table.rows.len() - 1);
            [along(invert_of(&table.columns[row], u[0])) / table.columns[row].len() as f64, u[1]]
        }) {
            (
                "rows-equally-likely",
                "All rows are equally likely here. A row is found by `invert` of `table.rows`, like a column.",
            )
        } else if all().all(|(i, u)| cell(sample(i, u).0, &tables[i]) == cell(right(&tables[i], u), &tables[i])) {
            (
                "place-within-the-cell",
                "The cell is right, and the place within it is not: x = (column + where) / number of columns.",
            )
        } else {
            ("wrong-point", "Row: `invert(&table.rows, u[1])`. Column: `invert` of the columns of that row, and u[0].")
        };
        return wrong(question, name, advice);
    }
    if let Some(question) = all().find(|&(i, u)| !near(sample(i, u).1, sample_of(&tables[i], u).1)) {
        let cells = |table: &Table| (table.rows.len() * table.columns[0].len()) as f64;
        let is = |rival: &dyn Fn(&Table, f64) -> f64| {
            all().all(|(i, u)| near(sample(i, u).1, rival(&tables[i], sample_of(&tables[i], u).1)))
        };
        let (name, advice) = if is(&|table, pdf| pdf / cells(table)) {
            (
                "share-not-density",
                "This is the share of the cell. A density is the share over the area, and each cell has the area 1 / \
                                   number of cells.",
            )
        } else if all().all(|(i, u)| {
            let (row, _) = invert_of(&tables[i].rows, u[1]);
            let columns = &tables[i].columns[row];
            let (column, _) = invert_of(columns, u[0]);
            let alone = columns[column] - before(columns, column);
            near(sample(i, u).1, alone * columns.len() as f64) || near(sample(i, u).1, alone * cells(&tables[i]))
        }) {
            ("row-forgotten", "Only the column counts here. Multiply by the share of its row.")
        } else {
            (
                "wrong-density",
                "The share of the row, times that of the column within the row, times the number of cells.",
            )
        };
        return wrong(question, name, advice);
    }
    pdf(answer, &tables, &words)
}

/// The density by a point.
fn pdf(answer: Answer, tables: &[Table], words: &dyn Fn(usize) -> String) -> Verdict {
    let ask = |i: usize, point: [f64; 2]| {
        let tried = || format!("`table_pdf` of {} at {}", words(i), list(&point));
        trying(tried, || (answer.table_pdf)(&tables[i], point))
    };
    let sides = |i: usize| [tables[i].columns[0].len(), tables[i].rows.len()];
    // Four points of each cell, one of them its corner, and the far corner of the square.
    let points = |i: usize| {
        let [columns, rows] = sides(i);
        let cells = (0..rows).flat_map(move |row| (0..columns).map(move |column| [column, row]));
        let places = [[0.0, 0.0], [0.5, 0.5], [0.9, 0.2], [0.1, 0.999]];
        cells
            .flat_map(move |[column, row]| {
                places.map(|[x, y]| {
                    [(column as f64 + x + 1e-12) / columns as f64, (row as f64 + y + 1e-12) / rows as f64]
                })
            })
            .chain([[1.0 - f64::EPSILON / 2.0; 2]])
    };
    let all = || (0..tables.len()).flat_map(|i| points(i).map(move |point| (i, point)));
    let right = |i: usize, point: [f64; 2]| {
        let [columns, rows] = sides(i);
        share_of(&tables[i], cell(point, &tables[i])) * (columns * rows) as f64
    };
    expect(all().any(|(i, point)| ask(i, point) != 0.0), "pdf-not-started", || {
        "`sample_table` is right. Now for `table_pdf`, which returns 0 for every point.".into()
    })?;
    let near = |a: f64, b: f64| (a - b).abs() <= ROUNDING * b.max(1.0);
    let Some((i, point)) = all().find(|&(i, point)| !near(ask(i, point), right(i, point))) else { return Ok(()) };
    let is_share = all().all(|(i, point)| near(ask(i, point), right(i, point) / (sides(i)[0] * sides(i)[1]) as f64));
    let (name, advice) = if is_share {
        ("pdf-is-a-share", "This is the share of the cell. Multiply it by the number of cells.")
    } else {
        (
            "wrong-pdf",
            "Find row and column of the point, by y and by x. The density is that of all points of this cell.",
        )
    };
    let [columns, rows] = sides(i);
    let centers = (0..rows).flat_map(|row| (0..columns).map(move |column| [column as f64 + 0.5, row as f64 + 0.5]));
    let sum: f64 = centers.map(|[x, y]| ask(i, [x / columns as f64, y / rows as f64])).sum();
    let integral = number(sum / (columns * rows) as f64);
    Err(Finding {
        tried: format!("`table_pdf` of {} at {}", words(i), list(&point)),
        got: format!("{}; over the square your density integrates to {integral}", about(ask(i, point))),
        expected: format!("{}; it must integrate to 1", about(right(i, point))),
        advice: advice.into(),
    }
    .named(name))
}

/// Column and row of a point.
fn cell([x, y]: [f64; 2], table: &Table) -> [usize; 2] {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to the number of cells")]
    [(x, table.columns[0].len()), (y, table.rows.len())].map(|(x, cells)| ((x * cells as f64) as usize).min(cells - 1))
}

/// A cell and where within, in widths of a cell.
fn along((cell, within): (usize, f64)) -> f64 {
    cell as f64 + within
}

/// Column and row, with parts of cells, as a place of the unit square.
fn place([x, y]: [f64; 2], table: &Table) -> [f64; 2] {
    [x / table.columns[0].len() as f64, y / table.rows.len() as f64]
}
