//! The error falls like 1/√M, over 1 to 4096 samples.

use sampling::slope::log_log_slope;

use crate::experiments::slope::measure;

#[test]
fn the_error_falls_with_slope_one_half() {
    let points = measure(if super::long_run() { 8192 } else { 1024 }).unwrap();
    let slope = log_log_slope(&points).unwrap();
    println!("slope of the error: {slope:.4}");
    assert!((slope + 0.5).abs() < 0.02, "{slope}: {points:?}");
}
