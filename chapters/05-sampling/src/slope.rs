//! The order of a method: how fast its error falls as samples are added.

use common::float;

// ANCHOR: slope
/// The exponent `s` for which `error ≈ c · countˢ` fits best: the slope of the straight line through points
/// `[count, error]` on a log–log plot, by least squares.
///
/// Points that are not above 0 have no place on such a plot and are left out. `None` if fewer than two counts remain.
#[must_use]
pub fn log_log_slope(points: &[[f64; 2]]) -> Option<f64> {
    let logs = points.iter().filter(|p| p[0] > 0.0 && p[1] > 0.0).map(|p| p.map(float::ln_f64));
    let logs: Vec<[f64; 2]> = logs.collect();
    let mean = |axis: usize| logs.iter().map(|p| p[axis]).sum::<f64>() / logs.len() as f64;
    let [x, y] = [mean(0), mean(1)];
    let across: f64 = logs.iter().map(|p| (p[0] - x) * (p[0] - x)).sum();
    let along: f64 = logs.iter().map(|p| (p[0] - x) * (p[1] - y)).sum();
    (across > 0.0).then_some(along / across)
}
// ANCHOR_END: slope

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_have_their_exponent() {
        let inverse: Vec<_> = (1..20).map(|i| [f64::from(i), 7.0 / f64::from(i)]).collect();
        assert!((log_log_slope(&inverse).unwrap() + 1.0).abs() < 1e-12);
        let root: Vec<_> = (1..20).map(|i| [f64::from(i), 1.0 / f64::from(i).sqrt()]).collect();
        assert!((log_log_slope(&root).unwrap() + 0.5).abs() < 1e-12);
    }

    #[test]
    fn too_few_points_have_no_slope() {
        for points in [&[][..], &[[1.0, 1.0]], &[[2.0, 1.0], [2.0, 3.0]], &[[1.0, 1.0], [2.0, 0.0]]] {
            assert_eq!(log_log_slope(points), None, "{points:?}");
        }
    }
}
