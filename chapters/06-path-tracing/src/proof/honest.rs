//! The picture's own error is honest: as many pixels lie within 3σ as should.

use crate::experiments::honest::measure;

#[test]
fn pixels_lie_within_their_three_sigma() {
    let pixels = measure(1000).unwrap();
    let share = f64::from(pixels.inside) / f64::from(pixels.all);
    println!("{:.2} % of {} pixels lie within 3σ", 100.0 * share, pixels.all);
    assert!((share - 0.997).abs() < 0.005, "{share}");
}
