//! The list of scenes as pictures, with what is to be seen on each.

use common::picture::Picture;

use super::scene::{heated, lit, shaded, steps};

/// Each scene in the light, in the order of the list of generators.
pub(super) const SHADED: [Picture; 9] = [
    shaded(
        "interior",
        "A reading room in the morning: sunlight falls from tall arched windows with rust-red curtains on the \
         left over a plank floor, a sand-colored rug, and one end of a long table with open books and reading \
         lamps with green shades; green padded chairs stand along both sides, brass lamps hang above, and \
         shelves of colored books cover the right and the far wall beside a large arched window.",
        lit::<0>,
    ),
    shaded(
        "court",
        "A court with two storeys of round arches on white columns around a chequered floor: the left side \
         stands in the sun, the right in shade; crimson, blue, and golden banners hang over the balustrades, \
         a fountain stands in the middle between small trees in pots, and a bell tower looks over the far \
         roof into a blue sky.",
        lit::<1>,
    ),
    shaded(
        "clearing",
        "At dusk a lantern with a burning candle stands on a round stone in a clearing. Red mushrooms circle \
         it, and around them is a ring of standing stones, lit warm on their inner sides. Grass with flowers \
         covers the ground, leafy trees with spreading roots stand all around, and behind them pale blue firs \
         vanish in the mist.",
        lit::<2>,
    ),
    shaded(
        "hair-ball",
        "A ball of copper, amber, and golden hairs, combed in whirls, floats before a blue-gray backdrop. \
         Light from behind makes a halo on the wall to its right, and its soft-edged shadow lies on the \
         floor.",
        lit::<3>,
    ),
    shaded(
        "plant",
        "A power plant in low sun: in the middle an open steel frame of many storeys, full of colored pipes, \
         with yellow railings and zigzag stairs, before it a long rack of pipes; white tanks on the left, \
         white spherical gas holders on yellow legs in front, and behind three red and white chimneys and \
         cooling towers.",
        lit::<4>,
    ),
    shaded(
        "square",
        "A village square in the sun: ochre, rose, cream, and clay houses with shutters, flower boxes, and \
         red tiled roofs stand around a paved square with a fountain; a large tree on the left and leaves at \
         the upper right frame it, strings of pennants cross above, ivy climbs the walls, and red chairs \
         stand around café tables under two cream parasols on the right.",
        lit::<5>,
    ),
    shaded(
        "sphere-flake",
        "A large blue ball carries nine teal balls, each of these nine amber ones, and each of those nine red \
         ones. They rest on a pale floor and cast a shadow with a lace-like edge.",
        lit::<6>,
    ),
    shaded(
        "mountain",
        "A steep mountain of gray-brown rock with snow on its ledges and summit rises between lower peaks \
         into a pale blue sky. The low sun comes from the left. Below are meadows, dark forest, and a blue \
         lake with a winding shore.",
        lit::<7>,
    ),
    shaded(
        "stadium",
        "A red teapot with an ivory handle and knob stands on the white halfway line of a football field, \
         throwing faint shadows in several directions. Behind it are the blue and white stands of a roofed \
         stadium and a floodlight mast, before a deep blue evening sky.",
        lit::<8>,
    ),
];

/// The cost of its rays, in the same order.
pub(super) const STEPS: [Picture; 9] = [
    steps(
        "interior-steps",
        "Three heat maps side by side of the steps that camera rays take in the grid, the octree and the kd- \
         tree, with the mean above each, on a common scale from dark blue for 4 over green and yellow to \
         nearly white for 4096. The reading room: the grid and the kd-tree are mostly teal, dearest around \
         the backs of the chairs and the plants; the octree is green to yellow, dearest along the floor \
         between the chairs.",
        heated::<0>,
    ),
    steps(
        "court-steps",
        "Three heat maps side by side of the steps that camera rays take in the grid, the octree and the kd- \
         tree, with the mean above each, on a common scale from dark blue for 4 over green and yellow to \
         nearly white for 4096. The arcaded court: the grid and the octree show bright blocks where many \
         moldings and leaves share a cell, along the walls and around the plants; in the kd-tree the walls \
         are an even blue and only the leaves stand out.",
        heated::<1>,
    ),
    steps(
        "clearing-steps",
        "Three heat maps side by side of the steps that camera rays take in the grid, the octree and the kd- \
         tree, with the mean above each, on a common scale from dark blue for 4 over green and yellow to \
         nearly white for 4096. The clearing: all three are dearest in the leaves and grass and cheapest on \
         stones and trunks; the octree is the brightest, and the grid shows large blocks.",
        heated::<2>,
    ),
    steps(
        "hair-ball-steps",
        "Three heat maps side by side of the steps that camera rays take in the grid, the octree and the kd- \
         tree, with the mean above each, on a common scale from dark blue for 4 over green and yellow to \
         nearly white for 4096. The ball of hair: in the grid whole blocks of orange and white hide the ball; \
         the octree shows it as a coarse heap of yellow cubes; in the kd-tree single hairs can be seen, green \
         with some yellow patches.",
        heated::<3>,
    ),
    steps(
        "plant-steps",
        "Three heat maps side by side of the steps that camera rays take in the grid, the octree and the kd- \
         tree, with the mean above each, on a common scale from dark blue for 4 over green and yellow to \
         nearly white for 4096. The power plant: in the grid the steel frame and the pipes are an orange \
         block, in the octree a green one with orange edges; in the kd-tree they are drawn in fine green \
         lines before blue.",
        heated::<4>,
    ),
    steps(
        "square-steps",
        "Three heat maps side by side of the steps that camera rays take in the grid, the octree and the kd- \
         tree, with the mean above each, on a common scale from dark blue for 4 over green and yellow to \
         nearly white for 4096. The village square: the grid is yellow to nearly white, dearest in the crown \
         of the tree; the octree is teal to green; the kd-tree is blue with the leaves in green.",
        heated::<5>,
    ),
    steps(
        "sphere-flake-steps",
        "Three heat maps side by side of the steps that camera rays take in the grid, the octree and the kd- \
         tree, with the mean above each, on a common scale from dark blue for 4 over green and yellow to \
         nearly white for 4096. The flake of spheres: in the grid large blocks around the balls are orange; \
         octree and kd-tree are blue to teal, with green seams around each ball, and the kd-tree is a little \
         darker.",
        heated::<6>,
    ),
    steps(
        "mountain-steps",
        "Three heat maps side by side of the steps that camera rays take in the grid, the octree and the kd- \
         tree, with the mean above each, on a common scale from dark blue for 4 over green and yellow to \
         nearly white for 4096. The mountain: all three are blue to teal; the silhouette is a brighter seam, \
         most in the octree, whose foreground is a green band.",
        heated::<7>,
    ),
    steps(
        "stadium-steps",
        "Three heat maps side by side of the steps that camera rays take in the grid, the octree and the kd- \
         tree, with the mean above each, on a common scale from dark blue for 4 over green and yellow to \
         nearly white for 4096. The teapot in the stadium: the grid is nearly white all over, only the \
         teapot's shape and a wedge below are a little darker; octree and kd-tree are blue on the lawn, with \
         a green seam around the teapot and the stands behind it brighter.",
        heated::<8>,
    ),
];
