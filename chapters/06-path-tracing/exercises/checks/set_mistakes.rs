//! Likely mistakes with the points of a pixel: what they are called, and what to say about them.

/// The name of a mistake, and what to say.
pub(super) type Mistake = (&'static str, &'static str);

pub(super) const N_SAMPLES: Mistake =
    ("n-samples", "These are as many samples as one row of the grid has cells. The grid has n rows of n cells.");
pub(super) const WRONG_COUNT: Mistake =
    ("wrong-count", "Each cell of the grid gives one sample: n·n of them, no more and no fewer.");
pub(super) const OUTSIDE: Mistake = (
    "outside",
    "This point lies outside of the unit square. `stratified` gives points of the square already: neither scale nor move them.",
);
pub(super) const CELL_TWICE: Mistake = (
    "cell-twice",
    "Some cell has more than one point, and another none. Each set must be stratified by itself, the directions as well as the \
     places in the pixel: it is what `stratified` gives, only in another order.",
);
pub(super) const SAME_IN_EVERY_PIXEL: Mistake = (
    "same-in-every-pixel",
    "All pixels would get the same points, and so all of them would err in the same way. That is no grain but a veil over the \
     whole picture. Take all random numbers from `random`.",
);
pub(super) const SAME_SHUFFLE: Mistake = (
    "same-shuffle",
    "The same cells always go together. Directions of other cells are never tried with that part of the pixel, so the picture \
     is wrong on average. Both sets of directions need a shuffle of their own.",
);
pub(super) const SAME_ORDER_IN_EVERY_PIXEL: Mistake = (
    "same-order-in-every-pixel",
    "The order is the same in every pixel, so that a cell always goes with the same other cell. Take a new order from `random` \
     for each pixel and each set.",
);
pub(super) const NOT_INDEPENDENT: Mistake = (
    "not-independent",
    "Some pairs of cells come more often than others. `shuffle` each of the two sets of directions, each by itself.",
);
pub(super) const ROTATED: Mistake = (
    "only-rotated",
    "The set is only moved along: neighbors stay neighbors, and gaps of the one set meet gaps of the other. Use `shuffle`.",
);
pub(super) const NOT_UNIFORM: Mistake = (
    "not-uniform",
    "Not every place in a cell is as likely as any other. `stratified` gives points that are right already.",
);
pub(super) const SAME_PLACE: Mistake = (
    "same-place-in-every-cell",
    "All points lie at the same place of their cells. `stratified` gives points that lie anywhere in them.",
);
pub(super) const IN_COMMON: Mistake = (
    "points-in-common",
    "Two sets have the same points, only in another order. What one misses the other misses, too. Call `stratified` once for each      set.",
);
pub(super) const ALIKE: Mistake = (
    "offsets-alike",
    "The places of two numbers in their cells go together. Call `stratified` once for each set, so that each has random numbers \
     of its own.",
);
