//! The proof that the sampling functions do what they promise, and that the proof would notice if they did not.

mod chart;
mod chi_square;
mod inverses;
mod moments;
mod robust;
mod subjects;
mod wrong;
