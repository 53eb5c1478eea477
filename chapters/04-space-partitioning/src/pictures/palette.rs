//! The colors of the structures, the same in all plots and drawings.

use common::Rgb;

use crate::choice::Choice;

/// The grid: blue.
pub(super) const GRID_BLUE: Rgb = Rgb::new(0.15, 0.56, 1.0);
/// The octree: green.
pub(super) const OCTREE_GREEN: Rgb = Rgb::new(0.25, 0.75, 0.35);
/// The kd-tree: gold.
pub(super) const KD_TREE_GOLD: Rgb = Rgb::new(1.0, 0.56, 0.08);
/// Brute force: gray.
pub(super) const FORCE_GRAY: Rgb = Rgb::new(0.42, 0.44, 0.48);
/// What a ray meets: the light of the ray itself.
pub(super) const RAY: Rgb = Rgb::new(0.95, 0.95, 0.92);
/// What is wrong, lost or wasted: red.
pub(super) const RED: Rgb = Rgb::new(0.86, 0.09, 0.07);

/// The color of a structure.
pub(super) fn color(choice: Choice) -> Rgb {
    match choice {
        Choice::BruteForce | Choice::EightAtOnce => FORCE_GRAY,
        Choice::Grid => GRID_BLUE,
        Choice::Octree => OCTREE_GREEN,
        Choice::KdTree | Choice::MedianKdTree => KD_TREE_GOLD,
    }
}
