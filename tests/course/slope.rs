//! The slope of a straight line through points on axes with logarithms: the power that something grows with.

#![expect(clippy::disallowed_methods, reason = "f64 has digits to spare: its last bits do not matter here")]

/// The slope of the line that fits the points best, by least squares of the logarithms.
pub(crate) fn slope(points: &[(f64, f64)]) -> f64 {
    let points: Vec<_> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let n = points.len() as f64;
    let mean = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    mean(&|p| (p.0 - x) * (p.1 - y)) / mean(&|p| (p.0 - x) * (p.0 - x))
}

#[test]
fn the_slope_is_the_power() {
    let points = [1.0, 3.0, 10.0, 50.0].map(|x: f64| (x, 7.0 * x.powi(2)));
    assert!((slope(&points) - 2.0).abs() < 1e-12);
}
