//! Every cell of the furnace is right.

use crate::experiments::{
    furnace::{Glow, cells, measure, traced},
    is_right,
};

#[test]
fn every_cell_of_the_furnace_is_right() {
    for glow in [Glow::Whole, Glow::Half] {
        for cell in cells() {
            let (estimate, expected) = (measure(cell, glow, traced).unwrap(), cell.expected(glow));
            println!("{glow:?} {cell:?}: {:.4} ± {:.4}, {expected:.4}", estimate.mean(), estimate.three_sigma());
            assert!(is_right(&estimate, expected), "{glow:?} {cell:?}: {estimate:?}, not {expected}");
        }
    }
}
