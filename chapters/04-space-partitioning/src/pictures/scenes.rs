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
        "The reading room as three heat maps of the steps that each camera ray takes: left in the grid, in the middle in the octree, \
         right in the kd-tree, with the mean above each. A common scale below goes from dark blue for none over green \
         and yellow to nearly white for 200 or more.",
        heated::<0>,
    ),
    steps(
        "court-steps",
        "The arcaded court as three heat maps of the steps that each camera ray takes: left in the grid, in the middle in the octree, \
         right in the kd-tree, with the mean above each. A common scale below goes from dark blue for none over green \
         and yellow to nearly white for 200 or more.",
        heated::<1>,
    ),
    steps(
        "clearing-steps",
        "The clearing as three heat maps of the steps that each camera ray takes: left in the grid, in the middle in the octree, \
         right in the kd-tree, with the mean above each. A common scale below goes from dark blue for none over green \
         and yellow to nearly white for 200 or more.",
        heated::<2>,
    ),
    steps(
        "hair-ball-steps",
        "The ball of hair as three heat maps of the steps that each camera ray takes: left in the grid, in the middle in the octree, \
         right in the kd-tree, with the mean above each. A common scale below goes from dark blue for none over green \
         and yellow to nearly white for 200 or more.",
        heated::<3>,
    ),
    steps(
        "plant-steps",
        "The power plant as three heat maps of the steps that each camera ray takes: left in the grid, in the middle in the octree, \
         right in the kd-tree, with the mean above each. A common scale below goes from dark blue for none over green \
         and yellow to nearly white for 200 or more.",
        heated::<4>,
    ),
    steps(
        "square-steps",
        "The village square as three heat maps of the steps that each camera ray takes: left in the grid, in the middle in the octree, \
         right in the kd-tree, with the mean above each. A common scale below goes from dark blue for none over green \
         and yellow to nearly white for 200 or more.",
        heated::<5>,
    ),
    steps(
        "sphere-flake-steps",
        "The flake of spheres as three heat maps of the steps that each camera ray takes: left in the grid, in the middle in the octree, \
         right in the kd-tree, with the mean above each. A common scale below goes from dark blue for none over green \
         and yellow to nearly white for 200 or more.",
        heated::<6>,
    ),
    steps(
        "mountain-steps",
        "The mountain as three heat maps of the steps that each camera ray takes: left in the grid, in the middle in the octree, \
         right in the kd-tree, with the mean above each. A common scale below goes from dark blue for none over green \
         and yellow to nearly white for 200 or more.",
        heated::<7>,
    ),
    steps(
        "stadium-steps",
        "The teapot in the stadium as three heat maps of the steps that each camera ray takes: left in the grid, in the middle in the octree, \
         right in the kd-tree, with the mean above each. A common scale below goes from dark blue for none over green \
         and yellow to nearly white for 200 or more.",
        heated::<8>,
    ),
];
