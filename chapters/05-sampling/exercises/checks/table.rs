//! A table of weights, as exercise 5.5 has it.

/// Weights of a grid over the unit square, as cumulative distributions.
pub(crate) struct Table {
    /// That of the rows.
    pub(crate) rows: Vec<f64>,
    /// In each row, that of its columns.
    pub(crate) columns: Vec<Vec<f64>>,
}

impl Table {
    /// A table of the weights of all cells, row by row, with so many columns.
    pub(crate) fn new(cumulative: fn(&[f64]) -> Vec<f64>, columns: usize, weights: &[f64]) -> Self {
        let sums: Vec<f64> = weights.chunks(columns).map(|row| row.iter().sum()).collect();
        Self { rows: cumulative(&sums), columns: weights.chunks(columns).map(cumulative).collect() }
    }
}

/// The cumulative distribution, right.
pub(crate) fn cumulative_of(weights: &[f64]) -> Vec<f64> {
    let total: f64 = weights.iter().sum();
    let even = vec![1.0; weights.len()];
    let weights = if total > 0.0 { weights } else { &even };
    let mut sums: Vec<f64> = (0..weights.len()).map(|i| weights[..=i].iter().sum()).collect();
    let last = sums.last().copied().unwrap_or(1.0);
    sums.iter_mut().for_each(|sum| *sum /= last);
    sums
}

/// The sum before a cell.
pub(crate) fn before(cumulative: &[f64], cell: usize) -> f64 {
    cell.checked_sub(1).map_or(0.0, |cell| cumulative[cell])
}

/// The cell of a number and where within, right.
pub(crate) fn invert_of(cumulative: &[f64], u: f64) -> (usize, f64) {
    let cell = cumulative.iter().position(|sum| *sum > u).unwrap_or(cumulative.len() - 1);
    let before = before(cumulative, cell);
    (cell, (u - before) / (cumulative[cell] - before))
}

/// The share of a cell.
pub(crate) fn share_of(table: &Table, [column, row]: [usize; 2]) -> f64 {
    let columns = &table.columns[row];
    (table.rows[row] - before(&table.rows, row)) * (columns[column] - before(columns, column))
}

/// The point and the density of a point of the square, right.
pub(crate) fn sample_of(table: &Table, u: [f64; 2]) -> ([f64; 2], f64) {
    let (row, up) = invert_of(&table.rows, u[1]);
    let (column, along) = invert_of(&table.columns[row], u[0]);
    let [columns, rows] = [table.columns[row].len(), table.rows.len()];
    let point = [(column as f64 + along) / columns as f64, (row as f64 + up) / rows as f64];
    (point, share_of(table, [column, row]) * (columns * rows) as f64)
}
