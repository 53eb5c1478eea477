//! Budgets: how many triangles each thing may have, and into how many steps its surface is cut for that.

/// A share of a number of triangles, rounded down: 700 are 0.7 of 1000.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "a budget need not be exact")]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "shares are from 0 to 1")]
pub fn share(triangles: u32, part: f32) -> u32 {
    (triangles as f32 * part) as u32
}

/// `i` of `n` equal steps from 0 to 1.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "a number of things or steps need not be exact")]
pub fn ratio(i: u32, n: u32) -> f32 {
    i as f32 / n.max(1) as f32
}

/// How many columns and rows a surface has with two triangles in each cell and about so many in all. There are `aspect`
/// times as many columns as rows, but never fewer than `least`.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "a budget need not be exact")]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "roots of budgets")]
pub fn grid(triangles: u32, aspect: f32, least: [u32; 2]) -> [u32; 2] {
    let cells = triangles / 2;
    let rows = ((cells as f32 / aspect).sqrt() as u32).max(least[1]);
    let columns = (cells / rows).max(least[0]);
    [columns, (cells / columns).max(least[1])]
}

/// How many things there are: as many as the budget pays for when each costs at least `cost`, within limits.
#[must_use]
pub fn number(triangles: u32, cost: u32, [least, most]: [u32; 2]) -> u32 {
    (triangles / cost.max(1)).clamp(least, most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_keeps_to_its_budget() {
        for triangles in [100, 1_000, 10_000, 1_000_000] {
            for aspect in [0.2, 1.0, 4.0] {
                let [columns, rows] = grid(triangles, aspect, [3, 2]);
                let made = 2 * columns * rows;
                assert!(made <= triangles && made * 10 > triangles * 8, "{made} of {triangles}");
            }
        }
        assert_eq!(grid(0, 1.0, [3, 2]), [3, 2]);
    }

    #[test]
    fn numbers_of_things() {
        assert_eq!([number(100, 30, [1, 9]), number(0, 30, [1, 9]), number(900, 30, [1, 9])], [3, 1, 9]);
        assert_eq!([share(1_000, 0.25), share(0, 0.5)], [250, 0]);
        assert_eq!(share(1_000, 0.7), 700);
        assert_eq!([ratio(1, 4), ratio(0, 0)], [0.25, 0.0]);
    }
}
