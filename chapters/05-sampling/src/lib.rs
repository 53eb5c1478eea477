//! Chapter 5, sampling: integrals by chance, and directions with a density.
//!
//! Each idea of the chapter has a file of its own, named after it. What is measured of them is in [`experiments`].

pub const CHAPTER: common::picture::Chapter = common::picture::Chapter {
    number: 5,
    name: "sampling",
    title: "Monte Carlo sampling",
    pictures: &[],
    reports: &[],
};
